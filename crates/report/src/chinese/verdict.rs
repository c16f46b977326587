//! The verdict.

use super::Texts;

pub const TEXTS: Texts = &[
    (
        "{count} more structures, none worse; of these {worst}",
        "另有 {count} 个结构，情况不比以上更差；其中 {worst}",
    ),
    ("Does the lining withstand the earthquake?", "衬砌能否经受住地震？"),
    ("Is the lining whole when the stages are done?", "施工完成时衬砌是否完好？"),
    ("The run was stopped before its end.", "计算在结束前被中止。"),
    ("{first} By parts: {parts}.", "{first}其中各部分：{parts}。"),
    ("{first} Before the earthquake: {share}.", "{first}地震前：{share}。"),
    ("{first} In shear that is {volume}.", "{first}其中剪切屈服体积为 {volume}。"),
    ("{group}: undamaged.", "{group}：未损伤。"),
    (
        "{group}: cracked in {cracked} of its volume, through the thickness at {through} of {places} places; {widest}.",
        "{group}：开裂体积占 {cracked}，贯穿性裂缝 {through}/{places} 处；{widest}。",
    ),
    (
        "{group}: cracked in {cracked} of its volume, nowhere through the thickness; {widest}.",
        "{group}：开裂体积占 {cracked}，没有一处贯穿厚度；{widest}。",
    ),
    ("widest crack {opening}", "最大裂缝宽度 {opening}"),
    ("widest crack {opening}, {direction}", "最大裂缝宽度 {opening}（{direction}）"),
    (
        "widest crack {opening}, parallel to the wall; none across bars",
        "最大裂缝宽度 {opening}（平行于壁面），无与钢筋相交的裂缝",
    ),
    (
        "widest crack across bars {across} ({direction}), parallel to the wall {parallel}",
        "与钢筋相交的裂缝最宽 {across}（{direction}），平行于壁面的最宽 {parallel}",
    ),
    ("{group}: cracked in {cracked} of its volume.", "{group}：开裂体积占 {cracked}。"),
    ("Interface {name}: neither slid nor opened.", "接触面 {name}：未滑移，也未张开。"),
    (
        "Interface {name}: slid over {slid} and opened over {opened} of its area.",
        "接触面 {name}：滑移面积占 {slid}，张开面积占 {opened}。",
    ),
    (
        "Interface {name}: slid over {slid} of its area, opened nowhere.",
        "接触面 {name}：滑移面积占 {slid}，没有张开。",
    ),
    (
        "Interface {name}: opened over {opened} of its area, slid nowhere.",
        "接触面 {name}：张开面积占 {opened}，没有滑移。",
    ),
    ("Largest slip {slip}.", "最大滑移量 {slip}。"),
    ("Largest gap {gap}.", "最大张开量 {gap}。"),
    ("Largest slip {slip}, largest gap {gap}.", "最大滑移量 {slip}，最大张开量 {gap}。"),
    (
        "Bolts of {groups} groups: none of {all} yielded; largest force {share} of yield, in {name}.",
        "{groups} 组锚杆：{all} 根均未屈服；最大轴力为屈服力的 {share}，位于 {name}。",
    ),
    (
        "Reinforcement {name}: no bar yielded in the elastic model, whose concrete takes tension without cracking.",
        "{name} 的钢筋：弹性模型中均未屈服，但其混凝土受拉而不开裂。",
    ),
    ("Reinforcement {name}: no bar yielded.", "{name} 的钢筋：均未屈服。"),
    (
        "Reinforcement {name}: no bar yielded, as a mean over an element; largest force {share} of yield.",
        "{name} 的钢筋：按单元平均均未屈服；最大轴力为屈服力的 {share}。",
    ),
    ("{first} Crushed or sheared in {share} of its volume.", "{first}压碎或剪切破坏体积占 {share}。"),
    ("Reinforcement {name}: bars yielded, none broke.", "{name} 的钢筋：有屈服，无拉断。"),
    ("Reinforcement {name}: bars yielded and broke.", "{name} 的钢筋：有屈服并有拉断。"),
    ("walls", "边墙"),
    ("in thrust and moment", "轴力与弯矩"),
    ("Bolts {name}: none of {all} yielded.", "锚杆 {name}：{all} 根均未屈服。"),
    (
        "Bolts {name}: {yielded} of {all} yielded, none broke.",
        "锚杆 {name}：{all} 根中 {yielded} 根屈服，无一断裂。",
    ),
    (
        "Bolts {name}: {yielded} of {all} yielded, {broken} broke.",
        "锚杆 {name}：{all} 根中 {yielded} 根屈服，{broken} 根断裂。",
    ),
    (
        "{name}: yielded in shear in {shear} and in tension in {tension} of its volume.",
        "{name}：剪切屈服体积占 {shear}，受拉屈服体积占 {tension}。",
    ),
    (
        "{name}: yielded in shear in {volume}, {shear} of its volume.",
        "{name}：剪切屈服体积 {volume}，占 {shear}。",
    ),
    ("{name}: yielded in shear in {shear} of its volume.", "{name}：剪切屈服体积占 {shear}。"),
    ("{name}: yielded in tension in {tension} of its volume.", "{name}：受拉屈服体积占 {tension}。"),
    ("{first} {second}", "{first}{second}"),
    (
        "Monitors {pair} moved by up to {most} against each other, at {time}\u{a0}s; {left} at the end.",
        "监测点 {pair} 的相对位移最大为 {most}（{time}\u{a0}s）；结束时为 {left}。",
    ),
    (
        "{first} Not counted: {pairs}, of which a monitor is on a broken element.",
        "{first}未计入：{pairs}，其中有监测点位于断裂单元上。",
    ),
];
