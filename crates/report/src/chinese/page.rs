//! Of the page's template.

use super::Texts;

pub const TEXTS: Texts = &[("Can these results be trusted?", "结果是否可信？")];
