//! Of the model in three dimensions.

use super::Texts;

pub const TEXTS: Texts = &[
    ("The view is left out. {why}.", "三维视图从略。{why}。"),
    ("Interfaces are left out. {why}.", "接触面从略。{why}。"),
    ("interface {number}", "接触面 {number}"),
    ("body {number}", "实体 {number}"),
    ("stage {number}", "施工步 {number}"),
    ("{name} and {number} more groups", "{name} 及另外 {number} 个单元组"),
    (
        "Not among the fields of {part}, since they have one value throughout: {fields}. A 0 may also mean that its material does not know the quantity.",
        "下列场量在 {part} 中处处、时时为同一值，故未列出：{fields}。值为 0 也可能表示其材料没有该量。",
    ),
    (
        "To keep the page small the ground is shown at one time in {every} only, the last included; linings and interfaces at all times.",
        "为控制页面大小，围岩每 {every} 个时刻只显示一个（含最后时刻）；衬砌和接触面显示全部时刻。",
    ),
    (
        "To keep the page small these fields of the ground are left out: {fields}.",
        "为控制页面大小，未列入围岩的下列场量：{fields}。",
    ),
    (
        "To keep the page small the displacement of the ground is left out.",
        "为控制页面大小，未列入围岩的位移。",
    ),
    (
        "The view takes {size} MB of the page, more than the {budget} MB meant for it.",
        "三维视图占页面 {size} MB，超出为其预留的 {budget} MB。",
    ),
    (
        "Vectors and tensors other than the displacement are not in the view; {folder} and interfaces/*.vtu hold them: {names}.",
        "除位移外，矢量和张量不在三维视图中，见 {folder} 和 interfaces/*.vtu：{names}。",
    ),
    (
        "Vectors and tensors other than the displacement are not in the view; {folder} holds them: {names}.",
        "除位移外，矢量和张量不在三维视图中，见 {folder}：{names}。",
    ),
    (
        "Arrows beside the axes are the waves: each points along the wave's way in the rock of the base, and the thin line across or along it is the direction in which the wave moves the rock.",
        "坐标轴旁的箭头为入射波：箭头指向波在基底岩体中的传播方向，细线为质点的振动方向。",
    ),
    (
        "Lines with arrows in the model are flow lines of the water below the free surface, those beside a cut plane alone where one is set; the closer they lie, the more water flows. The field seepage of the files holds the discharge.",
        "模型中带箭头的线为浸润面以下的流线；设有剖切面时只显示剖切面附近的流线。流线越密，渗流量越大；比流量的数值见结果文件中的 seepage。",
    ),
    ("largest principal stress s1", "第一主应力 s1"),
    ("smallest principal stress s3", "第三主应力 s3"),
    ("largest effective principal stress", "第一有效主应力"),
    ("smallest effective principal stress", "第三有效主应力"),
    ("largest s1 so far", "历史最大的 s1"),
    ("smallest s3 so far", "历史最小的 s3"),
    ("largest displacement so far", "历史最大位移"),
    ("damage in tension", "受拉损伤"),
    ("damage in shear", "受剪损伤"),
    ("mean damage D_b now: closed cracks count less", "当前平均损伤 D_b"),
    ("largest mean damage D_b so far", "历史最大平均损伤 D_b"),
    ("widest crack so far", "历史最大裂缝宽度"),
    ("plastic shear strain", "塑性剪应变"),
    ("plastic tension strain", "塑性拉应变"),
    ("plastic state", "塑性状态"),
    ("plastic strain along x", "沿 x 的塑性应变"),
    ("plastic strain along y", "沿 y 的塑性应变"),
    ("plastic strain along z", "沿 z 的塑性应变"),
    ("plastic shear strain in xy", "xy 面塑性剪应变"),
    ("plastic shear strain in yz", "yz 面塑性剪应变"),
    ("plastic shear strain in zx", "zx 面塑性剪应变"),
    ("gap now", "当前张开"),
    ("largest gap so far", "历史最大张开"),
    ("largest slip so far", "历史最大滑移"),
    ("pressure now", "当前压力"),
    ("largest pressure so far", "历史最大压力"),
    ("state of the interface", "接触面状态"),
    ("slid so far (1)", "曾滑移 (1)"),
    ("opened so far (1)", "曾张开 (1)"),
    ("area of a pair", "接触对面积"),
];
