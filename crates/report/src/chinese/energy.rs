//! Of the energy balance.

use super::Texts;

pub const TEXTS: Texts = &[
    ("kinetic", "动能"),
    ("strain", "应变能"),
    ("hourglass", "沙漏能"),
    ("dissipated", "材料耗散"),
    ("created by law", "本构产生"),
    ("band damping", "频带阻尼"),
    ("artificial viscosity", "人工黏性"),
    ("held by interfaces", "接触面储能"),
    ("friction and broken bonds of interfaces", "接触面摩擦与粘结破坏"),
    ("created by interface laws", "接触面本构产生"),
    ("contact damping", "接触阻尼"),
    ("held by bolts and their bonds", "锚杆及其粘结储能"),
    ("bonds of bolts that slide", "锚杆粘结滑移"),
    ("bolts that yield and break", "锚杆屈服与断裂"),
    ("rayleigh damping", "瑞利阻尼"),
    ("base dashpots", "底部阻尼器"),
    ("dashpots of viscous sides and top", "黏性侧边界与顶面阻尼器"),
    ("side dashpots", "侧边界阻尼器"),
    ("borders of levels of steps", "不同步长层级的交界"),
    ("base springs", "底部弹簧"),
    ("work through the sides", "侧边界做功"),
    ("input", "输入"),
    ("work of a script's own forces", "脚本自定义力做功"),
    ("initial", "初始"),
    ("error", "误差"),
    (
        "Work through the sides is that of the ground outside free-field sides on the model: of its forces, beyond those at the start, and of the dashpots between. It counts into the model: {end} at the end, between {least} and {most} over the run. Level ground without caverns passes on next to nothing of the input; far below zero are scattered waves that leave.",
        "侧边界做功是自由场侧边界以外地层对模型所做的功：包括超出初始状态的力与其间阻尼器的功，以进入模型为正：结束时 {end}，全过程在 {least} 与 {most} 之间。无洞室的水平地层几乎不传递输入；远小于零表示散射波离开模型。",
    ),
    (
        "The error drawn includes ⅛Δt²aᵀMa, a part of the scheme that shrinks with the step. The check of the energy balance, below, gives the error without it.",
        "图中误差含 ⅛Δt²aᵀMa，属于积分格式，随步长减小；下文的能量平衡检查给出扣除该项后的误差。",
    ),
    (
        "At the end interfaces hold {held}; friction and broken bonds have taken {friction}.",
        "结束时接触面储能 {held}；摩擦与粘结破坏耗能 {friction}。",
    ),
    ("Contact damping has taken {damping}.", "接触阻尼耗能 {damping}。"),
    ("Laws of interfaces have given out {created} that nobody put in.", "接触面本构凭空产生 {created}。"),
    (
        "At the end bolts hold {held}; their bonds have taken {friction}, their yield {plastic}.",
        "结束时锚杆储能 {held}；其粘结耗能 {friction}，屈服耗能 {plastic}。",
    ),
    ("Energy balance", "能量平衡"),
    ("energy.csv holds no line that is not zero.", "energy.csv 中各项均为零。"),
    ("energy", "能量"),
    ("energy of interfaces", "接触面能量"),
    ("energy of bolts", "锚杆能量"),
    (
        "The error is at most {worst}, {percent}\u{a0}% of the largest energy held.",
        "误差最大为 {worst}，占最大持有能量的 {percent}\u{a0}%。",
    ),
    ("Zero throughout: {names}.", "始终为零：{names}。"),
];
