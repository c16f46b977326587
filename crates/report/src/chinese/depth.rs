//! Of peaks along depth.

use super::Texts;

pub const TEXTS: Texts = &[
    ("Peaks along depth", "沿深度的峰值"),
    (
        "The folder has no depth.csv: no column of ground stood beside the model, an older version ran, or the run has not ended.",
        "结果文件夹中没有 depth.csv：模型旁没有自由场柱，或由旧版本计算，或计算尚未结束。",
    ),
    ("displacement from base", "相对底部位移"),
    ("depth.csv holds no motion.", "depth.csv 中没有运动。"),
    (
        "Largest sizes while the ground shook, over the depth below the top of the column of ground that stands nearest to the \
         monitors. Velocities, displacements and strains are those of all steps (strains of one element each, drawn at its middle), \
         accelerations those between rows. Where the model's edge leaves the column, its sides disturb the wave; where monitors lie \
         right of it, caverns and linings move more than the ground would.",
        "地震过程中的最大绝对值沿深度的分布；深度自距监测点最近的自由场柱顶面算起。速度、位移和应变取自全部时间步（应变为各单元之值，\
         绘于单元中部），加速度由输出行之间的速度差求得。模型竖边偏离自由场柱处，侧边界干扰了波的传播；监测点位于曲线右侧时，洞室与衬砌的运动大于无洞室时的岩体。",
    ),
    (
        "No theory stands beside it: the ground of the column has yielded or cracked, or an interface runs through it.",
        "未绘理论解：自由场柱的岩体已屈服或开裂，或有接触面穿过。",
    ),
    ("free field, theory", "自由场，理论解"),
    ("free field", "自由场"),
    ("edge of the model", "模型竖边"),
    ("monitors", "监测点"),
    ("largest sizes over depth (m)", "最大绝对值沿深度 (m) 的分布"),
    ("strain εzz", "应变 εzz"),
    ("shear strain γ{axis}z", "剪应变 γ{axis}z"),
    ("{name}, {axis}", "{name}，{axis}"),
];
