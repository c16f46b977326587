// Pages in Debian's Chromium, opened from disk. What a page asks for or says is recorded, and must be nothing.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

/** A folder with the result folders english, chinese, named and coarse, and the comparison of the first with the last (.ci/page makes them). */
export const RESULTS = resolve(process.env.TREMOLITE_PAGES ?? "results");
assert.ok(
  existsSync(join(RESULTS, "english", "report.html")),
  `there is no english/report.html in ${RESULTS}: run .ci/page, or give the folder as TREMOLITE_PAGES`,
);

/** A file of results as text. */
export const result = (...path) => readFileSync(join(RESULTS, ...path), "utf8");

const PROGRAM = process.env.CHROMIUM ?? "/usr/bin/chromium";
const SOFTWARE = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
const NO_GRAPHICS = ["--disable-gpu", "--disable-3d-apis"];

/** Starts a browser, with WebGL by software or without any. */
export function browser({ graphics = true } = {}) {
  assert.ok(existsSync(PROGRAM), `there is no browser at ${PROGRAM}: install chromium, or give its path as CHROMIUM`);
  return chromium.launch({ executablePath: PROGRAM, args: ["--no-sandbox", ...(graphics ? SOFTWARE : NO_GRAPHICS)] });
}

/** Opens the page of a result folder; `act` gets it. Fails on any message of the console, error or request. */
export async function withPage(running, folder, act, options = {}) {
  const context = await running.newContext({ viewport: { width: 1400, height: 900 }, acceptDownloads: true, ...options });
  context.setDefaultTimeout(15_000);
  const page = await context.newPage();
  const said = [];
  page.on("console", (message) => said.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => said.push(`error: ${error.stack}`));
  const address = pathToFileURL(join(RESULTS, folder, "report.html")).href;
  page.on("request", (request) => {
    // What the page itself holds is no request: a blob is how a file is saved.
    if (request.url() !== address && !/^(blob|data):/.test(request.url())) said.push(`request: ${request.url()}`);
  });
  try {
    await page.goto(address, { waitUntil: "load" });
    await act(page);
    assert.deepEqual(said, []);
  } finally {
    await context.close();
  }
}

/** A figure with curves, once it answers. */
export async function answering(page, file) {
  const figure = page.locator(`figure[data-curves="${file}"]`);
  // Details are folded away until one opens them.
  await figure.evaluate((element) => element.closest("details")?.setAttribute("open", ""));
  await figure.scrollIntoViewIfNeeded();
  await page.locator(`figure.answers[data-curves="${file}"]`).waitFor();
  await figure.scrollIntoViewIfNeeded();
  return figure;
}

/**
 * What a picture in PNG looks like, found by an empty page: its size, how many colours it has, which its first pixel has,
 * how many pixels have the colours of `sought`, and which share of pixels differs from another picture of equal size.
 */
export async function look(page, png, { other, sought = [] } = {}) {
  const empty = await page.context().newPage();
  try {
    return await empty.evaluate(
      async ([data, otherData, sought]) => {
        const decoded = async (base64) => {
          const image = new Image();
          image.src = `data:image/png;base64,${base64}`;
          await image.decode();
          const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
          context.drawImage(image, 0, 0);
          return { width: image.width, all: new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer) };
        };
        const { width, all } = await decoded(data);
        const before = otherData && (await decoded(otherData)).all;
        const differing = before && all.reduce((sum, value, k) => sum + (value !== before[k]), 0);
        return {
          width,
          colours: new Set(all).size,
          first: all[0],
          counts: sought.map((colour) => all.reduce((sum, value) => sum + (value === colour), 0)),
          differing: before && (before.length === all.length ? differing / all.length : 1),
        };
      },
      [png.toString("base64"), other?.toString("base64"), sought],
    );
  } finally {
    await empty.close();
  }
}
