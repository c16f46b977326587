import { texts } from "../language";

/** What the curves say of their own; the rest comes with their numbers. */
export const words = texts(
  {
    time: "time",
    csv: "Save the numbers of this figure as CSV",
    png: "Save this figure as PNG",
    whole: "whole length",
    wholeHint: "Show the whole length again",
    hint: "drag: enlarge · double-click: whole length · name: off and on",
    line: (name: string) => `${name}: off and on; with Shift alone`,
    axes: (title: string) => `${title}. Left and right move the cursor, plus and minus enlarge and reduce, Escape shows all.`,
    thinned: (rows: string, of: string) =>
      `Shown are ${rows} of ${of} rows: in every stretch of the history those in which a curve is largest or smallest.`,
  },
  {
    time: "时间",
    csv: "将本图数据存为 CSV",
    png: "将本图存为 PNG",
    whole: "全程",
    wholeHint: "恢复显示全程",
    hint: "拖动放大 · 双击复原 · 点名称开关曲线",
    line: (name: string) => `${name}：点击开关，按住 Shift 只看此线`,
    axes: (title: string) => `${title}。左右键移动光标，加减键缩放，Esc 键复原。`,
    thinned: (rows: string, of: string) => `显示 ${of} 行中的 ${rows} 行：各时段内任一曲线取最大值或最小值的行。`,
  },
);
