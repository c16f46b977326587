//! Of moment over thrust against strength.

use super::Texts;

pub const TEXTS: Texts = &[
    ("{lining}: N and M against the strength of the sections", "{lining}：N、M 与截面承载力"),
    ("each station at its largest utilisation", "各断面利用率最大时"),
    ("{thickness} m, without bars ({stations} stations)", "厚 {thickness} m，无筋（{stations} 个断面）"),
    (
        "{thickness} m, bars {inner} + {outer} mm²/m ({stations} stations)",
        "厚 {thickness} m，内侧钢筋 {inner} mm²/m，外侧 {outer} mm²/m（{stations} 个断面）",
    ),
    ("N (kN/m), tension positive; upwards M (kN\u{a0}m/m)", "N（kN/m），受拉为正；纵轴 M（kN\u{a0}m/m）"),
    (
        "Design strength by {code}, bars (inside + outside) included; each point is N and M of one instant. Inside its line a section bears them.",
        "按 {code} 的设计承载力，计入钢筋；每点为同一时刻的 N 与 M。点在本断面的包络线以内时，断面可以承受。",
    ),
    (
        " The lines have the concrete's strength of the earthquake, {dynamic} times the static one by which the points after the stages are judged.",
        "包络线取地震中的混凝土强度，为静力强度的 {dynamic} 倍；施工完成后的各点按静力强度判断。",
    ),
    ("crack width left", "残余裂缝宽度"),
    ("crack width left, by code", "残余裂缝宽度（按规范）"),
    ("({x}, {y}, {z}) at the end", "({x}, {y}, {z})，结束时"),
    ("bars yield", "钢筋屈服"),
    (
        " Crack width left: EN 1992-1-1 7.3.4 with N and M at the end, the section cracked, lasting load (k_t 0.4); σ_s {stress}, s_r,max {spacing}.",
        "残余裂缝宽度：按 EN 1992-1-1 第 7.3.4 条，取结束时的 N、M，截面已开裂，长期荷载（k_t 0.4）；σ_s {stress}，s_r,max {spacing}。",
    ),
    (
        " For {without} stations with bars the clause has no width: a face without bars opens.",
        "有 {without} 个配筋断面在无筋一侧张开，该条不给出其裂缝宽度。",
    ),
    ("{lining}, left at the end, by EN 1992-1-1 7.3.4", "{lining}，结束时残余，按 EN 1992-1-1 第 7.3.4 条"),
    ("No strength is known for {lining}.", "{lining} 的强度未知。"),
    (
        "sections.csv holds no thickness and no thrust at the time of the largest moment.",
        "sections.csv 中没有厚度，也没有最大弯矩时刻的轴力。",
    ),
    ("elastic section: a fibre reaches f_t or f_c", "弹性截面：截面边缘达到 f_t 或 f_c"),
    ("cracked section: no tension, f_c in compression", "开裂后的截面：不计拉应力，受压区应力为 f_c"),
    (
        "largest M or N in the earthquake, with the other at that instant",
        "地震中弯矩与轴力的极值（另一内力取同一时刻）",
    ),
    ("{lining}: moment over thrust against strength", "{lining}：轴力—弯矩与截面强度"),
    ("N / (f_c t), tension positive; upwards M / (f_c t²)", "N / (f_c t)，受拉为正；纵轴 M / (f_c t²)"),
    (
        "f_c {compression} and f_t {tension}, static, t the thickness at each of {stations} stations. Outside the full line an \
         uncracked section cracks or crushes; a cracked one bears what lies inside the dashed line. Outside both plain concrete \
         cannot bear what is there, and what keeps it is reinforcement, which the lines leave out, or strength that grows with \
         the rate.",
        "静力强度 f_c {compression}，f_t {tension}；t 为各断面（共 {stations} 个）的厚度。实线以外，未开裂截面将开裂或压碎；\
         开裂后的截面可承受虚线以内的内力。两线以外，素混凝土无法承受，须靠图中未计入的钢筋，或随加载速率提高的强度。",
    ),
    (
        " Counted over the rows of sections.csv: when the stages are done {elastic} stations lie outside the full line, {ultimate} outside both.",
        "按 sections.csv 各行统计：施工完成时，{elastic} 个断面在实线以外，{ultimate} 个在两线以外。",
    ),
    (
        " At one of those extremes, counted over the same file: {elastic} and {ultimate}. There may be more cracks: N and M contain no stress along the cavern, and a cracked section no longer carries the forces that cracked it.",
        "在上述极值时刻（同一文件统计）分别为 {elastic} 个和 {ultimate} 个。开裂位置可能更多：N、M 不反映沿洞轴方向的应力，且已开裂的截面不再承受致裂时的内力。",
    ),
];
