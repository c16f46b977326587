//! Of the checks of what a model leaves out: near sides, motion not run, damping by mass, rows, linings' interfaces.

use super::Texts;

pub const TEXTS: Texts = &[
    (
        "stress change at the model's sides and base over the initial stress",
        "模型侧面与底面处应力变化与初始应力之比",
    ),
    (
        "no opening lies beside a boundary that represents continuing ground",
        "没有代表延伸地层的边界位于洞室旁",
    ),
    (
        "an opening reaches every boundary that represents continuing ground",
        "洞室穿过了所有代表延伸地层的边界",
    ),
    (
        "largest change that the stages cause beside {side}, over the mean stress along the openings before: a boundary that cannot move holds the ground back, and stresses around the opening are wrong by half of this and more; {distance} m from an opening of {extent} m it is {estimate} % by 1.5 (R/(R + d))²",
        "各施工阶段在 {side} 旁引起的最大应力变化与开挖前洞室周边平均应力之比：该处不能变形，应力被反射回来，洞室周边应力的误差为其一半以上；距 {extent} m 的洞室 {distance} m 时按 1.5 (R/(R + d))² 为 {estimate} %",
    ),
    (
        "change of residual displacement in the last second over the residual",
        "残余位移在最后一秒内的变化与残余位移之比",
    ),
    ("no monitor has a residual displacement", "没有测点具有残余位移"),
    ("the motion goes on after the end of the run", "计算结束之后运动仍在继续"),
    (
        "{history}: {residual} m at the end, and it still grows: give a longer `dynamic.duration`; with `base = \"viscous-spring\"` \
         compare base = \"viscous\" or wider `sides` as well",
        "{history}：结束时为 {residual} m，且仍在变化：请增大 `dynamic.duration`；若 `base = \"viscous-spring\"`，另请以 base = \"viscous\" 或更宽的 `sides` 作比较",
    ),
    ("share of the motion after the end of the run", "计算结束之后尚未输入的运动所占比例"),
    (
        "of ∫a² dt, behind {end} s of {whole} s: the run ends before this motion comes, and the largest values may come with it",
        "按 ∫a² dt 计，全长 {whole} s 中 {end} s 之后的部分：其后的运动未曾作用，最大值可能尚未出现",
    ),
    ("damping ratio by mass at the motion's central frequency", "质量比例阻尼在输入运动中心频率处的阻尼比"),
    ("no damping is proportional to mass", "没有质量比例阻尼"),
    (
        "ω/(4πf) with {mass} 1/s and {frequency} Hz, below which half of the input's energy lies: it damps the motion of the ground as a whole, slow motion most; damping over a band takes the same share at every frequency of the band",
        "ω/(4πf)，其中 ω = {mass} 1/s，f = {frequency} Hz（输入能量的一半在此频率以下）：它阻尼地层的整体运动，运动越慢阻尼越大；频带阻尼才与岩体相符",
    ),
    ("largest share of a peak that the rows of the histories miss", "时程各行遗漏的峰值的最大比例"),
    ("all monitors that move are on broken elements", "没有不在断裂单元上且发生运动的监测点"),
    (
        "{history}: rows {interval} s apart show {rows} where a step has {steps}, in SI; largest stresses, section forces and crack widths are taken from rows as well: give a shorter `output.histories`",
        "{history}：间隔 {interval} s 的各行给出 {rows}，而某一步为 {steps}（国际单位）；最大应力、截面内力与裂缝宽度同样取自各行：请减小 `output.histories`",
    ),
    (
        "compliance of a lining's interface over that of the ground round the opening",
        "衬砌接触面闭合量与洞室变形量之比",
    ),
    ("no lining has an interface whose stiffness was given", "没有给定刚度的衬砌接触面"),
    (
        "at equal pressure, unloaded: {given} GPa/m beside the {ground} GPa/m of an opening of {radius} m radius, 2G/R; so soft a layer keeps the ground's motion from the lining: see that a test says so, or leave `normal_stiffness` out",
        "等压力下、未加载时：给定 {given} GPa/m，而半径 {radius} m 的洞室为 {ground} GPa/m（2G/R）；这样软的夹层使地层的运动传不到衬砌：请确认有试验依据，或不给 `normal_stiffness`",
    ),
];
