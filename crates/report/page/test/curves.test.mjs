// Figures with curves: what the pointer shows is what the CSV files hold.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { agree, SI, table } from "./csv.mjs";
import { answering, browser, look, result, withPage } from "./browser.mjs";
import { bundled } from "./bundled.mjs";

let running;
// The model would take its time where graphics are software, and is not looked at here.
before(async () => (running = await browser({ graphics: false })));
after(() => running?.close());
const on = (name, act, options) => test(name, () => withPage(running, "english", act, options));

const FIGURE = "velocity.svg";
const monitors = table(result("english", "monitors.csv"));
const time = monitors.get("time").values;
/** The column behind a line of the figure: panels are named by their axis. */
const column = (panel, line) => monitors.get(`${line}.v${panel[0]}`).values;

/** Points at a share of the width of a panel. */
async function hover(figure, share, panel = 0) {
  const over = figure.locator(".u-over").nth(panel);
  const { width, height } = await over.boundingBox();
  await over.hover({ position: { x: share * width, y: height / 2 } });
  await figure.page().waitForTimeout(60);
}

/** What the figure says at the cursor: the row, and each panel's values with name and unit. */
function read(figure) {
  return figure.evaluate((element) => ({
    time: Number(element.querySelector("output").textContent.match(/ ([\d.−]+)/)?.[1].replace("−", "-") ?? NaN),
    panels: [...element.querySelectorAll(".curves-panel")].map((panel) => ({
      title: panel.querySelector("b").textContent,
      lines: [...panel.querySelectorAll(".curves-legend button")].map((button) => ({
        name: button.querySelector("span").textContent,
        value: button.querySelector("data").value,
        shown: button.querySelector("data").textContent,
        pressed: button.getAttribute("aria-pressed"),
      })),
    })),
  }));
}
const rowAt = (t) => time.findIndex((x) => Math.abs(x - t) < 0.6e-3);
const unitOf = (title) => title.match(/\(([^()]*)\)$/)[1];

on("values at the cursor are those of monitors.csv", async (page) => {
  const figure = await answering(page, FIGURE);
  for (const share of [0.1, 0.43, 0.77]) {
    await hover(figure, share);
    const { time: t, panels } = await read(figure);
    const row = rowAt(t);
    assert.ok(row > 0, `${t} s is no row`);
    assert.ok(panels.length > 1 && panels[0].lines.length === 3);
    for (const { title, lines } of panels) {
      const factor = SI[unitOf(title)];
      for (const { name, value, shown } of lines) {
        const wanted = column(title, name)[row];
        assert.ok(agree(Number(value) * factor, wanted), `${title} ${name} at ${t} s: ${value}, not ${wanted}`);
        if (!shown.includes("×")) {
          const said = Number(shown.replace("−", "-")) * factor;
          assert.ok(Math.abs(said - wanted) <= 5.1e-4 * Math.abs(wanted), `${shown} for ${wanted}`);
        }
      }
    }
  }
});

on("figures with the same abscissa share a cursor", async (page) => {
  await page.setViewportSize({ width: 1400, height: 3000 });
  const first = await answering(page, FIGURE);
  const second = await answering(page, "acceleration.svg");
  await hover(first, 0.4);
  await page.waitForTimeout(100);
  assert.equal((await read(second)).time, (await read(first)).time);
  assert.notEqual((await read(second)).panels[0].lines[0].value, "");
});

on("a stretch is enlarged by dragging in all panels of a figure and in no other, and a double click brings all back", async (page) => {
  const figure = await answering(page, FIGURE);
  const over = figure.locator(".u-over").first();
  const { x, y, width } = await over.boundingBox();
  await page.mouse.move(x + 0.5 * width, y + 60);
  await page.mouse.down();
  await page.mouse.move(x + 0.6 * width, y + 60, { steps: 4 });
  await page.mouse.move(x + 0.75 * width, y + 60, { steps: 4 });
  await page.mouse.up();
  const whole = figure.locator(".curves-bar button").first();
  assert.equal(await whole.isEnabled(), true);
  const end = time[time.length - 1];
  for (const panel of [0, 1]) {
    await hover(figure, 0.02, panel);
    const { time: t, panels } = await read(figure);
    assert.ok(Math.abs(t - 0.505 * end) < 0.02 * end, `panel ${panel} begins at ${t} s`);
    for (const { title, lines } of panels) {
      for (const { name, value } of lines) {
        assert.ok(agree(Number(value) * SI[unitOf(title)], column(title, name)[rowAt(t)]), `${title} is elsewhere than ${t} s`);
      }
    }
  }
  const other = await answering(page, "acceleration.svg");
  await hover(other, 0.02);
  assert.ok((await read(other)).time < 0.05 * end);
  await figure.scrollIntoViewIfNeeded();
  await over.dblclick({ position: { x: 50, y: 50 } });
  await hover(figure, 0.02, 1);
  assert.ok((await read(figure)).time < 0.05 * end);
  assert.equal(await whole.isEnabled(), false);
});

/** How many pixels of a canvas have about this colour. */
const inked = (figure, panel, colour) =>
  figure.evaluate(
    (element, [panel, colour]) => {
      const canvas = element.querySelectorAll("canvas")[panel];
      const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
      copy.drawImage(canvas, 0, 0);
      const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
      let count = 0;
      for (let k = 0; k < data.length; k += 4) {
        const near = colour.every((part, c) => Math.abs(data[k + c] - part) < 12);
        if (near && data[k + 3] > 200) count++;
      }
      return count;
    },
    [panel, colour],
  );
const BLUE = [0x00, 0x72, 0xb2];
const RED = [0xd5, 0x5e, 0x00];

on("a name switches its line off and on in all panels, with Shift all others; pointed at, it lifts its line", async (page) => {
  const figure = await answering(page, FIGURE);
  const buttons = figure.locator(".curves-panel").first().locator(".curves-legend button");
  await page.mouse.move(5, 5);
  const settle = () => page.waitForTimeout(80);
  await settle();
  const before = await inked(figure, 1, BLUE);
  assert.ok(before > 50, `${before} pixels of the first line`);
  await buttons.nth(0).click();
  await settle();
  assert.equal(await inked(figure, 1, BLUE), 0);
  assert.equal(await buttons.nth(0).getAttribute("aria-pressed"), "false");
  await buttons.nth(0).click();
  await page.mouse.move(5, 5);
  await settle();
  assert.equal(await inked(figure, 1, BLUE), before);

  await buttons.nth(1).hover();
  await settle();
  assert.ok((await inked(figure, 0, BLUE)) < 0.1 * before, "the first line is thin while the second is lifted");
  assert.ok((await inked(figure, 0, RED)) > 50);

  await buttons.nth(1).click({ modifiers: ["Shift"] });
  const pressed = (await read(figure)).panels[1].lines.map((line) => line.pressed);
  assert.deepEqual(pressed, ["false", "true", "false"]);
});

/** The file that a button gives. */
async function saved(page, figure, label) {
  const [download] = await Promise.all([page.waitForEvent("download"), figure.locator(`.curves-bar button:text("${label}")`).click()]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

on("the CSV of a figure holds every row of its columns", async (page) => {
  const figure = await answering(page, FIGURE);
  const { name, bytes } = await saved(page, figure, "CSV");
  assert.equal(name, "velocity.csv");
  const own = table(bytes.toString("utf8"));
  const titles = [...own.keys()];
  assert.equal(titles[0], "time");
  assert.ok(titles.length >= 7, titles.join());
  own.get("time").values.forEach((t, row) => assert.ok(agree(t, time[row]), `${t} in row ${row}`));
  assert.equal(own.get("time").values.length, time.length);
  for (const title of titles.slice(1)) {
    const [panel, line] = title.split(": ");
    const { unit, values } = own.get(title);
    const wanted = column(panel, line);
    values.forEach((value, row) => assert.ok(agree(value * SI[unit], wanted[row]), `${title} in row ${row}`));
  }
});

on("the PNG of a figure is a picture on white, in the dark as well", async (page) => {
  const figure = await answering(page, FIGURE);
  const { name, bytes } = await saved(page, figure, "PNG");
  assert.equal(name, "velocity.png");
  const { width, colours, first, counts } = await look(page, bytes, { sought: [0xffb27200] });
  assert.equal(width, 1880);
  assert.ok(colours > 50, `${colours} colours`);
  assert.equal(first, 0xffffffff);
  assert.ok(counts[0] > 1200, `${counts[0]} pixels of the first line`);
}, { colorScheme: "dark" });

on("the keyboard reaches the names, the buttons and the cursor", async (page) => {
  const figure = await answering(page, FIGURE);
  const over = figure.locator(".u-over").first();
  await over.focus();
  for (let k = 0; k < 5; k++) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Shift+ArrowRight");
  await page.waitForTimeout(60);
  assert.ok(Math.abs((await read(figure)).time - time[25]) < 1e-6);
  await page.keyboard.press("+");
  const whole = figure.locator(".curves-bar button").first();
  assert.equal(await whole.isEnabled(), true);
  await page.keyboard.press("Escape");
  assert.equal(await whole.isEnabled(), false);
  const buttons = figure.locator(".curves-panel").first().locator(".curves-legend button");
  await buttons.first().focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await buttons.nth(1).evaluate((button) => button === document.activeElement), true);
  await page.keyboard.press("Space");
  assert.equal(await buttons.nth(1).getAttribute("aria-pressed"), "false");
  for (const button of await figure.locator("button").all()) {
    const label = await button.evaluate((element) => element.getAttribute("aria-label") ?? element.textContent);
    assert.notEqual(label.trim(), "");
  }
});

on("curves fit the screen of a phone", async (page) => {
  const figure = await answering(page, FIGURE);
  const { width } = await figure.locator(".curves").boundingBox();
  assert.ok(width <= 390 - 28, `${width}`);
  const beyond = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.equal(beyond, 0);
}, { viewport: { width: 390, height: 844 } });

on("spectra lie on a logarithmic axis, and their values at the cursor are those of spectra.csv", async (page) => {
  const spectra = table(result("english", "spectra.csv"));
  const periods = spectra.get("period").values;
  const [first, last] = [periods[0], periods[periods.length - 1]];
  const figure = await answering(page, "spectra.svg");
  await page.setViewportSize({ width: 1400, height: 1800 });
  let compared = 0;
  for (const share of [0.15, 0.5, 0.8]) {
    await hover(figure, share, 1);
    const { time: period, panels } = await read(figure);
    const row = periods.findIndex((x) => Math.abs(x / period - 1) < 1e-3);
    assert.ok(row >= 0, `${period} s is no row`);
    // Rows are as far apart as their ratio; half of that, and a pixel.
    const place = Math.log(period / first) / Math.log(last / first);
    assert.ok(Math.abs(place - share) < 0.5 / (periods.length - 1) + 0.006, `${period} s stands at ${place}, not at ${share}`);
    for (const { title, lines } of panels) {
      const [, monitor, axis] = title.match(/^(.*), along ([xyz]) \(/);
      assert.deepEqual(lines.map((line) => line.name), ["free field at the monitor's level", "monitor"]);
      lines.forEach(({ value, shown }, k) => {
        const wanted = spectra.get(`${monitor}${k ? "" : ".free_field"}.a${axis}`).values[row];
        assert.ok(agree(Number(value) * SI[unitOf(title)], wanted), `${title} at ${period} s: ${value}, not ${wanted}`);
        assert.notEqual(shown, "");
        compared++;
      });
    }
  }
  assert.ok(compared >= 18, `${compared} values`);
});

on("a stretch of a logarithmic axis has its numbers", async (page) => {
  const figure = await answering(page, "spectra.svg");
  const over = figure.locator(".u-over").first();
  const { x, y, width } = await over.boundingBox();
  await page.mouse.move(x + 0.3 * width, y + 50);
  await page.mouse.down();
  await page.mouse.move(x + 0.33 * width, y + 50, { steps: 3 });
  await page.mouse.move(x + 0.38 * width, y + 50, { steps: 3 });
  await page.mouse.up();
  assert.equal(await figure.locator(".curves-bar button").first().isEnabled(), true);
  const periods = table(result("english", "spectra.csv")).get("period").values;
  const [first, last] = [periods[0], periods[periods.length - 1]];
  for (const panel of [0, 2]) {
    await hover(figure, 0.5, panel);
    const place = Math.log((await read(figure)).time / first) / Math.log(last / first);
    assert.ok(Math.abs(place - 0.34) < 0.02, `${place}`);
  }
});

on("section forces at the cursor are those of sections.csv, with the places named", async (page) => {
  const rows = result("english", "sections.csv").trim().split("\n").map((row) => row.split(","));
  const figure = await answering(page, "lining-forces.svg");
  const lining = (await figure.locator("svg title").first().textContent()).split(":")[0];
  await hover(figure, 0.35, 1);
  const { panels } = await read(figure);
  assert.deepEqual(panels.map(({ title }) => title[0]), ["N", "M", "Q"]);
  const column = { N: rows[0].findIndex((head) => /^N /.test(head)), M: rows[0].findIndex((head) => /^M /.test(head)), Q: rows[0].findIndex((head) => /^Q /.test(head)) };
  const largest = panels.map(({ title, lines }) => {
    const { value } = lines.find(({ name }) => name.startsWith("largest"));
    return [column[title[0]], Number(value) * 1e3];
  });
  const found = rows.some((row) => row[0] === lining && row.includes("max") && largest.every(([k, value]) => agree(value, Number(row[k]))));
  assert.ok(found, `no row of ${lining} has ${largest.map(([, value]) => value)}`);
});

test("numbers of an axis are not rounded away", async () => {
  const { ticks } = await bundled("src/curves/format.ts");
  assert.deepEqual(ticks([0, 2.5, 5], false), ["0", "2.5", "5.0"]);
  assert.deepEqual(ticks([0, 0.25, 0.5], false), ["0", "0.25", "0.50"]);
  assert.deepEqual(ticks([-200, 0, 200], false), ["−200", "0", "200"]);
  const { marks } = await bundled("src/curves/log.ts");
  assert.deepEqual(marks(0.02, 10, 7), [0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10]);
  assert.deepEqual(marks(1e-9, 1e-2, 5).length, 8);
  assert.ok(marks(0.31, 0.39, 6).length >= 3, `${marks(0.31, 0.39, 6)}`);
  assert.deepEqual(ticks(marks(1e-6, 1, 5), true).slice(-3), ["10⁻²", "10⁻¹", "1"]);
});

test("histories of runs with rows at other times lie over one another, each with its own values", () =>
  withPage(running, "compared", async (page) => {
    const coarse = table(result("coarse", "monitors.csv"));
    const figure = await answering(page, "histories-1.svg");
    for (const share of [0.2, 0.45, 0.7, 0.701, 0.703]) {
      await hover(figure, share);
      const { time: t, panels } = await read(figure);
      for (const { title, lines } of panels) {
        assert.deepEqual(lines.map((line) => line.name), ["english", "coarse"]);
        const quantity = `A.${title.split(" ")[0]}`;
        const unit = SI[unitOf(title)];
        assert.ok(agree(Number(lines[0].value) * unit, monitors.get(quantity).values[rowAt(t)]), `${title} at ${t} s`);
        // Every other row: its nearest is at most one row off.
        const near = coarse.get("time").values.map((own, row) => [Math.abs(own - t), row]).filter(([away]) => away < 0.0056);
        const own = near.map(([, row]) => coarse.get(quantity).values[row]);
        assert.ok(own.some((wanted) => agree(Number(lines[1].value) * unit, wanted)), `${title}: ${lines[1].value} is none of ${own}`);
        // What stands elsewhere says where.
        const there = coarse.get("time").values.some((own) => Math.abs(own - t) < 1e-6);
        const said = lines[1].shown.match(/\(([\d.]+)\u00a0s\)$/)?.[1];
        assert.equal(said === undefined, there, lines[1].shown);
        if (said) assert.ok(near.some(([, row]) => Math.abs(coarse.get("time").values[row] - Number(said)) < 1e-6), said);
      }
    }
  }));
