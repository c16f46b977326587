//! Of what the result files lack.

use super::Texts;

pub const TEXTS: Texts = &[
    (
        "The run has not come to the earthquake: it ended in the stages before it, or is still in them.",
        "计算尚未进入地震阶段：在此前的施工阶段中结束，或仍在其中。",
    ),
    (
        "None: the case has no [motion]. This is a static study, and the stages are all of it.",
        "无：算例没有 [motion]。这是静力分析，仅含施工阶段。",
    ),
    (
        "There is no summary.json: the run is still under way, or it was killed.",
        "没有 summary.json：计算仍在进行，或已被终止。",
    ),
    ("{file} has no rows yet.", "{file} 尚无数据行。"),
    ("There is no {file} in the result folder.", "结果文件夹中没有 {file}。"),
    ("{file} has no column {key}.", "{file} 没有 {key} 列。"),
];
