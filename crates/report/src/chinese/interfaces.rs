//! Of interfaces.

use super::Texts;

pub const TEXTS: Texts = &[
    ("slid so far", "曾滑移"),
    ("opened so far", "曾张开"),
    ("sliding now", "正在滑移"),
    ("open now", "正在张开"),
    ("Interfaces over time", "接触面时程"),
    ("Interfaces over time: {name}", "接触面时程：{name}"),
    (" Nothing slid or opened on {names}.", "{names} 上没有滑移或张开。"),
    ("No interface slid or opened.", "没有接触面发生滑移或张开。"),
    ("% of its area", "%"),
    ("area", "面积"),
    ("slip, gap", "滑移、张开"),
    ("Interface {name}", "接触面 {name}"),
    ("Interface {name}, {area}", "接触面 {name}（{area}）"),
    (
        "{which}: its area that slides and is open in each row of interfaces.csv, and that did in any step so \
         far; below, the largest slip and gap so far of pairs whose bond is broken, slip while they are closed. \
         Look whether slip goes on growing to the end: then the interface has not come to rest.",
        "{which}：interfaces.csv 每行中正在滑移和张开的面积，以及此前任一时步中曾滑移和张开的面积；下图为粘结已破\
         坏的节点对的历史最大滑移和最大张开量，滑移取闭合时的值。应注意滑移是否直到最后仍在增长：若是，则接触面尚\
         未稳定。",
    ),
    ("Monitors on interfaces", "接触面上的监测点"),
    ("bonded", "粘结"),
    ("stuck, bond broken", "粘结破坏，未滑移"),
    ("sliding", "滑移"),
    ("open", "张开"),
    ("along e1", "沿 e1"),
    ("along e2", "沿 e2"),
    ("gap", "张开量"),
    ("pressure", "压力"),
    ("slip", "滑移量"),
    ("pressure, compression positive", "法向压力，压为正"),
    ("shear", "剪应力"),
    ("|shear|", "|剪应力|"),
    ("{name} in {rows} rows", "{name}：{rows} 行"),
    ("{monitor}: the pair of the interface nearest to it", "{monitor}：离其最近的接触面节点对"),
    ("time", "时间"),
    ("state", "状态"),
    (
        "Monitor {monitor}, rows of monitors.csv. The gap is positive where it is open and negative where \
         pressure closes the joint. Slip of the second side against the first, and shear along the slip that \
         causes it: along e1, horizontal, and e2, up the dip (x and y on a level interface). Look for slip that \
         stays and gaps that do not close when the shaking ends.",
        "监测点 {monitor}，取自 monitors.csv 各行。张开量张开时为正，受压使接触面闭合时为负。滑移为第二侧相对于第\
         一侧的滑移，剪应力沿其引起的滑移方向：e1 为水平方向，e2 为沿倾向向上（水平接触面上为 x 和 y）。应注意地\
         震结束后残留的滑移和未闭合的张开。",
    ),
    ("{monitor}: shear over pressure", "{monitor}：剪应力与压力"),
    (
        "Monitor {monitor}: size of the shear over the pressure, a dot a row of monitors.csv. Pairs that slide \
         lie on a line through the origin whose slope is the friction μ; above it only the bond holds.",
        "监测点 {monitor}：剪应力大小与压力的关系，monitors.csv 每行一点。滑移的节点对位于过原点、斜率为摩擦系数 \
         μ 的直线上；在其以上只能由粘结承担。",
    ),
    ("Law", "本构"),
    ("of the law", "所用本构的参数"),
    ("Area", "面积"),
    ("and the pairs of nodes that share it", "及其节点对数"),
    ("Normal stiffness k_n0", "法向刚度 k_n0"),
    ("closed and unloaded", "闭合且未受荷"),
    ("chosen by the program", "由程序选取"),
    ("given", "给定"),
    ("Closure at 1\u{a0}MPa", "1\u{a0}MPa 下的闭合量"),
    ("by the law", "按本构"),
    ("Area that ever slid", "曾滑移的面积"),
    ("Area that ever opened", "曾张开的面积"),
    ("in any step", "任一时步"),
    ("Area sliding at the end", "结束时滑移的面积"),
    ("Area open at the end", "结束时张开的面积"),
    ("Largest slip", "最大滑移"),
    ("of closed pairs whose bond is broken, of all steps", "粘结已破坏的闭合节点对，所有时步"),
    ("Largest gap", "最大张开量"),
    ("of all pairs whose bond is broken and all steps", "所有粘结已破坏的节点对，所有时步"),
    ("Largest pressure", "最大压力"),
    ("of all pairs and steps", "所有节点对，所有时步"),
    ("above {pressure}, where the stiffness is constant", "超过 {pressure}，此后本构为直线"),
    ("Energy found at impacts", "碰撞时增加的能量"),
    (
        "over the run, negative where it was lost; part of the balance's error",
        "整个计算过程，损失为负；属能量平衡误差的一部分",
    ),
    ("Largest slip of an interface", "接触面最大滑移"),
    ("Largest gap of an interface", "接触面最大张开量"),
    (
        "{name} at ({place}) m, of pairs whose bond is broken, of all steps",
        "{name}，位置 ({place}) m，粘结已破坏的节点对，所有时步",
    ),
    ("{pairs}\u{a0}pairs", "{pairs}\u{a0}对"),
    ("{pairs}\u{a0}pairs; ends, closed, at 1 node", "{pairs}\u{a0}对；端部闭合于 1 个节点"),
    ("{pairs}\u{a0}pairs; ends, closed, at {ends} nodes", "{pairs}\u{a0}对；端部闭合于 {ends} 个节点"),
    ("at\u{a0}({x},\u{a0}{y},\u{a0}{z})", "位于\u{a0}({x},\u{a0}{y},\u{a0}{z})"),
];
