//! Of the motion that a case gives.

use super::Texts;

pub const TEXTS: Texts = &[
    ("The motion that comes in", "输入地震动"),
    ("acceleration along {axis}", "{axis} 向加速度"),
    ("acceleration", "加速度"),
    ("velocity", "速度"),
    ("displacement", "位移"),
    ("motion.csv holds no motion.", "motion.csv 中没有地震动。"),
    ("Velocity and displacement that come in", "输入的速度与位移"),
    (
        "The same motion, integrated. Velocity and displacement should end near zero; the model follows any drift.",
        "同一地震动积分所得。速度与位移在结束时应接近零；若有漂移，模型将随之整体移动。",
    ),
    ("{peak} along {axis}", "{axis} 向 {peak}"),
    (", ", "、"),
    (
        "As the case gives it, windowed, filtered and turned into the model's axes; largest {peaks}.",
        "算例给定的地震动，经截取、滤波并转至模型坐标轴；最大值：{peaks}。",
    ),
    ("Nothing comes in along {axes}.", "沿 {axes} 无输入。"),
    (
        "It is taken as {kind}: the wave that comes up through the base is {factor} times this.",
        "按{kind}处理：自底部入射的上行波为其 {factor} 倍。",
    ),
    // Of a record that was deconvolved.
    ("the layers of motion.site", "motion.site 给定的地层"),
    ("the model's own ground at its corner {corner}", "模型自身在角点 {corner} 处的地层"),
    ("{depth}\u{a0}m below the surface of {ground}", "{ground}地表以下 {depth}\u{a0}m 处"),
    ("on the surface of {ground}", "{ground}的地表"),
    (
        "Recorded {place}; the wave that comes up through the base is deconvolved from it: at each frequency the record over what \
         linear layers make of a vertical wave at that place.",
        "记录取自{place}；自底部入射的上行波由其反演（反卷积）得到：逐频率将记录除以线性层状地层中竖向入射波在该处的传递函数。",
    ),
    (
        " That place moves {at_rest} times the incident wave at low frequency and, of all that is let through, at least {least} \
         times, at {least_at}\u{a0}Hz; the record is wanted up to {band}\u{a0}Hz.",
        "该处运动在低频时为入射波的 {at_rest} 倍；在通过的频率中最小为 {least} 倍，位于 {least_at}\u{a0}Hz；记录所需频带为 {band}\u{a0}Hz 以下。",
    ),
    (
        " The record comes {lead} later than in its file: the wave takes time from the base to its place, and what fades out \
         rings before it as well.",
        " 记录比文件中晚 {lead}：波从底边传到该处需要时间，而淡出的频率成分在其之前也有振荡。",
    ),
    (
        " Above {reach}\u{a0}Hz, where too little of the wave moves that place, the record fades out: at most {left_out} of a \
         component's ∫a²\u{a0}dt is left out.",
        "{reach}\u{a0}Hz 以上入射波在该处引起的运动过小，记录逐渐滤去：各分量舍去的部分至多占其 ∫a²\u{a0}dt 的 {left_out}。",
    ),
    (
        " Its layers have the moduli and the damping that go with the strain of the record: layer {number} from the surface, the \
         softest, shears by {strain} and is left with {modulus} of its modulus.",
        "各土层采用与记录应变相应的模量与阻尼：自地表起第 {number} 层软化最多，剪应变达 {strain}，模量降至其 {modulus}。",
    ),
    // Of waves at angles.
    ("east", "东"),
    ("north", "北"),
    ("up", "上"),
    ("{factor} × {component}", "{factor} × {component}"),
    ("{factor} × {component}, turned by {phase}° in phase", "{factor} × {component}，相位转 {phase}°"),
    ("{angle}° from the vertical towards {azimuth}°", "与竖直方向成 {angle}°，方位 {azimuth}°"),
    ("; its field goes along the ground with {velocity}", "；沿地面的视速度为 {velocity}"),
    (
        "; beyond a critical angle, or turned in phase: the field fades in before the wave comes",
        "；超过临界角或相位已转：波到达之前场逐渐淡入",
    ),
    ("{kind} wave", "{kind} 波"),
    (
        "It is carried by plane waves at angles ({waves}), which come {lead} later than in the record so that nothing moves before.",
        "它由斜入射平面波（{waves}）携带，比记录晚 {lead} 到达，此前模型不动。",
    ),
    (" Nothing of the record is left out.", "记录未舍去任何成分。"),
    ("{a} and {b}", "{a} 与 {b}"),
    ("frequency", "频率"),
    ("transfer.csv holds no motion.", "transfer.csv 中没有运动。"),
    ("From the incident wave to the place of the record", "入射波至记录位置的传递函数"),
    ("motion where the record was taken over incident wave, amplitude", "记录位置的运动与入射波之比（幅值）"),
    ("5 % of the value at low frequency: nothing is inverted below", "低频值的 5 %：低于此值不作反演"),
    ("wanted up to {frequency}\u{a0}Hz", "所需频带至 {frequency}\u{a0}Hz"),
    ("fades out from {frequency}\u{a0}Hz", "自 {frequency}\u{a0}Hz 起逐渐滤去"),
    (
        "Amplitude by frequency, of theory: vertical waves through linear layers, damping included (Kramer 1996, section 7.2.1). The \
         record over it is the wave that comes in. Where it is small, hardly anything of the wave moves that place, and the wave is \
         so many times the record, errors of the record included. Numbers: transfer.csv.",
        "理论幅值随频率的变化：竖向传播的波通过线性层状地层，计入阻尼（Kramer 1996，第 7.2.1 节）。记录除以它即为入射波。\
         其值小处，入射波几乎不引起该处运动，由记录反演时记录及其误差均被相应放大。数值见 transfer.csv。",
    ),
    ("The record, and the computed motion where it was taken", "记录与其位置处的计算结果"),
    ("velocity along {axis}", "{axis} 向速度"),
    ("record", "记录"),
    ("free field where it was taken", "记录位置处的自由场"),
    (
        "Broad is the record on the time of the run, thin how the free field moved at its place: the layered ground beside the model, \
         into which the wave went. The thin line should lie on the broad one.",
        "粗线为换算到计算时间的记录，细线为该处自由场的运动，即入射波传入模型旁的层状地层后的结果。细线应与粗线重合。",
    ),
    (
        " They differ by at most {share} of the record's peak (check 'computed motion at the record's place against the record').",
        "两者最多相差记录峰值的 {share}（见检查项“记录在其观测位置的再现”）。",
    ),
    (
        " Differences come from the mesh, from rock that yields, or from what was left out above the record's band.",
        "差别来自网格、围岩屈服，或记录频带以上被舍去的成分。",
    ),
];
