//! Of what became of structures.

use super::Texts;

pub const TEXTS: Texts = &[
    ("no bar yielded", "钢筋均未屈服"),
    ("bars yielded, none broke", "有钢筋屈服，无断裂"),
    ("bars yielded and broke", "有钢筋屈服并断裂"),
    ("bars, which never yield", "钢筋（不屈服）"),
    ("bars broke", "有钢筋断裂"),
    (
        "The number of cracks over a length, and so their width, depends on the mesh.",
        "多少条裂缝分担一段张开量、每条有多宽，取决于网格。",
    ),
    // Joints of phrases.
    ("{group}: {headline}", "{group}：{headline}"),
    ("{first} {rest}", "{first}{rest}"),
    ("{first}, {rest}", "{first}，{rest}"),
    ("{first}; {rest}", "{first}；{rest}"),
    // Damage.
    ("undamaged", "未损伤"),
    ("hardly damaged", "几乎未损伤"),
    ("cracked", "开裂"),
    ("crushed or sheared", "压碎或剪切破坏"),
    ("mean principal damage", "平均主损伤"),
    ("yielded in shear", "剪切屈服"),
    ("yielded in tension", "受拉屈服"),
    ("{measure} in {percent} % of its volume", "{percent} % 的体积{measure}"),
    ("{measure} in less than 0.1 % of its volume", "不足 0.1 % 的体积{measure}"),
    ("through the thickness at {through} of {places} places", "贯穿性裂缝 {through}/{places} 处"),
    (
        "The widest of these cracks is in element {element} at {place}.",
        "其中张开最大的是单元 {element}，位于 {place}。",
    ),
    ("No crack runs through the thickness.", "没有裂缝贯穿厚度。"),
    (
        "Cracks open beyond {limit} mm, widest at {time} s in element {element} at {place}: pieces have come loose, and this model does not follow them.",
        "裂缝宽度超过 {limit} mm，最宽处出现在 {time} s，单元 {element}，位于 {place}：已有块体松脱，本模型不能模拟其后的运动。",
    ),
    (
        "Widest crack {opening} mm, at {time} s in element {element} at {place}.",
        "最大裂缝宽度 {opening} mm，出现在 {time} s，单元 {element}，位于 {place}。",
    ),
    ("Across the bars round the ring {opening} mm at most.", "与环向钢筋相交的裂缝最大 {opening} mm。"),
    ("Across the bars along the axis {opening} mm at most.", "与纵向钢筋相交的裂缝最大 {opening} mm。"),
    ("Where walls meet {opening} mm at most.", "墙体交接处最大 {opening} mm。"),
    (
        "Parallel to the wall {opening} mm at most: no bar of the section crosses these.",
        "平行于壁面的裂缝最大 {opening} mm：没有截面钢筋与之相交。",
    ),
    (
        "First {measure} at {time} s in element {element} at {place}.",
        "{time} s 首次{measure}，单元 {element}，位于 {place}。",
    ),
    ("First {measure} before the earthquake.", "地震前已首次{measure}。"),
    // Interfaces.
    ("the interface neither slid nor opened on its {area} m²", "接触面在其 {area} m² 上既未滑移也未张开"),
    (
        "At {nodes} nodes, where it meets linings or its own ends, it cannot slide.",
        "在 {nodes} 个节点处（与衬砌相接处或其自身端部），接触面不能滑移。",
    ),
    ("the interface slid over {slid} % of its {area} m²", "接触面 {area} m² 中有 {slid} % 发生滑移"),
    ("the interface opened over {opened} % of its {area} m²", "接触面 {area} m² 中有 {opened} % 张开"),
    (
        "the interface slid over {slid} % and opened over {opened} % of its {area} m²",
        "接触面 {area} m² 中有 {slid} % 发生滑移、{opened} % 张开",
    ),
    ("Largest slip {slip} at {slip_at}.", "最大滑移量 {slip}，位于 {slip_at}。"),
    ("Largest gap {gap} at {gap_at}.", "最大张开量 {gap}，位于 {gap_at}。"),
    (
        "Largest slip {slip} at {slip_at}, largest gap {gap} at {gap_at}.",
        "最大滑移量 {slip}，位于 {slip_at}；最大张开量 {gap}，位于 {gap_at}。",
    ),
    // Bolts.
    ("excavations removed its one bolt", "仅有的一根锚杆已被开挖挖除，无剩余"),
    ("excavations removed all of its {bolts} bolts", "{bolts} 根锚杆均已被开挖挖除，无剩余"),
    ("its one bolt did not yield", "仅有的一根锚杆未屈服"),
    ("none of {bolts} bolts yielded", "{bolts} 根锚杆均未屈服"),
    ("{yielded} of {bolts} bolts yielded, none broke", "{bolts} 根锚杆中 {yielded} 根屈服，无断裂"),
    ("none of {bolts} bolts yielded, {broken} broke", "{bolts} 根锚杆中无屈服，{broken} 根断裂"),
    (
        "{yielded} of {bolts} bolts yielded, {broken} broke",
        "{bolts} 根锚杆中 {yielded} 根屈服，{broken} 根断裂",
    ),
    ("its one bolt never yields", "仅有的一根锚杆按不屈服计算"),
    ("{bolts} bolts, which never yield", "{bolts} 根锚杆，按不屈服计算"),
    ("{broken} of {bolts} bolts broke", "{bolts} 根锚杆中 {broken} 根断裂"),
    ("largest force {share} of yield", "最大轴力为屈服轴力的 {share}"),
    ("largest force {force}", "最大轴力 {force}"),
    ("{force} of compression", "{force}（受压）"),
    ("{force}", "{force}"),
    ("The bond of {slid} slid; largest slip {slip}.", "{slid} 根的粘结发生滑移；最大滑移量 {slip}。"),
    ("Excavations cut {cut}.", "开挖切断 {cut} 根。"),
    ("Excavations cut {cut} and removed {gone} of these.", "开挖切断 {cut} 根，其中 {gone} 根完全挖除。"),
    ("row {row} of the bars", "第 {row} 排钢筋"),
    ("row {row} of the bars '{group}'", "“{group}”的第 {row} 排钢筋"),
    ("bolt {bolt}", "{bolt} 号锚杆"),
    ("bolt {bolt} of '{group}'", "“{group}”的 {bolt} 号锚杆"),
    ("Largest force {force} in {bolt} at {place}.", "最大轴力 {force}，{bolt}，位于 {place}。"),
    (
        "Largest force {force} in {bolt} at {place} at {time} s.",
        "最大轴力 {force}，{bolt}，位于 {place}，时刻 {time} s。",
    ),
    (
        "Largest force {force} in {bolt} at {place} in the stage '{stage}'.",
        "最大轴力 {force}，{bolt}，位于 {place}，出现在阶段“{stage}”。",
    ),
];
