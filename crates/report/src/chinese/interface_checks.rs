//! Of the checks of interfaces and bolts.

use super::Texts;

pub const TEXTS: Texts = &[
    ("no interface", "没有接触面"),
    ("interfaces without initial stress", "无初始应力的接触面"),
    (
        "energy created by interface laws over energy dissipated by friction",
        "接触面本构产生的能量与摩擦耗能之比",
    ),
    ("largest closure of the interface over its limit", "接触面最大闭合量与其极限之比"),
    ("largest closure over its limit", "最大闭合量与其极限之比"),
    ("largest slip over element size", "最大滑移量与单元尺寸之比"),
    ("largest gap over element size", "最大张开量与单元尺寸之比"),
    ("interface pairs under more pressure than pressure_for_step", "压力超过本构转为线性之值的节点对数"),
    ("energy error of impacts over energy supplied", "碰撞产生的能量与输入能量之比"),
    ("time step × frequency of the stiffest contact pair", "时间步长与最刚节点对频率之积"),
    (
        "ringing of the interface: acceleration above the input's band over that within it",
        "接触面附近高于输入频带的运动",
    ),
    (
        "between sound elements, and apart from what hits, it slid over {share} % of area and time alone",
        "在完好单元之间且远离碰撞之处，滑移仅占面积和时间的 {share} %",
    ),
    (
        "acceleration of its nodes above {corner} Hz, twice the highest frequency that comes in, {above} m/s², over that below, {below} m/s²; root mean squares over {share} % of area and time: where it slid between sound elements, away from what was open. Sliding feeds such vibrations, and they make it slide further: give the interface more `viscosity`",
        "其节点高于 {corner} Hz（输入最高频率的两倍）的加速度 {above} m/s² 与低于该频率的加速度 {below} m/s² 之比；为面积和时间的 {share} % 上的均方根值，即在完好单元之间滑移且远离张开处的部分。滑移会激发这种振动，并因此滑得更远：请为接触面给出更大的 `viscosity`",
    ),
    ("compliance of the interface over that of the adjacent elements", "接触面柔度与相邻单元柔度之比"),
    ("{check}, {interface}", "{check}，{interface}"),
    (
        "{names}: no initial stress presses the two sides together, so they part and slide earlier and further than they would in the ground; an interface without a bond opens with the first motion",
        "{names}：地震前没有压力使两侧贴紧，也没有自重使其重新闭合，因此与实际相比张开和滑移更早、更大；无粘结的接触面从一开始运动即张开",
    ),
    ("nothing slid or opened", "既无滑移也无张开"),
    (
        "nothing slid, and pairs gave out {share} of all energy supplied",
        "没有滑移，节点对释放的能量为全部输入能量的 {share}",
    ),
    (
        "largest rise of what pairs gave out whose shear stiffness goes by the closure; tangential = \"constant\" cannot",
        "剪切刚度随闭合量变化的节点对所释放能量的最大增量；tangential = \"constant\" 不会出现",
    ),
    ("the law '{law}' has no largest closure", "本构“{law}”没有最大闭合量"),
    (
        "of all pairs and steps, by the law at the largest pressure, over `max_closure`: the joint is nearly closed and as stiff as it gets; give a larger one, or a stiffer joint",
        "所有节点对和时间步中，按本构在最大压力下的闭合量与 `max_closure` 之比：接触面接近完全闭合，刚度已达极限；请给出更大的值，或采用更大的接触刚度",
    ),
    (
        "shortest edge of the faces at {pair}; normals and partners of pairs do not change, so slip must stay small",
        "{pair} 处各面的最短边；节点对的法向和配对不变，故滑移量须远小于单元尺寸",
    ),
    (
        "shortest edge of the faces at {pair}; sides so far apart have come loose, and where they close they meet other faces than the model pairs",
        "{pair} 处各面的最短边；张开如此之大说明已经松脱，重新闭合时会落在并非原配的面上",
    ),
    ("the law is linear", "本构始终为线性"),
    (
        "of {pairs} pairs; the largest pressure was {pressure} MPa, and from {limit} MPa on the joint is held at a constant stiffness, so that it does not shorten the step; give a larger `pressure_for_step`, at the price of a shorter one",
        "共 {pairs} 对；最大压力为 {pressure} MPa，自 {limit} MPa 起接触面保持常刚度，以免缩短步长；可给出更大的 `pressure_for_step`，代价是步长更短",
    ),
    (
        "largest of all rows: energy that the explicit step creates or loses when pairs close and open; a smaller `contact_limit` or a larger `contact_damping` reduces it",
        "各数据行中的最大值；节点对闭合和张开时显式积分产生（或损失，同样计入）的能量；减小 `contact_limit` 或加大 `contact_damping` 可使其减小",
    ),
    ("there is no earthquake", "没有地震"),
    (
        "ω_c of {pair} with its stiffest state; beyond 0.8 impacts may gain energy though the step is stable",
        "{pair} 在最刚状态下的 ω_c；超过 0.8 时，即使步长稳定，碰撞也可能增加能量",
    ),
    (
        "at equal pressure, unloaded; the program chose the stiffness. Above the limit results depend on it: give `normal_stiffness` from a test, or leave `time_step` out",
        "压力相等、未加载时；刚度由程序选定。超过限值时结果取决于该刚度：请给出试验所得的 `normal_stiffness`，或不给定 `time_step`",
    ),
    ("its stiffness was given", "刚度已给定"),
    // Bolts.
    ("largest slip of bolts over element size", "锚杆最大滑移量与单元尺寸之比"),
    ("bond force beyond strength over the largest bolt force", "粘结超出其强度的力与锚杆最大轴力之比"),
    ("no bolts with a bond", "没有带粘结的锚杆"),
    ("bolt {bolt} of {group}", "{group} 的 {bolt} 号锚杆"),
    (
        "of any step, over the smallest element that the bolt lies in: a bolt keeps its direction and stays in the elements that it first crossed, so slip must stay small",
        "所有时间步中的值，除以锚杆所在的最小单元的尺寸：锚杆始终位于当初穿过的单元内且方向不变，故滑移量须远小于单元尺寸",
    ),
    (
        "force of bonds beyond their strength, in any step since the bolt was placed, over the largest force of its group: above round-off a bolt found no equilibrium, as one that is pulled out",
        "锚杆安装以来各时间步中粘结超出其强度所承担的力，除以该组各步的最大轴力：超出舍入误差即未达到平衡，例如锚杆被拔出时",
    ),
];
