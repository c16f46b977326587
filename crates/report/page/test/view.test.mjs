// The model in three dimensions: what is drawn and what the pointer says is what the field files hold.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { browser, look, RESULTS, withPage } from "./browser.mjs";
import { elements, filesOf, readVtu } from "./vtu.mjs";

/** Fields of elements that are looked at. */
const FIELDS = ["s1", "d_tension"];
/** Elements under the pointer: one in each of these groups, as far as one is in sight, until there are five. */
const GROUPS = ["hall.lining.crown", "hall.lining.walls", "gallery.lining.crown", "gallery.lining.walls", "rock"];
const WANTED = 5;

let running;
before(async () => (running = await browser()));
after(() => running?.close());
const on = (name, act) =>
  test(name, () =>
    withPage(running, "english", async (page) => {
      await page.locator("#view").scrollIntoViewIfNeeded();
      assert.equal(await page.evaluate(() => window.tremolite.view.ready), true);
      await act(page);
    }),
  );

const files = filesOf(join(RESULTS, "english", "fields.pvd")).map(readVtu);
const last = files.length - 1;
const show = (page, what) => page.evaluate((what) => window.tremolite.view.show(what), what);

/** The model alone as drawn now, without numbers and colour bar. */
async function drawn(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const hide = "document.querySelector('#view .view-over').style.visibility";
  await page.evaluate(`${hide} = 'hidden'`);
  const picture = await page.locator("#view canvas").first().screenshot();
  await page.evaluate(`${hide} = ''`);
  return picture;
}

on("the canvas shows a model", async (page) => {
  const { colours } = await look(page, await drawn(page));
  assert.ok(colours > 30, `${colours} colours`);
});

on("the picture changes with the time, the field, the cut and the scale", async (page) => {
  await show(page, { field: "s1", time: 0, cut: null, scale: 0 });
  const changes = { time: { time: Math.round(last / 2) }, field: { field: "displacement" }, cut: { cut: { axis: 0, at: 3 } }, scale: { scale: 500 } };
  let before = await drawn(page);
  for (const [name, what] of Object.entries(changes)) {
    await show(page, what);
    const after = await drawn(page);
    const { differing } = await look(page, after, { other: before });
    assert.ok(differing > 0.005, `${name} changes ${(100 * differing).toFixed(2)} % of the picture`);
    before = after;
  }
});

/** The first of these elements that is seen, looked for at strides; not all, since each look takes its time. */
const firstSeen = (page, numbers) => page.evaluate((own) => own.find((element) => window.tremolite.view.locate(element)), numbers);

/** Elements that can be seen now: of each group up to two. */
async function inSight(page, of) {
  const found = [];
  for (const group of GROUPS) {
    const own = of.filter((element) => element.groups.includes(group)).map((element) => element.element);
    const strided = own.map((_, k) => own[(k * 7) % own.length]).filter((element, k, all) => all.indexOf(element) === k);
    for (const half of [strided.slice(0, 12), strided.slice(12, 24)]) {
      const element = await firstSeen(page, half);
      if (element !== undefined) found.push(element);
    }
  }
  return found;
}

on("at five elements and two times the value under the pointer is the file's, within half a level", async (page) => {
  let compared = 0;
  for (const field of FIELDS) {
    for (const time of [Math.round(last / 2), last]) {
      await show(page, { field, time, cut: null, scale: 0 });
      const file = files[time];
      const of = elements(file);
      const seen = await inSight(page, of);
      assert.ok(seen.length >= WANTED, `only elements ${seen} are in sight`);
      for (const element of seen) {
        const { row, groups } = of.find((other) => other.element === element);
        const wanted = file.cells.get(field)[row];
        const picked = await page.evaluate((element) => {
          const { x, y } = window.tremolite.view.locate(element);
          return window.tremolite.view.pick(x, y);
        }, element);
        assert.equal(picked.element, element);
        assert.equal(picked.field, field);
        assert.equal(picked.unit, file.unit.get(field));
        assert.deepEqual([...picked.groups].sort(), [...groups].sort());
        if (Number.isNaN(wanted)) {
          assert.equal(picked.value, null);
          continue;
        }
        const off = Math.abs(picked.value - wanted);
        const slack = 1e-6 * Math.abs(wanted) + 1e-6 * picked.halfLevel;
        assert.ok(off <= picked.halfLevel + slack, `${field} of element ${element}: ${picked.value}, not ${wanted} ± ${picked.halfLevel}`);
        compared++;
      }
    }
  }
  assert.ok(compared >= 2 * WANTED, `only ${compared} values were there to compare`);
});

on("a level is a 254th part of what the field spans over all times", async (page) => {
  await show(page, { field: "s1", time: last, cut: null });
  const element = (await inSight(page, elements(files[last])))[0];
  const { halfLevel } = await page.evaluate((element) => {
    const { x, y } = window.tremolite.view.locate(element);
    return window.tremolite.view.pick(x, y);
  }, element);
  const all = files.flatMap((file) => Array.from(file.cells.get("s1"))).filter(Number.isFinite);
  const span = all.reduce((most, x) => Math.max(most, x), -Infinity) - all.reduce((least, x) => Math.min(least, x), Infinity);
  assert.ok(halfLevel > 0 && halfLevel <= (1.001 * span) / 508, `${halfLevel} for a span of ${span}`);
});

on("a cut through an element within the rock shows it", async (page) => {
  await show(page, { field: "s1", time: last, cut: null, scale: 0 });
  const rock = elements(files[last]).filter((element) => element.groups.includes("rock"));
  // Below the caverns, where no opening shows it.
  const depth = ({ middle }) => Math.abs(middle[0]) - middle[2];
  const within = rock.filter(({ middle }) => middle[2] < -62).sort((a, b) => depth(a) - depth(b));
  const hidden = await page.evaluate((own) => own.find((element) => !window.tremolite.view.locate(element)), within.map((e) => e.element));
  assert.notEqual(hidden, undefined, "no element of the rock is hidden");
  const { element, middle, row } = within.find((other) => other.element === hidden);
  const seen = [];
  for (const axis of [0, 1, 2]) {
    await show(page, { cut: { axis, at: middle[axis] } });
    const picked = await page.evaluate((element) => {
      const at = window.tremolite.view.locate(element);
      return at && window.tremolite.view.pick(at.x, at.y);
    }, element);
    if (picked) seen.push(axis);
    if (picked) assert.ok(Math.abs(picked.value - files[last].cells.get("s1")[row]) <= picked.halfLevel * 1.000001);
  }
  assert.ok(seen.length > 0, `element ${element} is not seen in a cut through its middle`);
});

on("the pointer shows the value as a text", async (page) => {
  await show(page, { field: "s1", time: last, cut: null, scale: 0 });
  const element = (await inSight(page, elements(files[last])))[0];
  const { x, y } = await page.evaluate((element) => window.tremolite.view.locate(element), element);
  const { text } = await page.evaluate(([x, y]) => window.tremolite.view.pick(x, y), [x, y]);
  await page.locator("#view canvas").first().hover({ position: { x, y } });
  await page.waitForFunction(([text, element]) => {
    const said = document.querySelector("#view").innerText;
    return said.includes(text) && said.includes(String(element));
  }, [text, element]);
});

/** The words of each code of a pair, from sound to bad. */
const PAIRS = ["bonded", "stuck, bond broken", "sliding", "open"];

on("codes are told in words, of pairs the worst of an element's points", async (page) => {
  await show(page, { field: "state", time: last, cut: null, scale: 0, parts: ["lining-rock"] });
  const file = filesOf(join(RESULTS, "english", "interfaces.pvd")).map(readVtu)[last];
  const of = elements(file);
  const said = new Set();
  for (const { element } of of.filter((_, k) => k % 5 === 0)) {
    const picked = await page.evaluate((element) => {
      const at = window.tremolite.view.locate(element);
      return at && window.tremolite.view.pick(at.x, at.y);
    }, element);
    if (!picked || picked.part !== "lining-rock") continue;
    said.add(picked.text);
    assert.equal(picked.text, PAIRS[picked.value]);
    // An element at a corner has more than one face in the interface.
    const faces = of.filter((other) => other.element === element);
    const wanted = faces.map(({ corners }) => Math.max(...corners.map((point) => file.points.get("state")[point])));
    assert.ok(wanted.includes(picked.value), `element ${element}: ${picked.value} is none of ${wanted}`);
  }
  assert.ok(said.size >= 2, [...said].join());
});

on("one click draws the displacement as large as is easily seen", async (page) => {
  await show(page, { field: "s1", time: last, cut: null, scale: 0 });
  const before = await drawn(page);
  const button = page.locator("#view button", { hasText: "well seen" });
  const scale = (await button.textContent()).match(/\d+/)[0];
  await button.click();
  await page.waitForTimeout(400);
  assert.ok((await page.locator("#view .view-slide output").allTextContents()).some((text) => text.includes(scale)));
  const { differing } = await look(page, await drawn(page), { other: before });
  assert.ok(differing > 0.005, `${differing}`);
});

on("the view's picture is not blank", async (page) => {
  const data = await page.evaluate(async () => {
    const blob = await window.tremolite.view.picture();
    const bytes = new Uint8Array(await blob.arrayBuffer());
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  });
  const { colours } = await look(page, Buffer.from(data, "base64"));
  assert.ok(colours > 30, `${colours} colours`);
});

test("groups with names that are markup are shown with these names", () =>
  withPage(running, "named", async (page) => {
    assert.equal(await page.evaluate(() => window.tremolite.view.ready), true);
    const text = await page.locator("#view").innerText();
    for (const name of ["<script>", "</script>"]) assert.ok(text.includes(name), `${name} is not in the view`);
  }));

/** The colours of a wave's way and of the flow of water. */
const WAVE = [0xb0, 0x56, 0x1b];
const FLOW = [0x0b, 0x4f, 0x9e];

/** Whether points of the overlay are near a colour: how many, and the mean of the upper and of the lower half of them. */
const pointsOf = (page, colour, near = 8) =>
  page.evaluate(async ([colour, near]) => {
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const canvas = document.querySelector("#view canvas.view-over");
    // A copy, since the browser complains of one that is read more than once.
    const pen = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
    pen.drawImage(canvas, 0, 0);
    const { data, width } = pen.getImageData(0, 0, canvas.width, canvas.height);
    const points = [];
    for (let i = 0; i < data.length; i += 4) {
      const off = Math.max(...colour.map((of, k) => Math.abs(data[i + k] - of)));
      if (data[i + 3] > 250 && off < near) points.push([(i / 4) % width, Math.floor(i / 4 / width)]);
    }
    points.sort((p, q) => p[1] - q[1]);
    const mean = (some) => [0, 1].map((k) => some.reduce((sum, point) => sum + point[k], 0) / some.length);
    const half = points.length >> 1;
    return { count: points.length, upper: mean(points.slice(0, half)), lower: mean(points.slice(half)) };
  }, [colour, near]);

test("a wave that comes in at 25° is an arrow of that slope, where no wave does there is none", async () => {
  await withPage(running, "named", async (page) => {
    await page.locator("#view").scrollIntoViewIfNeeded();
    await show(page, { look: "y" });
    const { count, upper, lower } = await pointsOf(page, WAVE);
    assert.ok(count > 40, `${count} points`);
    const slope = (Math.atan2(upper[0] - lower[0], lower[1] - upper[1]) * 180) / Math.PI;
    assert.ok(Math.abs(slope - 25) < 4, `${slope}° from upright`);
  });
  await withPage(running, "english", async (page) => {
    await page.locator("#view").scrollIntoViewIfNeeded();
    assert.equal((await pointsOf(page, WAVE)).count, 0);
  });
});

/** Lines of flow are thin, so most of their points are a little lighter. */
const flowPoints = (page) => pointsOf(page, FLOW, 40);

/** A page of the small case to which water flows: these lines at all times. */
function flowing(lines, beside) {
  const folder = "flowing";
  const page = readFileSync(join(RESULTS, "english", "report.html"), "utf8");
  const changed = page.replace(/(<script[^>]*id="view-data"[^>]*>)([^<]*)(<\/script>)/, (_, open, json, close) => {
    const held = JSON.parse(json);
    held.flows = [{ beside, lines }];
    held.flowAt = held.times.map(() => 0);
    return open + JSON.stringify(held).replaceAll("<", "\\u003c") + close;
  });
  assert.notEqual(changed, page);
  mkdirSync(join(RESULTS, folder), { recursive: true });
  writeFileSync(join(RESULTS, folder, "report.html"), changed);
  return folder;
}

test("water that flows is a line of its slope beside the cut, and none where it is not wanted or far from the cut", async () => {
  // Across y is cut in the middle; of three lines up at 30° one is beside it, one far behind, one cut away.
  const way = [16 * Math.cos(Math.PI / 6), 0, 16 * Math.sin(Math.PI / 6)];
  const at = (y) => [-1, 0, 1].flatMap((k) => [12 + (k * way[0]) / 2, y, -70 + (k * way[2]) / 2]);
  await withPage(running, flowing([at(0.5)], 1), async (page) => {
    await page.locator("#view").scrollIntoViewIfNeeded();
    await show(page, { look: "y", cut: { axis: 1, at: 0 } });
    const { count, upper, lower } = await flowPoints(page);
    assert.ok(count > 40, `${count} points`);
    const slope = (Math.atan2(lower[1] - upper[1], upper[0] - lower[0]) * 180) / Math.PI;
    assert.ok(Math.abs(slope - 30) < 4, `${slope}° from level`);
    await show(page, { flow: false });
    assert.equal((await flowPoints(page)).count, 0);
  });
  await withPage(running, flowing([at(1.5), at(-0.5)], 1), async (page) => {
    await page.locator("#view").scrollIntoViewIfNeeded();
    await show(page, { look: "y", cut: { axis: 1, at: 0 } });
    assert.equal((await flowPoints(page)).count, 0);
    await show(page, { cut: null });
    assert.ok((await flowPoints(page)).count > 80);
  });
});
