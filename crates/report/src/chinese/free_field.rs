//! Of the free field.

use super::Texts;

pub const TEXTS: Texts = &[
    ("Incident motion and free field", "输入波与自由场响应"),
    ("free_field.csv has no columns of velocities.", "free_field.csv 中没有速度列。"),
    ("free_field.csv holds no motion.", "free_field.csv 中没有运动。"),
    (" Not drawn: {axis}, nowhere more than {size}.", "未画 {axis} 向：处处不超过 {size}。"),
    (" Not drawn: {axis}, zero.", "未画 {axis} 向：为零。"),
    (
        " The thin line of the column should lie on the broad one of theory wherever the ground does not yield.",
        "围岩未屈服时，自由场柱的细线应与理论解的粗线重合。",
    ),
    (
        " Beside ground that yields stands its equivalent-linear column: layers with the modulus and damping that the same laws show at 0.65 \
         of their largest strain. It keeps no lasting displacement and may damp what is fast too much, so nothing is judged by it.",
        "屈服地层旁列出其一维等效线性土层：各层取相同本构在最大应变的 0.65 倍处的模量与阻尼。它不含残余位移，对快变成分可能阻尼过大，故不作评判依据。",
    ),
    ("{column}, equivalent-linear", "{column}，等效线性"),
    ("Peaks of velocity of the columns", "自由场柱的速度峰值"),
    ("Peaks of velocity of the model at its corners", "模型角点的速度峰值"),
    ("incident wave", "入射波"),
    ("model, {place}", "模型，{place}"),
    ("{column}, as it moved", "{column}，计算"),
    ("{column}, theory", "{column}，理论"),
    ("{place}, velocity along {axis}", "{place}，{axis} 向速度"),
    (
        "Drawn is the corner of the model that is farthest from its column, {corner}, and that column, {column}.",
        "图中为与对应自由场柱相差最大的模型角点 {corner} 及该自由场柱 {column}。",
    ),
    ("Of the columns the first is drawn, {column}.", "图中为第一根自由场柱 {column}。"),
    (
        "Of the {number} columns the one farthest from the model is drawn, {column}.",
        "图中为 {number} 根自由场柱中与模型相差最大的 {column}。",
    ),
    (
        "Of the {number} columns the one farthest from theory is drawn, {column}.",
        "图中为 {number} 根自由场柱中与理论解相差最大的 {column}。",
    ),
    ("corner {name}", "角点 {name}"),
    ("mean of the four corners", "四个角点的平均"),
    ("base", "底部"),
    ("surface", "地表"),
    ("along", "方向"),
    ("beside {column}", "对应 {column}"),
    ("column", "自由场柱"),
    ("differs by (%)", "相差 (%)"),
    ("model", "模型"),
    ("model at", "模型位置"),
    ("peak", "峰值"),
    ("theory", "理论"),
    ("{number} columns of the same values", "{number} 根数值相同的自由场柱"),
    (
        " A column is named by the side outside which it stands, then by the end of that side.",
        "自由场柱的名称先为其所在侧边，后为该侧边的端部。",
    ),
    (
        " A difference is the largest of any row, over the largest component of the column, or of its theory, at \
         surface or base: as in the checks 'motion at the model's corners against the free field', which takes every step and may \
         find more, and 'free field against one-dimensional theory'. The incident wave is what comes up through the base; at the \
         base it stands together with what comes back from above. A surface moves twice the incident wave where \
         nothing is layered, damped or yields.",
        "差值取各行中的最大值，除以该柱（或其理论解）在地表和底部的最大分量：与“模型角点与自由场”和“自由场与理论”\
         两项检查相同，其中前者取每一时步，可能得到更大的值。入射波自底部向上传入；在底部它与自上方返回的波叠加。\
         若无分层、阻尼和屈服，地表运动为入射波的两倍。",
    ),
    (
        " A reference column is named by the corners of the model that it stands for.",
        "参考自由场柱以其所代表的模型角点命名。",
    ),
    (" No corner of the model differs from its column.", "模型各角点与对应自由场柱无差别。"),
    (
        " The column farthest from theory is {column}: by {share} of its peak, along {axis} at the {place}.",
        "与理论解相差最大的自由场柱为 {column}：{place} {axis} 向，相差其峰值的 {share}。",
    ),
    (
        " The corner of the model farthest from its column is {corner}: by {share} of the peak of column {column}\
         , along {axis} at the {place}.",
        "与对应自由场柱相差最大的模型角点为 {corner}：{place} {axis} 向，相差自由场柱 {column} 峰值的 {share}。",
    ),
    (" The file holds no theory for {list}.", "文件中没有 {list} 的理论解。"),
    (
        " The rows are too few to show the wave: at their times the incident one peaks at {peak}.",
        "行数过少，不足以反映波形：在各行的时刻入射波峰值为 {peak}。",
    ),
    (
        " This file holds the mean of the model's four corners alone, in which errors of opposite sign cancel \
         and which no column stands for where the ground differs between corners.",
        "此文件只有模型四个角点的平均值，其中符号相反的误差相互抵消；角点处地层不同时，没有自由场柱与之对应。",
    ),
    ("Along {axis} {list}.", "{axis} 向：{list}。"),
    (
        "Peaks and differences are those of the rows of free_field.csv, not of steps.",
        "峰值和差值取自 free_field.csv 各行，而非每一时步。",
    ),
    (
        "Peaks and differences are those of the rows of free_field.csv, {interval} apart, not of steps.",
        "峰值和差值取自 free_field.csv 各行（间隔 {interval}），而非每一时步。",
    ),
    ("no theory", "无理论解"),
    ("the model's own {place}, {corner}, at {speed}", "模型{place}（{corner}）为 {speed}"),
    (
        "the model's own {place}, {corner}, at {speed} (differing from the column's by at most {share} of its \
         peak)",
        "模型{place}（{corner}）为 {speed}（与自由场柱最多相差其峰值的 {share}）",
    ),
    (
        "the motion given ({kind}) peaks at {given} and the incident wave at {incident}",
        "给定运动为{kind}，峰值为 {given}，入射波峰值为 {incident}",
    ),
    (
        "the motion given peaks at {given} and the incident wave at {incident}",
        "给定运动峰值为 {given}，入射波峰值为 {incident}",
    ),
    (
        "the {place} of column {column} at {speed} ({beside})",
        "自由场柱 {column} {place}峰值为 {speed}（{beside}）",
    ),
    (
        "theory {theory}; they differ by at most {share} of its peak",
        "理论值 {theory}，最多相差其峰值的 {share}",
    ),
    ("{speed}, {times} times the incident wave", "{speed}，为入射波的 {times} 倍"),
];
