//! Of the figures of histories.

use super::Texts;

pub const TEXTS: Texts = &[
    (
        "Of all steps the largest is {size}, {quantity} of {monitor}.",
        "全部时间步中最大为 {size}（{monitor} 的 {quantity}）。",
    ),
    (
        "Drawn are the {most} of {all} that reach most; the other {left} are in the tables of the result folder and in the grey range.",
        "共 {all} 条曲线，只绘出幅值最大的 {most} 条；其余 {left} 条见结果文件夹中的表格，并计入灰色范围。",
    ),
    ("Each line stands alone; grey is the range of all of them.", "每条曲线单独绘出；灰色为全部曲线的范围。"),
    ("{value} at {time}\u{a0}s", "{time}\u{a0}s 时 {value}"),
    ("no values", "无数值"),
    ("largest: {name}, {value} at {time}\u{a0}s", "最大：{name}，{value}（{time}\u{a0}s）"),
    ("highest: {name}, {value} at {time}\u{a0}s", "最高：{name}，{value}（{time}\u{a0}s）"),
    ("lowest: {name}, {value} at {time}\u{a0}s", "最低：{name}，{value}（{time}\u{a0}s）"),
    ("z, up", "z（向上）"),
    ("Histories of the monitors", "监测点时程"),
    ("Displacement", "位移"),
    (
        "Relative to the state before the earthquake. Look whether all monitors move in step, as those of a cavern do that moves with the rock, and whether they return: what is left at the end is permanent.",
        "相对于震前状态。请看各监测点是否同步运动（洞室随围岩整体运动），以及是否回到原位：结束时剩余的即为残余位移。",
    ),
    ("Displacement less the mean of the monitors", "位移与监测点平均值之差"),
    (
        "Displacement of each monitor less the mean of all in the same row: motion that all share causes no strain. Look for monitors that do not return to the others.",
        "各监测点位移减去每一时刻全部监测点的平均值：共同的运动不产生应变，已扣除。请看是否有监测点最终偏离其余各点。",
    ),
    (
        "{first} Not in the mean, since they are on broken elements: {monitors}.",
        "{first}未计入平均值（位于断裂单元上）：{monitors}。",
    ),
    ("Relative displacement", "相对位移"),
    (
        "{first} Not drawn: {pair}, up to {size} along an axis, of which one monitor is on a broken element.",
        "{first}未绘出：{pair}，沿某一轴最大 {size}，其中一个监测点位于断裂单元上。",
    ),
    ("The case names no pairs of monitors ([[monitor_pair]]).", "算例没有指定监测点对（[[monitor_pair]]）。"),
    (
        "Of each pair, the displacement of the first monitor less that of the second: what the lining between them has to follow.",
        "每一对中第一个监测点的位移减去第二个的：即两点之间的衬砌必须承受的变形。",
    ),
    ("Tension is positive.", "拉应力为正。"),
    (
        "{first} Set s1 beside the tensile strength of what a monitor lies in: {strengths}. Fast loading raises it, and damping adds to s1: where s1 passes it for a moment, the damage at that place says whether a crack opened.",
        "{first}请将 s1 与监测点所在材料的抗拉强度对照：{strengths}。达到强度后降至接近零处，裂缝已张开。",
    ),
    ("Principal stress as if nothing cracked", "假定不开裂时的主应力"),
    (
        "The largest principal value of σ₀ + C:Δε (s1_elastic in monitors.csv): the stress when the shaking begins, and what the strain since then would add if nothing cracked or yielded. Set it beside s1 above, which also holds what damping over a band adds to a fast change: where it goes on and s1 falls, a crack has taken the stress.",
        "σ₀ + C:Δε 的第一主值（monitors.csv 中的 s1_elastic）：震动开始时的应力，加上此后应变在不开裂、不屈服时所增加的应力。与上图 s1 对照：s1 还含频带阻尼在快速变化时附加的应力；s1_elastic 继续变化而 s1 下降之处，应力已由裂缝释放。",
    ),
    (
        "{first} Not drawn: {monitor}, up to {size}, on a broken element.",
        "{first}未绘出：{monitor}，最大 {size}，位于断裂单元上。",
    ),
    (
        "{first} Not drawn: {monitor}, up to {size}: its element has cracked open.",
        "{first}未绘出：{monitor}，最大 {size}：其所在单元已裂开。",
    ),
    (
        "{first} {component}: of any two monitors that are not on broken elements the correlation is at least {correlation} ({least}), and the shift in time at which they fit best at most {lag} ({latest}).",
        "{first}{component}：未破坏单元上任意两监测点的相关系数不小于 {correlation}（{least}），吻合最好时的时间差不大于 {lag}（{latest}）。",
    ),
    ("s1, the largest principal stress", "s1，第一主应力"),
    ("s3, the smallest principal stress", "s3，第三主应力"),
    ("Principal stress", "主应力"),
    ("Velocity", "速度"),
    (
        "A monitor that alone shows far more than the rock is on a loose piece that rings, or beside a crack that closes.",
        "若仅某一监测点远大于围岩，则为松动块体振荡或裂缝闭合所致。",
    ),
    ("Acceleration", "加速度"),
    ("monitors.csv has no columns of {names}.", "monitors.csv 没有 {names} 列。"),
    ("All values are zero.", "所有数值均为零。"),
    ("Not drawn: {title}, zero.", "未绘出：{title}，为零。"),
    ("Not drawn: {title}, nowhere more than {size}.", "未绘出：{title}，各处均不超过 {size}。"),
    ("Damage over time", "损伤发展过程"),
    ("Nothing was damaged.", "没有损伤。"),
    (
        "Share of each group's volume that is cracked or crushed (damage above 0.5) or has yielded, and the widest crack so far. Look whether it grows at once or with every cycle; what still grows at the end of the run may go on.",
        "各组中开裂、压碎（损伤大于 0.5）或屈服的体积比例，以及至此的最大裂缝宽度。请看损伤是一次形成还是随每个循环增长；结束时仍在增长的尚未稳定。",
    ),
    ("% of volume", "% 体积"),
    ("widest crack", "最大裂缝宽度"),
    ("widest crack parallel to the wall", "平行于壁面的最大裂缝"),
];
