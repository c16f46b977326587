//! Of the section forces of linings.

use super::Texts;

pub const TEXTS: Texts = &[
    ("{lining}: forces along it, and pairs of N and M", "{lining}：沿衬砌的内力及 N、M 组合"),
    (
        " They are of total stress. A lining with pores stands a second time, as 'effective', with forces of the stress that its material feels, total and the pressure in its pores; in concrete without pores the two are the same.",
        "内力按总应力积分。有孔隙的衬砌另列一次，名称带 effective，为其材料所受有效应力（总应力加孔压）的内力；无孔隙的混凝土两者相同。",
    ),
    ("N, thrust, tension positive (kN/m)", "轴力 N，受拉为正 (kN/m)"),
    ("M, moment (kN\u{a0}m/m)", "弯矩 M (kN\u{a0}m/m)"),
    ("Q, shear (kN/m)", "剪力 Q (kN/m)"),
    ("after {stage}", "{stage}之后"),
    ("after stage {name}", "阶段“{name}”之后"),
    ("before the shaking", "地震前"),
    ("Section forces of the linings", "衬砌内力"),
    (
        "Integrated through the thickness, a metre of the cavern's length. Tension is positive; a positive \
         moment stretches the intrados; where shear is positive, what comes next, going round by the wall of \
         greater x over the crown, pushes towards the intrados. The table has the extremes of all stations of a \
         lining, with time and place (x, y, z in m). Look where the moment is large while the thrust is small or \
         pulls: there the lining cracks first.",
        "沿厚度积分，按洞室轴向每米计。拉为正；正弯矩使内侧受拉；自 x 较大一侧墙脚起，沿衬砌绕顶拱行进；前方截面受指向洞内的\
         剪力时 Q 为正。表中为每个衬砌所有计算截面的极值及其时刻和位置（x、y、z，m）。应注意弯矩大而轴压力小或受拉\
         之处：衬砌首先在此开裂。",
    ),
    (
        " Each of N, M and Q has its largest and smallest value at a time of its own: the envelope is no state \
         that the lining was ever in.",
        "N、M、Q 的最大值和最小值各有其发生时刻：包络线并非衬砌在某一时刻的真实状态。",
    ),
    (" The file holds no extremes of the shaking.", "文件中没有地震过程的极值。"),
    ("No figure: fewer than two stations have numbers.", "无图：有数值的计算截面少于两个。"),
    ("after the stages", "施工阶段结束时"),
    ("while the ground shakes", "地震过程中"),
    ("lining", "衬砌"),
    ("{lining}: forces along the lining", "{lining}：内力沿衬砌的分布"),
    ("largest while the ground shakes", "地震过程中最大值"),
    ("smallest while the ground shakes", "地震过程中最小值"),
    ("wall of greater x", "x 较大侧边墙"),
    ("wall of smaller x", "x 较小侧边墙"),
    ("along the lining", "沿衬砌的距离"),
    (
        "Section y = {y}\u{a0}m, {number} stations going round from below by the wall of greater x over the \
         crown. Lines break where stations are missing, as where walls meet.",
        "断面 y = {y}\u{a0}m，共 {number} 个计算截面，自下方经 x 较大一侧的边墙绕过顶拱。在没有计算截面处（如墙体相交处）\
         曲线断开。",
    ),
    (
        " What lies between the line after the stages and those of the shaking is what the earthquake adds.",
        "施工阶段结束时的曲线与地震过程各曲线之间的差值，即地震所增加的内力。",
    ),
    ("thrust, moment and shear over the length along the lining", "轴力、弯矩和剪力沿衬砌长度的分布"),
    (
        "{lining}: forces on the lining's shape at y = {y}\u{a0}m",
        "{lining}：衬砌断面上的内力图，y = {y}\u{a0}m",
    ),
    (
        "Section y = {y}\u{a0}m; to the left x is smaller. The thin line is the middle of the lining. N is drawn \
         outwards where it compresses, Q where it is positive, M on the side that it stretches; each of the \
         three has a scale of its own, set by its largest value. Look where M peaks, and whether N still \
         compresses there.",
        "断面 y = {y}\u{a0}m，左侧 x 较小。细线为衬砌中线。N 受压时画在外侧，Q 为正时画在外侧，M 画在受拉一侧；三\
         者各按其最大值取比例尺。应注意弯矩 M 的峰值处轴力 N 是否仍为压力。",
    ),
    ("thrust, moment and shear on the section of the lining", "衬砌断面上的轴力、弯矩和剪力"),
    ("between which values each station went while the ground shook", "各计算截面在地震过程中的变化范围"),
    ("{lining}: M, moment (kN\u{a0}m/m), over N, thrust", "{lining}：弯矩 M (kN\u{a0}m/m) 与轴力 N 的关系"),
    ("N (kN/m), tension positive", "N (kN/m)，拉为正"),
    (
        " Every pair of N and M that a station had lies in its box; the corners need not have occurred together.",
        "计算截面出现过的每一对 N、M 都在其方框内；方框的角点不一定同时出现。",
    ),
    (
        " Boxes are those of the section drawn above: every pair of N and M that a station had lies in its box; \
         the corners need not have occurred together. The extremes of all sections are in the table.",
        "方框为上图断面的计算截面：计算截面出现过的每一对 N、M 都在其方框内；方框的角点不一定同时出现。所有断面的极值见表。",
    ),
    (
        "All {number} stations of the lining, all sections.{shaken} Right of N = 0 a section is pulled. N and M \
         are those of the concrete and of bars in it together.",
        "衬砌所有断面的全部 {number} 个计算截面。{shaken}N = 0 以右截面受拉。N、M 为混凝土及其中钢筋的合力。",
    ),
    ("moment over thrust at each station", "各计算截面的弯矩与轴力"),
];
