//! Of the motion that a case gives.

use super::Texts;

pub const TEXTS: Texts = &[
    ("The motion that comes in", "输入地震动"),
    ("acceleration along {axis}", "{axis} 向加速度"),
    ("acceleration", "加速度"),
    ("velocity", "速度"),
    ("displacement", "位移"),
    ("motion.csv holds no motion.", "motion.csv 中没有地震动。"),
    ("Velocity and displacement that come in", "输入的速度与位移"),
    (
        "The same motion, integrated. Velocity and displacement should end near zero; the model follows any drift.",
        "同一地震动积分所得。速度与位移在结束时应接近零；若有漂移，模型将随之整体移动。",
    ),
    ("{peak} along {axis}", "{axis} 向 {peak}"),
    (", ", "、"),
    (
        "As the case gives it, windowed, filtered and turned into the model's axes; largest {peaks}.",
        "算例给定的地震动，经截取、滤波并转至模型坐标轴；最大值：{peaks}。",
    ),
    (
        "It is taken as {kind}: the wave that comes up through the base is {factor} times this.",
        "按{kind}处理：自底部入射的上行波为其 {factor} 倍。",
    ),
];
