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
    (
        "{largest} times in {lining}, {first} where cracking began",
        "{lining} {largest} 倍（最先开裂处 {first} 倍）",
    ),
    ("{largest} times in {lining}", "{lining} {largest} 倍"),
    ("Where it cracked its tensile strength was up to {told}.", "开裂处的抗拉强度最高为静态值的：{told}。"),
    ("Strength by the rate of strain", "应变速率对强度的提高"),
    ("times the static strength", "静态强度的倍数"),
    ("mean of what is damaged", "损伤部分平均"),
    ("where damage began", "最先损伤处"),
    (
        "How many times its static strength concrete had when a point was first damaged, since it was strained fast: that of tension where it cracked, that of compression where it was crushed or sheared. The factor of a point stays what it was then.",
        "混凝土某点首次损伤时，因应变速率高，其强度为静态值的倍数：开裂取抗拉强度，压碎或剪切破坏取抗压强度。该倍数此后保持不变。",
    ),
    ("{through} of {all}", "{all} 处中 {through} 处"),
];
