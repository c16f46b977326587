//! Of how a run went, and of its places.

use super::Texts;

pub const TEXTS: Texts = &[
    (
        "All {stages} stages came to rest; there is no earthquake in this case.",
        "全部 {stages} 个阶段均达到静止；本算例没有地震。",
    ),
    ("The run reached its end, {time} s.", "计算已到达终点 {time} s。"),
    (
        "The run was stopped in the stage '{name}'; go on with --resume.",
        "计算在阶段“{name}”中被停止；可用 --resume 继续。",
    ),
    ("The run was stopped at {time} s; go on with --resume.", "计算在 {time} s 被停止；可用 --resume 继续。"),
    (
        "The run became unstable and was stopped at {time} s: what moves and what is deformed hold {energy} J more than at rest where {supplied} J were supplied.",
        "计算失稳，在 {time} s 停止：动能与变形能比静止时多 {energy} J，而输入的能量仅为 {supplied} J。",
    ),
    (
        "The run became unstable and was stopped at {time} s: {energy} J are in no line of its energy balance where {supplied} J were supplied.",
        "计算失稳，在 {time} s 停止：能量平衡中有 {energy} J 不属于任何一项，而输入的能量为 {supplied} J。",
    ),
    (
        "The run became unstable and was stopped at {time} s: the borders of the levels of steps gave {energy} J where {supplied} J were supplied.",
        "计算失稳，在 {time} s 停止：各级时间步的交界处产生了 {energy} J，而输入的能量为 {supplied} J。",
    ),
    (
        "The run became unstable and was stopped at {time} s: its motion overflowed.",
        "计算失稳，在 {time} s 停止：运动已超出一切数值范围。",
    ),
    ("Most of it is in {place}.", "其大部分位于{place}。"),
    ("Use a smaller time_step or safety.", "请减小 time_step 或 safety。"),
    ("The run was stopped at {time} s: {why}.", "计算在 {time} s 停止：{why}。"),
    ("Rows, fields and checkpoints before it are valid.", "此前的时程数据、场结果与检查点均有效。"),
    (
        "{place} has moved by {far} m, further than the model is long, {most} m; it is ground outside the model's sides, so its steps are unstable: run with dynamic.levels = 1",
        "{place}已移动 {far} m，超过模型的最大尺寸 {most} m；该处为模型侧边以外的地层，因此其时间步失稳：请以 dynamic.levels = 1 运行",
    ),
    ("node {number}", "节点 {number}"),
    (
        "{place} has moved by {far} m, further than the model is long, {most} m: it is loose, or the record carries the model off (correct its baseline)",
        "{place}已移动 {far} m，超过模型的最大尺寸 {most} m：该处已脱离约束，或地震记录使模型整体漂移（请校正基线）",
    ),
    (
        "{pair} has closed by {closure} m under {pressure} Pa, beyond the largest closure of its law, {limit} m: give a larger max_closure, or a stiffer joint",
        "{pair}在 {pressure} Pa 下闭合 {closure} m，超过其本构的最大闭合量 {limit} m：请增大 max_closure，或采用更刚的接触面",
    ),
    (
        "Laws of materials gave out {created} J (created_by_law in energy.csv), more than was supplied, which no smaller step mends: split = \"effective\" does so once concrete has cracked, \"compliance\" does not.",
        "材料本构释放了 {created} J（energy.csv 中的 created_by_law），多于输入能量，减小时间步无济于事：混凝土开裂后 split = \"effective\" 会如此，\"compliance\" 不会。",
    ),
    (
        "The stage '{stage}' did not come to rest: after {cycles} cycles elements there had strained by a tenth or moved by more than their own length: nothing holds them.",
        "阶段“{stage}”未达到静止：{cycles} 个计算步后，该处单元的应变已达十分之一或位移超过自身长度：没有任何约束。",
    ),
    (
        "The stage '{stage}' did not come to rest: after {cycles} cycles {ratio} of all forces were out of balance and {left} m of motion were left.",
        "阶段“{stage}”未达到静止：{cycles} 个计算步后，不平衡力占全部力的 {ratio}，剩余位移 {left} m。",
    ),
    (
        "Most moves {place}, as `motion_of_last_cycle` in stages/{file} shows.",
        "运动最大处为{place}，见 stages/{file} 中的 `motion_of_last_cycle`。",
    ),
    (
        "The ground there has lost its support and falls: support it, excavate less in one stage, or release it in smaller shares (`release`).",
        "该处失去支撑的部分正在塌落：请加以支护、减小一次开挖量，或减小每次释放的比例（`release`）。",
    ),
    (
        "Give more `max_cycles` if it was on its way to rest (relaxation.csv shows it). Ground that has lost its support falls: support it, excavate less in one stage, or release it in smaller shares (`release`).",
        "若正趋于静止（见 relaxation.csv），请加大 `max_cycles`；失去支撑的部分会塌落：请加以支护、减小一次开挖量，或减小每次释放的比例（`release`）。",
    ),
    ("{passed} of {judged} checks of the run pass.", "{judged} 项检查中 {passed} 项通过。"),
    (
        "{passed} of {judged} checks of the run pass; look at: {names}.",
        "{judged} 项检查中 {passed} 项通过；请查看：{names}。",
    ),
    ("{stress} MPa in {group} at {time} s", "{group} {stress} MPa（{time} s）"),
    (
        "Largest principal stress (at the fibre of intact elements with several points, otherwise at points): {peaks} (change by the earthquake alone).",
        "最大主应力（完好的多积分点单元取截面边缘处，其余取积分点）：{peaks}（仅地震引起的变化）。",
    ),
    (
        "Largest principal stress (at the fibre of intact elements with several points, otherwise at points): {peaks} (in all, initial stress included).",
        "最大主应力（完好的多积分点单元取截面边缘处，其余取积分点）：{peaks}（总应力，含初始应力）。",
    ),
    // Places.
    ("no element", "无单元"),
    ("element {number}", "单元 {number}"),
    ("element {number} of '{group}'", "“{group}”的单元 {number}"),
    ("{element}, as it goes on outside the side", "{element}（侧边界外的延伸部分）"),
    ("{element}, as it goes on in a column", "{element}（自由场柱中的延伸部分）"),
    ("{what} at {place}", "{what}，位于 {place}"),
    ("interface '{name}' at node {node} at {place}", "接触面“{name}”的节点 {node}，位于 {place}"),
    ("interface '{name}'", "接触面“{name}”"),
    ("springs of the base", "底部弹簧"),
    ("base of the free field", "自由场底部"),
    ("springs of the sides", "侧边弹簧"),
    ("sides of the free field", "自由场侧边"),
    ("{name}", "{name}"),
    ("{part} at node {node} at {place}", "节点 {node}（{part}），位于 {place}"),
    ("Rayleigh damping, mostly its stiffness-proportional part", "瑞利阻尼，主要是刚度比例部分"),
    ("impacts allow {step} s, ω_c Δt = {limit} at {pair}", "碰撞允许步长 {step} s，ω_c Δt = {limit}，{pair}"),
    // What stages change.
    ("{groups} becomes {material}", "{groups} 变为 {material}"),
    ("{pressure} on {face}", "{face} 上作用 {pressure}"),
    ("water level at {level}", "地下水位 {level}"),
    ("head of {head} at {place}", "{place} 处水头 {head}"),
    ("no wall drained", "洞壁不排水"),
    ("walls drained: {groups}", "排水洞壁：{groups}"),
    ("drains: {count}", "排水孔：{count}"),
    ("{face} full of water to {level}", "{face} 充水至 {level}"),
    ("bolts '{name}' placed", "安装锚杆“{name}”"),
    ("{name} moved to {way} = {to}", "将 {name} 移至 {way} = {to}"),
    (
        "In the stage '{stage}' the specimen snapped back: in one step it released {lost} J of the {held} J that it stored. It stored more than its cracks dissipate (a bond that breaks dissipates nothing), so there is no equilibrium in between.",
        "在阶段“{stage}”中试件发生回跳：其储存的 {held} J 能量中有 {lost} J 被瞬间释放，因为它储存的能量多于裂缝所能耗散的（界面粘结断裂则不耗能），而中间的任何位移都不能平衡。",
    ),
    (
        "The rows before it are valid. Prescribe the displacement nearer to the crack, as in a test controlled by the opening of the crack; take a shorter or less slender specimen; or give more and smaller `steps` if the force had not reached its peak.",
        "此前各行有效。请移动更靠近裂缝的部位（如由裂缝张开控制的试验），或采用更短、更粗的试件；若力尚未达到峰值，可采用更多、更小的 `steps`。",
    ),
];
