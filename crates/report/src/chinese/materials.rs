//! Of the tables of materials.

use super::Texts;

pub(super) const TEXTS: Texts = &[
    (".", "。"),
    ("{count} elements, reduced integration", "{count} 个单元，减缩积分"),
    ("{count} elements, full integration", "{count} 个单元，完全积分"),
    ("{count} elements, layered", "{count} 个单元，沿厚度分层积分"),
    ("{count} elements, {kind}", "{count} 个单元，{kind}"),
    ("{least} to {most}", "{least} 至 {most}"),
    (
        "Rayleigh, {mass} 1/s of the mass and {stiffness} s of the stiffness: {at_1} % at 1 Hz, {at_10} % at 10 Hz",
        "瑞利阻尼：质量系数 {mass} s⁻¹，刚度系数 {stiffness} s；阻尼比 1 Hz 时 {at_1} %，10 Hz 时 {at_10} %",
    ),
    (
        "{ratio} % over {low} to {high} Hz by three Maxwell bodies",
        "{low} 至 {high} Hz 频带内 {ratio} %，由三个 Maxwell 体实现",
    ),
    ("E is that of slow loading", "E 对应缓慢加载"),
    ("E is meant at {frequency} Hz", "E 对应 {frequency} Hz"),
];

/// What laws are and what their parameters and derived values mean, as the crate of the laws has it; of what the page cuts
/// short behind a semicolon the first part.
pub const LAWS: Texts = &[
    ("linear isotropic elasticity", "线性各向同性弹性"),
    (
        "rock, Mohr–Coulomb with tension cut-off, dilation and softening",
        "岩体，Mohr–Coulomb 准则，含抗拉截断、剪胀与软化",
    ),
    (
        "rock mass, generalised Hoek–Brown (2002) with tension cut-off",
        "岩体，广义 Hoek–Brown 准则（2002），含抗拉截断",
    ),
    ("rock, Drucker–Prager cone with a limit on mean tension", "岩体，Drucker–Prager 锥面，限制平均拉应力"),
    ("concrete, rate-dependent damage separate in tension and shear", "混凝土，率相关损伤，拉伸与剪切分别计"),
    ("joint of constant stiffness with bond and Coulomb friction", "常刚度接触面，含粘结与 Coulomb 摩擦"),
    ("joint with a hyperbolic closure, bond and Coulomb friction", "双曲线闭合接触面，含粘结与 Coulomb 摩擦"),
    ("Young's modulus E", "弹性模量 E"),
    (
        "share of a pressure all round that water takes where it cannot leave",
        "Skempton 系数 B：不排水时孔隙水承担的各向等压份额",
    ),
    ("K + α²M, with water that cannot leave its pores", "不排水体积模量 K_u = K + α²M"),
    ("speed of P waves where water was in the pores as the earthquake began", "地震开始时含水处的纵波波速"),
    (
        "c_v of the water in its pores: a pressure goes √(c_v T) far in the time T",
        "孔隙水的固结系数 c_v：孔压在时间 T 内传播 √(c_v T)",
    ),
    ("Poisson's ratio ν, from 0 up to below 0.5", "泊松比 ν，自 0 至 0.5 以下"),
    (
        "E of the law beside the Maxwell bodies, for slow loading: thresholds f_t/E and limits of size go by it",
        "与 Maxwell 体并联的本构的 E，用于缓慢加载：阈值 f_t/E 与尺寸限值以此计算",
    ),
    // Rock.
    ("cohesion c, zero or more", "黏聚力 c，不小于零"),
    ("friction angle φ, from 0 up to 89.9°", "内摩擦角 φ，自 0 至 89.9°"),
    ("dilation angle ψ, from 0 up to φ", "剪胀角 ψ，自 0 至 φ"),
    ("dilation angle ψ, from 0 up to 89.9°", "剪胀角 ψ，自 0 至 89.9°"),
    ("tension cut-off f_t, zero or more", "抗拉截断 f_t，不小于零"),
    (
        "strength against plastic displacement or strain: columns with a number a row, straight lines between rows",
        "强度随塑性位移或塑性应变的变化：各列每行一个数，行间线性插值",
    ),
    ("time in which stress beyond the strength relaxes", "超出强度的应力的松弛时间"),
    ("τ μ/|H|", "τ μ/|H|"),
    (
        "the rock mass after a slip: m_b, s and a change along straight lines to those of its GSI and D",
        "滑移后的残余岩体：m_b、s、a 随滑移线性变化至残余 GSI 与 D 的值",
    ),
    (
        "extent that elements must stay below, or they give out energy as they soften",
        "单元尺寸上限，超过则软化时释放能量",
    ),
    ("m_b of the residual state", "残余状态的 m_b"),
    ("s of the residual state", "残余状态的 s"),
    ("a of the residual state", "残余状态的 a"),
    ("2c cos φ/(1 − sin φ), uniaxial, at the peak", "2c cos φ/(1 − sin φ)，峰值单轴抗压强度"),
    ("k = (1 + sin φ)/(1 − sin φ)", "k = (1 + sin φ)/(1 − sin φ)"),
    ("c/tan φ, all-round tension that the envelope allows", "c/tan φ，包络线允许的各向等拉应力"),
    ("f_t in use, not beyond the apex", "实际采用的 f_t，不超过顶点"),
    ("σ_ci, uniaxial compressive strength of the intact rock", "σ_ci，完整岩石单轴抗压强度"),
    (
        "GSI, geological strength index, from 5 to 100 (intact), e.g. 55",
        "GSI，地质强度指标，自 5 至 100（完整），例如 55",
    ),
    ("m_i of the intact rock, positive", "完整岩石的 m_i，大于零"),
    (
        "D, from 0 (undisturbed) to 1 (heavy blasting or stress relief)",
        "D，自 0（未扰动）至 1（强爆破或应力释放）",
    ),
    ("m_i exp[(GSI − 100)/(28 − 14D)]", "m_i exp[(GSI − 100)/(28 − 14D)]"),
    ("exp[(GSI − 100)/(9 − 3D)]", "exp[(GSI − 100)/(9 − 3D)]"),
    ("½ + (e^(−GSI/15) − e^(−20/3))/6", "½ + (e^(−GSI/15) − e^(−20/3))/6"),
    ("σ_ci s^a, of the rock mass", "σ_ci s^a，岩体抗压强度"),
    ("s σ_ci/m_b, all-round tension that the envelope allows", "s σ_ci/m_b，包络线允许的各向等拉应力"),
    (
        "where the cone meets Mohr–Coulomb's pyramid, or direct for q_phi and k_phi",
        "锥面与 Mohr–Coulomb 棱锥的相接位置，或用 direct 直接给定 q_phi 与 k_phi",
    ),
    ("q_φ, slope of √J₂ over the mean", "q_φ，√J₂ 对平均应力的斜率"),
    ("k_φ, √J₂ at no mean stress", "k_φ，平均应力为零时的 √J₂"),
    ("q_ψ, from 0 up to q_φ", "q_ψ，自 0 至 q_φ"),
    ("largest mean stress f_t, zero or more", "最大平均应力 f_t，不小于零"),
    ("q_ψ of the flow", "流动法则的 q_ψ"),
    ("k_φ/q_φ, mean tension that the cone allows", "k_φ/q_φ，锥面允许的平均拉应力"),
    ("f_t in use, limit of the mean, not beyond the apex", "实际采用的 f_t，为平均应力限值，不超过顶点"),
    // Concrete.
    ("grade of Model Code 2010", "Model Code 2010 的混凝土强度等级"),
    ("static uniaxial tensile strength f_t", "静态单轴抗拉强度 f_t"),
    (
        "cohesion c, in place of compressive_strength: f_c = 2 c cos φ/(1 − sin φ)",
        "黏聚力 c，代替 compressive_strength：f_c = 2 c cos φ/(1 − sin φ)",
    ),
    (
        "static uniaxial compressive strength f_c, in place of the cohesion",
        "静态单轴抗压强度 f_c，代替黏聚力",
    ),
    (
        "α, residual strength over f_t after cracking (evolution = residual alone), above 0 up to 1",
        "α，开裂后残余强度与 f_t 之比（仅 evolution = residual），大于 0、不大于 1",
    ),
    (
        "β, residual strength over the peak in shear, above 0 up to 1",
        "β，剪切残余强度与峰值之比，大于 0、不大于 1",
    ),
    (
        "ε_us/ε_ts, ultimate over threshold strain in tension (evolution = residual), above 1",
        "ε_us/ε_ts，受拉极限应变与阈值应变之比（evolution = residual），大于 1",
    ),
    ("G_f, energy per area of a crack", "G_f，单位面积裂缝的断裂能"),
    ("softening in tension: plateau or crack band", "受拉软化方式：平台或裂缝带"),
    ("how strength grows with the rate of strain", "强度随应变率的增长方式"),
    (
        "ε̇_s, rate of strain below which strength is static (not with rate = none)",
        "ε̇_s，低于此应变率时取静态强度（rate = none 时不用）",
    ),
    (
        "τ, time over which rates are averaged (not with rate = none)",
        "τ，应变率的平均时间（rate = none 时不用）",
    ),
    ("what drives tension: strains or effective stresses", "受拉损伤的驱动量：应变或有效应力"),
    (
        "tension across a crack in the shear criterion: what the crack carries, or the effective stress as printed (split = effective alone: split = compliance tests what the point carries)",
        "剪切准则中横跨裂缝的拉应力：裂缝实际承担的应力，或文献所印的有效应力（仅 split = effective：split = compliance 检验该点实际承担的应力）",
    ),
    ("how damage enters the stress", "损伤作用于应力的方式"),
    ("f_c, static", "f_c，静态"),
    ("f_t, static", "f_t，静态"),
    ("N = (1 + sin φ)/(1 − sin φ)", "N = (1 + sin φ)/(1 − sin φ)"),
    ("ε_ts = f_t/E, at which tension cracks", "ε_ts = f_t/E，受拉开裂应变"),
    (
        "G_f of a crack across the shortest to longest extent of the elements",
        "裂缝横穿单元最短至最长尺寸时的 G_f",
    ),
    (
        "G_f of Model Code 2010 by f_c, 73 f_c^0.18 with f_c in MPa, since none is given",
        "按 Model Code 2010 由 f_c 得出的 G_f，73 f_c^0.18（f_c 以 MPa 计），因未给出",
    ),
    ("ε_us/ε_ts", "ε_us/ε_ts"),
    ("ε_us, beyond which nothing is carried", "ε_us，超过后不再承载"),
    ("ε_us/ε_ts, by the element's extent", "ε_us/ε_ts，随单元尺寸"),
    ("ε_us, beyond which nothing is carried, by the element's extent", "ε_us，超过后不再承载，随单元尺寸"),
    (
        "ε_f, over which strength falls to 1/e, by the element's extent",
        "ε_f，强度降至 1/e 的应变，随单元尺寸",
    ),
    ("2 G_f E/f_t², extent that elements must stay below", "2 G_f E/f_t²，单元尺寸必须小于此值"),
    ("ε̇_s, in tension and in shear", "ε̇_s，受拉与受剪"),
    ("of f_t over ε̇/ε̇_s", "f_t 对 ε̇/ε̇_s 的指数"),
    ("of f_c over ε̇/ε̇_s", "f_c 对 ε̇/ε̇_s 的指数"),
    // Interfaces.
    ("normal stiffness per area k_n", "单位面积法向刚度 k_n"),
    ("shear stiffness per area k_t", "单位面积切向刚度 k_t"),
    (
        "normal stiffness per area k_n0 of the closed, unloaded joint",
        "闭合未加载接触面的单位面积法向刚度 k_n0",
    ),
    ("largest closure T, at which the hyperbola ends", "最大闭合量 T，双曲线在此终止"),
    ("ν of k_t = k_n/(2(1 + ν))", "k_t = k_n/(2(1 + ν)) 中的 ν"),
    (
        "k_t from k_n at the present closure (the paper), or from k_n0",
        "k_t 由当前闭合量下的 k_n 计算（论文），或由 k_n0 计算",
    ),
    (
        "share 1 + g/T of the closure that is left where the curve goes straight, at p = k_n0 T (1/φ − 1)",
        "曲线转为直线处剩余闭合量的份额 1 + g/T，此时 p = k_n0 T (1/φ − 1)",
    ),
    (
        "pressure p* from which on the curve goes straight, so that no state is stiffer than the time step counts",
        "曲线自此转为直线的压力 p*，使任何状态都不比时间步长所计的更刚",
    ),
    ("cohesion c of the bond", "粘结的黏聚力 c"),
    ("tension f_bond at which the bond breaks", "粘结断裂的拉应力 f_bond"),
    ("coefficient of friction μ", "摩擦系数 μ"),
];
