//! Of response spectra.

use super::Texts;

pub const TEXTS: Texts = &[
    ("spectral acceleration, 5 % damping", "谱加速度，阻尼比 5 %"),
    ("{name}, along {axis}", "{name}，{axis} 向"),
    ("period", "周期"),
    ("motion given", "给定地震动"),
    ("free field, surface", "自由场地表"),
    ("free field, base", "自由场底部"),
    ("Response spectra of the motion that comes in", "输入地震动的反应谱"),
    (
        " Drawn and listed are the {most} of {all} monitors with the largest spectra; spectra.csv has all.",
        "共 {all} 个监测点，只绘出并列出反应谱幅值最大的 {most} 个；全部见 spectra.csv。",
    ),
    (
        "Largest acceleration of an oscillator of each period with 5 % of critical damping (ω² times its largest displacement). \
         Compare the motion given with the spectrum that the design calls for. The surface of level rock that is neither damped \
         nor layered would have twice the incident wave's. Numbers: spectra.csv.",
        "各周期单自由度振子（阻尼比 5 %）的最大拟加速度（ω² 乘以最大位移）。请将给定地震动与设计要求的反应谱比较。无阻尼、不分层的水平岩体，\
         其地表反应谱为入射波的两倍。数值见 spectra.csv。",
    ),
    ("equivalent-linear column, surface", "一维等效线性土层地表"),
    (
        " The ground can yield: the equivalent-linear column of its own laws stands beside its surface. Where shaking is weak the two \
         agree; where it is strong that column is an approximation, which may damp short periods too much.",
        "地层可能屈服：其地表旁列出由相同本构求得的一维等效线性土层。震动弱时两者一致；震动强时一维等效线性土层只是近似，可能对短周期阻尼过大。",
    ),
    ("Response spectra at the monitors", "监测点的反应谱"),
    (
        "The folder has no spectra.csv: an older version ran, or the run has not ended. Run the case again to have \
         spectra of the monitors beside those of the free field.",
        "结果文件夹中没有 spectra.csv：由旧版本计算，或计算尚未结束。重新计算即可得到监测点与自由场的反应谱。",
    ),
    ("spectra.csv holds no monitor that moves.", "spectra.csv 中没有运动的监测点。"),
    (
        "Spectral acceleration with 5 % damping, all on one scale. Each monitor is drawn full; dashed is the free field at its own \
         level, which is how the ground would move there without caverns.",
        "谱加速度，阻尼比 5 %，各图比例相同。实线为监测点；虚线为同一高程的自由场，即无洞室时该处的运动。",
    ),
    (
        " Where the monitor rises above it at periods from {short} on, the cavern or the lining rings at that period or \
         amplifies the wave; where it stays below, the cavern shields it.",
        "周期不小于 {short} 时，监测点高于自由场处，洞室或衬砌在该周期共振或放大；低于自由场处，洞室起屏蔽作用。",
    ),
    (
        "Spectral acceleration with 5 % damping, all on one scale. No column of ground stood beside the model, so there is no \
         free field to compare with.",
        "谱加速度，阻尼比 5 %，各图比例相同。模型旁没有自由场柱，故无自由场可比。",
    ),
    ("free field at the monitor's level", "监测点高程处的自由场"),
    (
        "Of the accelerations between rows of the histories, {interval} apart, of the monitors and of the free field alike. \
         Rows so far apart show short periods too low, by 20 % at the shortest that is drawn, five rows, and by 5 to 9 % at {short}, \
         ten rows: the table has the largest from there on. Short periods that the motion given does not have come from cracks \
         and joints that open and close, sampled by the rows.",
        "由时程输出行（间隔 {interval}）之间的加速度求得，监测点与自由场相同。输出间隔使短周期谱值偏低：最短周期（5 行）约低 20 %，{short}（10 行）低 5～9 %，\
         故表中最大值自该周期起取。给定地震动所没有的短周期成分来自裂缝与接触面的开合及其按行取样。",
    ),
    ("largest from ten rows a period on", "最大（每周期不少于 10 行）"),
    ("at period (s)", "对应周期 (s)"),
    ("free field at its level", "同高程自由场"),
];
