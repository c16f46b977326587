//! Of the checks of a run: waves, energy, stages, materials.

use super::Texts;

pub const TEXTS: Texts = &[
    // Before the earthquake.
    (
        "work dissipated by relaxation damping over work of the prescribed displacements",
        "趋于静止过程中阻尼所耗功与各阶段移动所做功之比",
    ),
    ("no stage moved anything", "没有阶段移动任何部位"),
    ("no stage moved anything twice", "没有部位被移动两次"),
    ("share of the first loading step's work that was dissipated", "首个移动步的功中被材料耗散的比例"),
    (
        "the first step should be elastic: what later steps lose is counted beyond what it did, and a peak within a step is cut; take more `steps`",
        "首步应为弹性：其后各步的损失以首步为基准，步内的峰值会被削去；请增大 `steps`",
    ),
    ("largest share of the stored energy released in one step", "单步瞬间释放的能量占所储能量的最大比例"),
    (
        "in the stage '{stage}': the specimen snapped back there, and the force fell along no states at rest",
        "在阶段“{stage}”：试件在此回跳，力的下降未经过静止状态",
    ),
    (
        "what is moved too fast for a mesh pulls harder than at rest, and cracks beside its crack: more `release_cycles`, of which a \
         step that moves nodes takes five times as many",
        "移动速度对该网格过快时，拉力大于静止值，并在裂缝旁再次开裂：请增大 `release_cycles`，移动节点的步取其五倍",
    ),
    (
        "unreleased force after the last stage over all forces",
        "最后施工阶段结束时除自重、荷载与支座反力外仍被约束的力与全部贡献之比",
    ),
    (
        "change of the initial stress by the initial equilibrium, relative",
        "达到平衡过程中初始应力的变化与初始应力之比",
    ),
    (
        "largest change of an element's initial stress by the initial equilibrium, relative",
        "达到平衡过程中单元初始应力的最大变化与初始应力之比",
    ),
    (
        "largest relative displacement across an element or interface, initial equilibrium over stages",
        "达到初始平衡时单元内或接触面两侧位移差的最大值与各施工阶段之比",
    ),
    ("at {place}; {remedy}", "位于 {place}；{remedy}"),
    (
        "at {place}, over the mean of all where its own is less; {remedy}",
        "位于 {place}；其初始应力小于平均值处以平均值为基准；{remedy}",
    ),
    ("{what}, beside interface '{name}'", "{what}，位于接触面“{name}”旁"),
    (
        "displacement of the initial equilibrium over that of the stages",
        "达到初始平衡的位移与各施工阶段位移之比",
    ),
    ("there are no stages before the earthquake", "地震前没有施工阶段"),
    ("no stage came to rest", "没有阶段达到静止"),
    (
        "what stages have not let go stays held in the shaking: end with a stage whose `release` is 1",
        "各阶段未释放的部分在地震过程中仍被约束：请以 `release` 为 1 的阶段结束",
    ),
    ("not all stages are done", "尚有阶段未完成"),
    ("no stage that came to rest excavates", "已达静止的阶段中没有开挖"),
    (
        "integrated over what stands; {imbalance} of all forces were out of balance at first; {remedy}",
        "在现存部分上积分；起初不平衡力占全部力的 {imbalance}；{remedy}",
    ),
    ("the ground begins without stress", "地层初始无应力"),
    (
        "the initial stress is out of balance where it differs from the weight above, or from what the rock can bear: look at `lateral`, `stress` or `overburden`; on slopes and beside layers some is right",
        "初始应力与上覆自重不符或超出岩体承载能力之处不平衡：请检查 `lateral`、`stress` 或 `overburden`；在坡面处和岩层交界附近，少量不平衡是正常的",
    ),
    ("plastic shear strain at the initial equilibrium, integrated", "初始平衡时塑性剪应变的体积积分"),
    ("rock that yields under the initial stress alone", "初始应力本身即使其屈服的岩体"),
    ("out-of-balance force over all forces, worst stage", "不平衡力与全部贡献之比，取各阶段最大值"),
    (
        "each stage continues until this is below `initial.tolerance` and little motion remains",
        "每个阶段计算至该值低于 `initial.tolerance` 且剩余位移很小为止",
    ),
    (
        "of {pairs} that are there from the start: they slid or opened on the way to the initial equilibrium",
        "共 {pairs} 对自始存在：它们在达到初始平衡的过程中滑移或张开",
    ),
    ("interface pairs whose strength the initial stress exceeds", "初始应力超过其强度的接触面节点对"),
    ("largest displacement in 100 steps without motion", "无输入运动的 100 步内的最大位移"),
    (
        "all forces at rest are held, so only round-off moves the model",
        "各部分静止时的作用力均被平衡，因此除舍入误差外没有运动",
    ),
    // The step.
    ("time step over stable step", "时间步长与稳定步长之比"),
    (
        "set by {set_by}; the estimate changed by {change} in the last of {iterations} iterations",
        "控制因素：{set_by}；在 {iterations} 次迭代的最后一次中估计值变化 {change}",
    ),
    ("stable step with artificial viscosity over that without", "稳定步长与不计人工黏性的稳定步长之比"),
    (
        "artificial viscosity damps the ringing of pieces between cracks and costs a share of the step",
        "人工黏性抑制裂缝之间碎块的高频振荡，代价是步长有所减小",
    ),
    // Waves.
    ("elements per shortest wavelength", "最短波长内的单元数（每波长单元数）"),
    ("no wave comes in", "没有波输入"),
    ("with waves at angles the free field is the theory itself", "斜入射波的自由场本身即为理论解"),
    (
        "shear waves of {frequency} Hz (99.9 % of the input's energy lies below) along the longest edge of {element}",
        "频率 {frequency} Hz（输入能量的 99.9 % 在此频率以下）的剪切波，沿{element} 的最长边",
    ),
    ("residual displacement of the input over its peak", "输入位移的终值与峰值之比"),
    (
        "a large value is drift of the record, which the model follows: put \"baseline\" last in motion.processing, behind filter and taper",
        "数值大说明记录存在漂移，模型将随之整体移动：请在 motion.processing 中将 \"baseline\" 放在滤波与端部渐变（taper）之后，作为最后一步",
    ),
    ("free field against one-dimensional theory", "自由场与自由场理论解之差"),
    ("motion at the model's corners against the free field", "模型角部与自由场之差"),
    ("computed motion at the record's place against the record", "记录在其观测位置的再现"),
    (
        "it was recorded on the layers of motion.site, not on the model's ground",
        "记录取自模型以外的地层，即 motion.site 给定的地层",
    ),
    (
        "velocity of the free field where the record was taken against the motion given, over its peak in the rows: what differs is \
         the mesh's, or of rock that yields, or of what was left out above the record's band",
        "记录位置处自由场的速度与给定运动之差，除以其在各行中的峰值：差别来自网格、围岩屈服，或记录频带以上被舍去的成分",
    ),
    ("there is no reference column: {reason}", "没有参考自由场柱：{reason}"),
    (
        "cannot be checked, since {why}; and sides that are not periodic may spoil the free field",
        "无法检查，原因：{why}；并且非周期性侧边界可能破坏自由场",
    ),
    ("no row was written", "没有写出任何数据行"),
    (
        "theory is of ground that hangs together, and an interface runs through every column",
        "理论解针对连续的地层，而每根自由场柱都有接触面穿过",
    ),
    (
        "the rock of every column can yield or crack, and the theory is elastic",
        "每根自由场柱的岩体都屈服或开裂，而理论解是弹性的",
    ),
    (
        "an equivalent-linear column of the same laws has at most {theory} at its surface, column '{column}' {run} in the rows; its layers shear by up to {strain}",
        "由相同本构求得的一维等效线性土层地表最大 {theory}，自由场柱“{column}”在各行中最大 {run}；其各层剪应变最大 {strain}",
    ),
    (
        "nor is there an equivalent-linear column, since a layer of it would shear by {strain}, beyond {most}",
        "也没有一维等效线性土层：其中一层的剪应变将达 {strain}，超过 {most}",
    ),
    (
        "nor is there an equivalent-linear column, since no moduli fit the strain that they lead to",
        "也没有一维等效线性土层：找不到与其应变相符的模量",
    ),
    (
        "nor is there an equivalent-linear column, since a law of this ground has no curves of modulus and damping against strain",
        "也没有一维等效线性土层：该地层的某个本构没有模量与阻尼随应变的曲线",
    ),
    ("the rows of the histories are too few to show the wave", "时程的数据行太少，不足以反映该波"),
    (
        "velocity at the base of column '{column}' against one-dimensional theory of its layers, damping included",
        "自由场柱“{column}”底部的速度与其各层一维理论解（计入阻尼）之差",
    ),
    (
        "velocity at the top of column '{column}' against one-dimensional theory of its layers, damping included",
        "自由场柱“{column}”顶部的速度与其各层一维理论解（计入阻尼）之差",
    ),
    ("{end}; the worst of all {all} columns", "{end}；{all} 根自由场柱中的最大差值"),
    (
        "{end}; the worst of {shown} columns of {all}, since the others yield, crack, are cut by an interface, or show no wave in the rows",
        "{end}；{all} 根自由场柱中 {shown} 根的最大差值，其余各柱屈服、开裂、被接触面切断，或数据行中未反映出波",
    ),
    ("no wave has reached a column of the ground", "尚无波到达自由场柱"),
    (
        "velocity of the model's own surface and base at its vertical edges against that of column '{column}', over that one's peak: sides that hold or drain the free field, caverns too near to them (make `sides` wider), or ground that dips, slopes or changes from side to side, which goes on level outside",
        "模型竖向棱边处地表和底面的速度与自由场柱“{column}”速度之差，除以后者的峰值：可能原因是侧边界约束或消耗自由场、洞室离侧边界太近（请加大 `sides`），或地层倾斜、地表有坡、两侧地层不同，而模型外按水平延伸",
    ),
    // Energy.
    ("energy error over the largest energy in the model", "能量误差与最大持有能量之比"),
    ("laws that do not record their dissipation: {bodies}", "有本构不记录其耗散的能量：{bodies}"),
    ("{law} of {body}", "{body} 的 {law}"),
    ("the motion is within the round-off of the energy stored before", "运动未超出此前储存能量的舍入误差"),
    (
        "largest difference of all rows between the energy found and the energy put in, every line booked by itself, but for ⅛Δt²aᵀMa, which belongs to the scheme, and for what jumps of damage within a step leave, {jumps} J at most, which the bodies' own checks judge",
        "各数据行中求得的能量与输入能量之差的最大值，各项独立记录；不含属于积分格式本身的 ⅛Δt²aᵀMa，也不含损伤在一步内突变所遗留的部分（至多 {jumps} J，由各体自身的检查判断）",
    ),
    ("unaccounted work over dissipated energy", "未计入各能量项的功与耗散能之比"),
    ("unaccounted work over dissipated energy, {body}", "未计入各能量项的功与耗散能之比，{body}"),
    ("nothing was damaged and nothing flowed", "既无损伤也无塑性流动"),
    (
        "largest of all rows, over all that was dissipated in the end: work on the body's elements less what they hold, have dissipated and created; damage that jumps within a step leaves some, which shrinks with the step",
        "各数据行中的最大值，与最终耗散总量之比：对该体单元所做的功减去其持有、耗散和产生的能量；一步内突增的损伤会留下少量差值，随步长减小而减小",
    ),
    ("no law dissipates", "没有耗散能量的本构"),
    ("energy created by material laws over energy dissipated", "本构产生的能量与耗散能之比"),
    (
        "largest rise of what closed strain loops of cracked concrete gave out; split = \"compliance\" cannot",
        "开裂混凝土在闭合应变循环中释放能量的最大增量；split = \"compliance\" 不会出现",
    ),
    ("hourglass energy over strain energy", "沙漏能与应变能之比"),
    ("no one-point elements", "没有单点积分单元"),
    ("nothing is strained", "没有变形"),
    (
        "largest ratio of all rows, at {time} s: energy of the one-point elements' stabilisation, bending that their one point misses",
        "各数据行中的最大比值，出现在 {time} s：单点积分单元沙漏控制的能量，即其单个积分点未计及的弯曲",
    ),
    // Water in pores.
    ("pressures stay as the stages leave them", "孔隙水压力保持各阶段结束时的值"),
    ("wet ground whose water boils", "孔隙水汽化的含水地层"),
    (
        "largest share of the volume of wet ground at −100 kPa, at {time} s; pressures lie between {least} and {most} MPa. What happens once water has boiled is not modelled",
        "含水地层中孔压降至 −100 kPa 的最大体积占比，出现在 {time} s；孔压介于 {least} 与 {most} MPa 之间。汽化之后的行为未予模拟",
    ),
    ("wet ground in which water exceeds the least pressure", "孔压超过最小总压应力的含水地层"),
    (
        "largest share of the volume of wet ground with an effective principal stress in tension, at {time} s: water would open cracks there and flow into them, which is not modelled",
        "含水地层中有效主应力受拉的最大体积占比，出现在 {time} s：水会在该处劈开裂缝并流入其中，未予模拟",
    ),
    (
        "way of the water in the earthquake over the element at drained ground",
        "地震期间水的运移距离与排水边界处单元尺寸之比",
    ),
    ("no hydraulic conductivity is given", "未给出渗透系数"),
    ("wet ground ends nowhere", "含水地层没有排水边界"),
    (
        "√(c_v T) over the shortest extent, largest in {element}: so far from voids and drained ground water does leave, and pressures change by less",
        "√(c_v T) 与最短尺寸之比，最大值位于{element}：距空洞与已排水地层这一距离以内水会流出，孔压变化较小",
    ),
    ("elements whose water cannot leave in the earthquake", "地震中不排水的单元数"),
    (
        "they had water in their pores when it began; which of drained and undrained moves a lining more depends on the case: run it with [water] earthquake = \"drained\" as well",
        "地震开始时其孔隙含水；排水与不排水何者使衬砌变形更大因算例而异：请同时以 [water] earthquake = \"drained\" 计算",
    ),
    // Materials.
    ("monitors on broken elements", "位于断裂单元上的监测点"),
    ("no monitor is in a material that can crack", "没有监测点位于会开裂的材料中"),
    ("nothing holds an element with all points broken in tension", "所有积分点均已拉断的单元不再受约束"),
    (
        "{monitors}: every point of the element is broken in tension; its displacement is not the lining's",
        "{monitors}：单元的所有积分点均已拉断；其位移不代表衬砌的位移",
    ),
    ("yielding rock without initial stress", "无初始应力的屈服岩体"),
    ("the ground begins with initial stress", "地层具有初始应力"),
    ("no rock's strength depends on its pressure", "没有强度随压力变化的屈服岩体"),
    (
        "{names}: strength grows with pressure, and the weight of the ground is not in this run; it yields earlier and further than in place, most of all in tension",
        "{names}：强度随压力增长，而本次计算未计入地层自重；与实际相比屈服更早、范围更大，受拉时尤甚",
    ),
    ("fibre stress of intact elements over the tensile strength", "完好单元的表层应力与抗拉强度之比"),
    ("no lining with several points per element can crack", "没有多积分点单元的衬砌会开裂"),
    (
        "{body}, element {element} at {place} at {time} s; points inside an element crack later than its fibre: \
         element = \"layered\" has points at both faces",
        "{body}，单元 {element}，位于 {place}，{time} s 时；单元内部的积分点比表层开裂得晚：element = \"layered\" 在两个表面都有积分点",
    ),
    ("implied fracture energy", "隐含断裂能"),
    ("implied fracture energy, {body}", "隐含断裂能，{body}"),
    (
        "{least} to {most} N/m for cracks across the elements' shortest to longest extents: a law that softens by strain alone dissipates more the larger the element; give fracture_energy",
        "裂缝横穿单元最短至最长尺寸时为 {least} 至 {most} N/m：仅按应变软化的本构，单元越大耗散越多；请给出 fracture_energy",
    ),
    ("no law has a softening in strain alone", "没有仅按应变软化的本构"),
    ("fracture energy, {body}", "断裂能，{body}"),
    ("cracks dissipate it in elements of any size", "无论单元大小，裂缝都耗散该能量"),
    ("{check}, {body}", "{check}，{body}"),
    ("strength at corners over that by the fracture energy", "角部强度与断裂能所对应强度之比"),
    ("no concrete has the plateau (evolution = residual)", "没有开裂时骤降至残余平台的混凝土"),
    (
        "none of it has cracked; a plateau makes corners too weak",
        "其中没有任何部分开裂，尽管残余平台会使角部强度偏低",
    ),
    (
        "half of the {count} cracked points are in elements that extend over {size} m or more across the crack, large enough for the drop to \
         a plateau",
        "{count} 个开裂积分点中，有一半所在单元横跨裂缝的尺寸不小于 {size} m，对于骤降至残余平台而言足够大",
    ),
    (
        "half of the {count} cracked points are in elements that extend over {size} m or less across the crack: dropping to a plateau these \
         break by their mean stress where it concentrates, at this share of the load, and the smaller they are the earlier; evolution = \
         \"exponential\" keeps to the fracture energy",
        "{count} 个开裂积分点中，有一半所在单元横跨裂缝的尺寸不超过 {size} m：骤降至残余平台的单元在应力集中处按其平均应力破坏，荷载仅为应有值的这一比例，单元越小破坏越早；evolution = \"exponential\" 遵循断裂能",
    ),
    ("warnings of material laws", "材料本构的警告"),
    ("{body}: {warning}", "{body}：{warning}"),
];
