//! The verdict.

use super::Texts;

pub const TEXTS: Texts = &[
    (
        "{count} further structures that fared no worse; of them {worst}",
        "另有 {count} 个结构，情况不比以上更差；其中 {worst}",
    ),
    ("Does the lining stand?", "衬砌能否经受住地震？"),
    ("Not known: there is no summary of the run.", "未知：没有本次计算的摘要。"),
    ("Not known: the run failed.", "未知：计算失败。"),
    (
        "The run has not ended, and cracks already run through its thickness.",
        "计算尚未结束，但裂缝已贯穿衬砌厚度。",
    ),
    ("Not known yet: the run has not ended.", "尚未可知：计算没有结束。"),
    ("Not judged: no structure of this run can crack.", "未作判断：本次计算中没有会开裂的结构。"),
    ("Not unharmed: cracks run through its thickness.", "受损：裂缝贯穿衬砌厚度。"),
    ("It is cracked, but nowhere through its thickness.", "已开裂，但没有一处贯穿厚度。"),
    ("It is undamaged; no earthquake has come.", "未损伤；尚未经历地震。"),
    ("It is undamaged.", "未损伤。"),
    ("The run left no summary, so nothing is checked.", "本次计算没有留下摘要，因此未作任何检查。"),
    ("The run failed: what follows is not to be trusted.", "计算失败：以下结果不可信。"),
    ("The run was stopped before its end.", "计算在结束前被中止。"),
    ("The run is done, but nothing was checked.", "计算已完成，但未作任何检查。"),
    (
        "The run can be trusted as far as it checks itself: {passed} of {judged} checks pass.",
        "就自检而言计算可信：{judged} 项检查中 {passed} 项通过。",
    ),
    (
        "The run is done; {passed} of {judged} checks pass: look at the others first.",
        "计算已完成；{judged} 项检查中 {passed} 项通过：请先查看其余各项。",
    ),
    ("{group}: undamaged.", "{group}：未损伤。"),
    (
        "{group}: cracked in {cracked} of its volume, through the thickness at {through} of {places} places; widest crack {opening}.",
        "{group}：开裂体积占 {cracked}，{places} 处中有 {through} 处贯穿厚度；最大裂缝宽度 {opening}。",
    ),
    (
        "{group}: cracked in {cracked} of its volume, nowhere through the thickness; widest crack {opening}.",
        "{group}：开裂体积占 {cracked}，没有一处贯穿厚度；最大裂缝宽度 {opening}。",
    ),
    ("{group}: cracked in {cracked} of its volume.", "{group}：开裂体积占 {cracked}。"),
    ("Interface {name}: neither slid nor opened.", "接触面 {name}：未滑移，也未张开。"),
    (
        "Interface {name}: slid over {slid} and opened over {opened} of its area.",
        "接触面 {name}：滑移面积占 {slid}，张开面积占 {opened}。",
    ),
    (
        "Bolts {name}: {yielded} of {all} yielded, {broken} broke.",
        "锚杆 {name}：{all} 根中 {yielded} 根屈服，{broken} 根断裂。",
    ),
    (
        "{name}: yielded in shear in {shear} and in tension in {tension} of its volume.",
        "{name}：剪切屈服体积占 {shear}，受拉屈服体积占 {tension}。",
    ),
    ("{first} {second}", "{first}{second}"),
    (
        "Monitors {pair} moved by up to {most} against each other, at {time}\u{a0}s; {left} at the end.",
        "监测点 {pair} 的相对位移最大为 {most}（{time}\u{a0}s）；结束时为 {left}。",
    ),
];
