//! Of the cards at the top, the checks and the facts of the model and the run.

use super::Texts;

pub const TEXTS: Texts = &[
    ("No summary of the run", "没有本次计算的摘要"),
    ("Run: failed", "计算：失败"),
    ("Run: stopped before its end", "计算：未完成即停止"),
    ("Run: done, but nothing was checked", "计算：完成，但未作任何检查"),
    ("Run: all {judged} checks pass", "计算：{judged} 项检查全部通过"),
    ("Run: done, 1 of {judged} checks warns", "计算：完成，{judged} 项检查中 1 项警告"),
    ("Run: done, {warnings} of {judged} checks warn", "计算：完成，{judged} 项检查中 {warnings} 项警告"),
    ("{heading}: the {most} of {all} that reach most", "{heading}：共 {all} 个，列出幅值最大的 {most} 个"),
    // Cards.
    ("Largest displacement of a monitor", "监测点最大位移"),
    (
        "{monitor} at {time}, its components together in one row of monitors.csv",
        "{monitor}，{time}，monitors.csv 同一行各分量合成",
    ),
    ("{pair} at {time}, its length", "{pair}，{time}，为矢量长度"),
    ("{first}; not counted, on broken elements: {names}", "{first}；不含 {names}（位于断裂单元上）"),
    ("Largest relative displacement", "最大相对位移"),
    ("Force of the bolt nearest to yield", "最接近屈服的锚杆轴力"),
    (
        "{energy}, of the largest energy held; from energy.csv, with ⅛Δt²aᵀMa, which belongs to the scheme and which the check leaves out",
        "{energy}，与持有能量的最大值之比；取自 energy.csv，含属于积分格式的 ⅛Δt²aᵀMa（检查项不计入）",
    ),
    ("Largest error of the energy balance", "能量平衡最大误差"),
    (
        "{wall}, after the last stage, since the initial equilibrium",
        "{wall}，最后施工阶段之后，自初始平衡起算",
    ),
    ("Largest motion of a wall in the stages", "施工阶段洞壁最大位移"),
    ("Plastic shear strain × volume, ∫Γ dV", "塑性剪应变 × 体积，∫Γ dV"),
    ("after the last stage", "最后施工阶段之后"),
    ("Largest principal stress s1", "最大主应力 s1"),
    ("Smallest principal stress s3", "最小主应力 s3"),
    (
        "{group} at {time}; at the fibre of intact elements with several points, otherwise at points",
        "{group}，{time}；完好的多积分点单元取截面边缘处，其余取积分点",
    ),
    ("monitor {monitor} at {time}", "监测点 {monitor}，{time}"),
    // The model.
    ("Elements", "单元数"),
    ("Nodes", "节点数"),
    ("Time step", "时间步长"),
    ("Steps", "步数"),
    ("{time} of shaking", "地震历时 {time}"),
    (
        "{time} of shaking; {share} % of the elements make each step, others steps of up to {most} times as long",
        "地震历时 {time}；{share} % 的单元每步都计算，其余单元的步长最多为其 {most} 倍",
    ),
    ("Kind of motion given", "给定地震动的类型"),
    ("outcrop", "基岩露头地震动（outcrop）"),
    ("incident", "入射波"),
    ("within", "地层内运动"),
    ("surface record", "地表记录"),
    ("incident motion = {factor} × the motion given", "入射运动 = {factor} × 给定运动"),
    ("Record", "地震记录"),
    ("Peak incident acceleration, {axis}", "入射加速度峰值，{axis}"),
    ("Monitors (x, y, z in m)", "监测点（x、y、z，单位 m）"),
    ("Monitors on interfaces (x, y, z in m)", "接触面监测点（x、y、z，单位 m）"),
    (
        "{monitor} on {interface}\u{a0}({place}), m\u{a0}({normal})",
        "{monitor} 位于 {interface}\u{a0}({place})，m\u{a0}({normal})",
    ),
    (
        "at the pair nearest to what was asked for; m points out of the first side into the second",
        "位于离指定点最近的节点对；m 由第一侧指向第二侧",
    ),
    // The run.
    ("Program", "程序"),
    ("Command", "命令"),
    ("Started", "开始时间"),
    ("Instructions", "指令集"),
    ("Threads", "线程数"),
    ("Wall-clock time", "计算耗时"),
    ("Element updates", "单元更新速率"),
    ("{rate}\u{a0}million a second", "每秒 {rate}\u{a0}百万次"),
    ("once", "一次"),
    ("{count} times", "{count} 次"),
    ("Resumed from a checkpoint", "从检查点续算"),
];
