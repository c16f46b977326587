//! Of damage and yielding.

use super::Texts;

pub const TEXTS: Texts = &[
    ("before the earthquake", "地震前"),
    (" ", ""),
    ("Cracked, D⁺", "开裂，D⁺"),
    ("Crushed or sheared, D⁻", "压碎或剪切破坏，D⁻"),
    ("Mean of the principal directions, D_b", "三个主方向平均，D_b"),
    ("Yielded in shear", "剪切屈服"),
    ("Yielded in tension", "受拉屈服"),
    ("Damage of concrete", "混凝土损伤"),
    ("Yielding of rock: plastic strain", "围岩屈服：塑性应变"),
    (
        "D_b, the mean of the damage in the three principal directions, is not listed where it equals D⁺.",
        "D_b（三个主方向损伤的平均值）与 D⁺ 相等时不列出。",
    ),
    ("Measures that stayed zero are not listed.", "始终为零的量不列出。"),
    ("element\u{a0}{element} ({x},\u{a0}{y},\u{a0}{z})", "单元\u{a0}{element} ({x},\u{a0}{y},\u{a0}{z})"),
    ("{through} of {all}", "{all} 处中 {through} 处"),
];
