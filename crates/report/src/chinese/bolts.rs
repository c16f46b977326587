//! Of bolts.

use super::Texts;

pub const TEXTS: Texts = &[
    ("Bolts", "锚杆"),
    ("No table of groups: the summary does not hold them yet.", "无锚杆组表：摘要中尚无锚杆组。"),
    (
        "Of each group over the whole run. Forces are those of largest size of any stage and step, tension \
         positive; a bolt counts under every heading it comes under, and what an excavation has taken of it \
         counts no more. Places in m.",
        "各组在整个计算过程中的结果。力为所有阶段和时步中绝对值最大者，拉为正；一根锚杆可同时计入多项，被开挖切除\
         的部分不再计入。位置以 m 计。",
    ),
    ("There is no bolts.csv in the result folder.", "结果文件夹中没有 bolts.csv。"),
    ("There is no bolts.pvd in the result folder.", "结果文件夹中没有 bolts.pvd。"),
    ("bolts.pvd lists no file yet.", "bolts.pvd 中尚未列出文件。"),
    ("at {time}\u{a0}s", "{time}\u{a0}s 时"),
    ("group", "组"),
    ("placed in", "施作阶段"),
    ("bolts", "根数"),
    ("left out", "未设"),
    ("shortened", "截短"),
    ("length (m)", "长度 (m)"),
    ("yield at", "屈服力"),
    ("cut by excavations", "被开挖切断"),
    ("the start", "初始"),
    ("the earthquake", "地震"),
    ("never", "不屈服"),
    ("{number} wholly", "其中 {number} 根全部切除"),
    ("largest force", "最大轴力"),
    ("of", "所属锚杆"),
    ("over yield", "与屈服力之比"),
    ("yielded", "屈服"),
    ("broke", "断裂"),
    ("bond slid", "粘结滑移"),
    ("not placed yet", "尚未施作"),
    ("no bond", "无粘结"),
    ("by up to {slip}", "最大 {slip}"),
    ("{at}, at\u{a0}{time}\u{a0}s", "{at}，{time}\u{a0}s 时"),
    ("{at}, in {stage}", "{at}，阶段“{stage}”"),
    ("bolt\u{a0}{number}", "{number}\u{a0}号锚杆"),
    ("earthquake, largest of its rows", "地震，各行的最大值"),
    ("at the end of", "阶段结束时"),
    ("Force over yield, stage by stage", "各阶段轴力与屈服力之比"),
    (
        "Of the bolt of each group that is nearest to yield then, with the largest force below it; of groups \
         that never yield the force. A group that takes on load in every stage after its own holds ground that \
         still moves.",
        "各组中当时最接近屈服的锚杆，其下为最大轴力；不会屈服的组只列轴力。某组若在施作后的每一阶段都继续受力，说\
         明其所锚固的围岩仍在移动。",
    ),
    (
        "{share} of yield, in the reinforcement {group}, row {row}",
        "为屈服力的 {share}，{group} 的第 {row} 排钢筋",
    ),
    ("reinforcement {group}, row {row}", "{group} 的第 {row} 排钢筋"),
    ("{group}, bolt {bolt}", "{group}，{bolt} 号锚杆"),
    ("{share} of yield, in {group}, bolt {bolt}", "为屈服力的 {share}，{group}，{bolt} 号锚杆"),
    ("{which}; {yielded} of {all} bolts yielded", "{which}；{all} 根中有 {yielded} 根屈服"),
    ("Force along the bolts that carry most", "受力最大锚杆的轴力分布"),
    ("{group} at {force}", "{group} 为 {force}"),
    ("force, tension positive", "轴力，拉为正"),
    ("from the head (m)", "距锚头 (m)"),
    (
        "Of each group the bolt that came nearest to yield, or carries most where none yields: full line {when}, \
         dashed that of largest size in any step since the earthquake began. A force that falls to nothing at \
         both ends is carried by the bond; one that is large at the head hangs on the plate.",
        "各组中最接近屈服的锚杆；不会屈服的组取受力最大者。实线：{when}的轴力；虚线：地震开始以来各时步中绝对值最\
         大的轴力。两端降为零的轴力由粘结承担；锚头处较大的轴力由垫板承担。",
    ),
    (
        "Of each group the bolt that came nearest to yield, or carries most where none yields: full line {when}, \
         dashed that of largest size in any step since the stage began. A force that falls to nothing at both \
         ends is carried by the bond; one that is large at the head hangs on the plate.",
        "各组中最接近屈服的锚杆；不会屈服的组取受力最大者。实线：{when}的轴力；虚线：本阶段开始以来各步中绝对值最\
         大的轴力。两端降为零的轴力由粘结承担；锚头处较大的轴力由垫板承担。",
    ),
    ("The same of those of another length.", "其他长度锚杆的同类图。"),
    (" Yield: {list}.", "屈服力：{list}。"),
    ("force over the distance from the head", "轴力沿距锚头距离的分布"),
];
