// Figures with curves: what the pointer shows is what the CSV files hold.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { agree, SI, table } from "./csv.mjs";
import { answering, browser, look, result, withPage } from "./browser.mjs";

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
    time: Number(element.querySelector("output").textContent.replace(/[^\d.−]/g, "").replace("−", "-")),
    panels: [...element.querySelectorAll(".curves-panel")].map((panel) => ({
      title: panel.querySelector("b").textContent,
      lines: [...panel.querySelectorAll(".curves-legend button")].map((button) => ({
        name: button.childNodes[1].textContent,
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
