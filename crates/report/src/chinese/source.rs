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
];
