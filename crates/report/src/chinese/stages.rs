//! Of the stages before the earthquake.

use super::Texts;

pub const TEXTS: Texts = &[
    ("; ", "；"),
    ("stage {k}", "第 {k} 阶段"),
    ("stage {k}, {name}", "第 {k} 阶段“{name}”"),
    ("Before the earthquake", "施工阶段"),
    ("Stages", "施工阶段"),
    (
        "The table of stages is left out: summary.json lists none yet.",
        "未列施工阶段表：summary.json 中尚无施工阶段。",
    ),
    ("stage", "阶段"),
    ("what changed", "变化"),
    ("let go", "释放"),
    ("cycles", "计算步数"),
    ("out of balance", "不平衡比"),
    ("motion left", "剩余位移"),
    ("largest motion", "最大位移"),
    ("still held", "未释放"),
    (
        "Stage 0 brings what is there at the start to equilibrium; displacements count from its end. Out of \
         balance: unbalanced forces over all contributions to them, summed over nodes. Motion left: an estimate \
         of what more cycles would bring; it should be small beside the largest motion, which is that of any \
         node within the stage. ∫Γ dV: plastic shear strain summed over the volume that stands. Still held: what \
         a release below 100\u{a0}% has not let go, over the same contributions; it should be 0 at the end.",
        "第 0 阶段使初始模型达到平衡，位移自其结束时起算。不平衡比：各节点不平衡力之和与各项贡献之和的比值。剩余\
         位移：继续计算还会产生的位移的估计值，与最大位移相比应很小；最大位移取该阶段内所有节点的最大者。∫Γ dV：\
         塑性剪应变对现存体积的积分。未释放：释放率低于 100\u{a0}% 时尚未释放的力与同一各项贡献之和的比值，最终应\
         为 0。",
    ),
    ("excavated {groups}", "开挖 {groups}"),
    ("installed {groups}", "施作 {groups}"),
    ("initial equilibrium", "初始平衡"),
    ("nothing but release", "仅释放荷载"),
    ("wall or drain", "洞壁或排水孔"),
    ("inflow (l/s)", "渗流量 (l/s)"),
    ("mass error", "水量误差"),
    ("Seepage", "渗流"),
    (
        "Water that walls and drains take in the steady state of each stage, of the whole model. Mass error: what comes in less what leaves, over what comes in.",
        "各阶段稳定渗流时整个模型中洞壁和排水孔的排水量。水量误差：流入与流出之差与流入之比。",
    ),
    ("pressure of the water p", "孔隙水压力 p"),
    (
        "Lines separate elements with water under pressure from those without: the free surface. Look for how far the openings drain the rock, and for pressure right behind a lining.",
        "线条为有压与无压单元的分界，即按单元表示的浸润面。应注意洞室对岩体的疏干范围，以及紧邻衬砌背后的水压力。",
    ),
    (
        "Thin lines with arrows are flow lines in the plane of the section, below the free surface alone: the closer they lie, the more water flows. They end where the water leaves the ground or the section.",
        "带箭头的细线为剖面平面内浸润面以下的流线：流线越密，渗流量越大；流线止于水流出岩土体或离开剖面之处。",
    ),
    ("monitor", "监测点"),
    ("Monitors when the stages are done", "施工阶段结束时的监测点"),
    (
        "After {stage}. Displacements since the initial equilibrium, of a lining since its installation; tension \
         is positive. All stages are in stages.csv.",
        "{stage}之后。位移自初始平衡起算，衬砌自其施作起算；拉为正。各阶段的数值见 stages.csv。",
    ),
    (
        " A pair shows how much more the first monitor moved than the second.",
        "成对的监测点为前者减后者的相对位移。",
    ),
    ("Left out. {why}", "未列出。{why}"),
    ("How the model came to rest", "模型趋于平衡的过程"),
    (
        "relaxation.csv has no columns stage, cycle and ratio.",
        "relaxation.csv 中没有 stage、cycle 和 ratio 列。",
    ),
    ("out of balance: Σ|R| / Σ|contributions|", "不平衡比：Σ|R| / Σ|各项贡献|"),
    ("tolerance {limit}", "容许值 {limit}"),
    ("motion in the stage", "本阶段位移"),
    ("motion left (estimate)", "剩余位移（估计）"),
    ("motion of the node that moves most (m)", "位移最大节点的位移 (m)"),
    ("relaxation.csv holds no ratio that is not zero.", "relaxation.csv 中的不平衡比全部为零。"),
    (
        "Each stage begins out of balance and must end below the tolerance; a curve that levels off above it has \
         not settled. Waves on the way down are usual.",
        "各阶段开始时不平衡，结束时必须低于容许值；曲线在容许值以上变平，则尚未稳定。下降途中的波动属正常现象。",
    ),
    (" The summary states no tolerance.", "摘要未给出容许值。"),
    (" The motion left should end far below the stage's own motion.", "剩余位移最终应远小于本阶段位移。"),
    ("cycles of all stages", "各阶段累计计算步数"),
    (
        "out of balance over the cycles of all stages, with the tolerance",
        "各阶段不平衡比随计算步数的变化及容许值",
    ),
    ("Convergence", "洞周收敛"),
    ("crown", "顶拱"),
    ("floor", "底板"),
    ("wall left", "左边墙"),
    ("wall right", "右边墙"),
    ("wall to wall", "边墙间收敛"),
    ("wall to wall, {wall}", "边墙间收敛，{wall}"),
    ("Left out. The summary names no points of walls.", "未列出。摘要中没有洞壁测点。"),
    (
        "Displacement of the rock nearest to each named point since the initial equilibrium. In the figures \
         motion towards the opening is positive: crown down, floor up, the left wall (smaller x) to the right, \
         the right one to the left. Wall to wall: how much nearer the two walls came. Motion should follow the \
         excavation; where it goes on growing without any, or one wall runs away from the others, take a second \
         look.",
        "离各命名点最近的围岩自初始平衡以来的位移。图中以向洞内的位移为正：顶拱向下、底板向上、左边墙（x 较小）向\
         右、右边墙向左。边墙间收敛：两侧边墙相互靠近的量。位移应随开挖而发展；若无开挖而持续增长，或某一边墙明显\
         偏离其他部位，应进一步检查。",
    ),
    (
        "Points: no figure, since no name says crown, wall left, wall right or floor.",
        "测点：名称中没有 crown、wall left、wall right 或 floor，故无图。",
    ),
    (
        "{cavern}: no figure, since no name says crown, wall left, wall right or floor.",
        "{cavern}：名称中没有 crown、wall left、wall right 或 floor，故无图。",
    ),
    ("motion towards the opening", "向洞内位移"),
    ("{name}: motion towards the opening", "{name}：向洞内位移"),
    ("at the end of each stage", "各阶段结束时"),
    (
        "Most at the end ({end}): {point}, {size} away from the opening.",
        "最终（{end}）位移最大：{point}，背向洞内 {size}。",
    ),
    (
        "Most at the end ({end}): {point}, {size} towards the opening.",
        "最终（{end}）位移最大：{point}，向洞内 {size}。",
    ),
    ("closer by", "靠近量"),
    ("Force over displacement", "力–位移曲线"),
    ("displacement since the initial equilibrium", "自初始平衡起的位移"),
    ("force over displacement of what stages move", "各阶段所移动部位的力–位移曲线"),
    (
        "{name}: largest force {force} at {way}; {left} at the end, {end}. ",
        "{name}：最大力 {force}，位移 {way}；结束时 {left}，位移 {end}。",
    ),
    (
        "The force with which what is moved pushes on the model, positive along the axis, when the model is at rest after each step. \
         All steps are in stages.csv.",
        "被移动部位在每一步静止后作用于模型的力，沿坐标轴为正。全部步骤见 stages.csv。",
    ),
    ("Ground reaction", "围岩特征曲线"),
    ("{drawn} of {all} such excavations are drawn.", "共有 {all} 次分步释放的开挖，图中给出 {drawn} 次。"),
    (
        "Motion towards the opening since the stage before the excavation, over the share of the forces at its \
         surface that has been let go (what is left acts like a support). A straight line is elastic rock; where \
         the curve steepens the rock yields. After a lining is installed the curve should flatten as the lining \
         takes its share.",
        "自开挖前一阶段起的向洞内位移，随开挖面上已释放荷载比例的变化（未释放的部分相当于支护）。直线表示围岩处于\
         弹性状态；曲线变陡处围岩屈服。衬砌施作后由其分担荷载，曲线应变缓。",
    ),
    ("let go so far", "已释放"),
    ("{names} installed with {share}\u{a0}% of the forces let go", "释放 {share}\u{a0}% 时施作 {names}"),
    ("{list}.", "{list}。"),
    ("motion over the share of forces let go", "位移随已释放荷载比例的变化"),
];
