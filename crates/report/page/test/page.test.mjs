// The page as a whole: on paper, without scripts, without graphics, in Chinese, with names that are markup.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { answering, browser, result, withPage } from "./browser.mjs";

let running;
before(async () => (running = await browser()));
after(() => running?.close());

/** Opens all details that are folded away, as a reader may without scripts. */
const unfold = (page) => page.evaluate(() => document.querySelectorAll("details").forEach((details) => details.setAttribute("open", "")));

/** Every figure's drawing: whether it can be seen, with some extent. */
const drawings = (page) =>
  page.evaluate(() => [...document.querySelectorAll("figure > svg")].map((svg) => svg.checkVisibility() && svg.getBoundingClientRect().height > 50));

/** Brings every figure with curves to answer, as reading does. */
async function readAll(page) {
  for (const figure of await page.locator("figure[data-curves]").all()) {
    await answering(page, await figure.getAttribute("data-curves"));
  }
}

test("nothing is asked for and nothing said while all of the page is read", () =>
  withPage(running, "english", async (page) => {
    await readAll(page);
    assert.ok((await page.locator("figure.answers").count()) >= 5);
  }));

test("the page allows itself nothing but what stands in it", async () => {
  const allowed = result("english", "report.html").match(/http-equiv="Content-Security-Policy" content="([^"]*)"/)[1];
  assert.equal(allowed, "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:");
});

test("no window is too narrow for the page, in either language: what is wide scrolls in itself", async () => {
  for (const folder of ["english", "chinese", "named"]) {
    for (const width of [1400, 390]) {
      await withPage(
        running,
        folder,
        async (page) => {
          await unfold(page);
          const [wide, window] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
          assert.ok(wide <= window, `${folder} at ${width}: ${wide} px wide`);
        },
        { viewport: { width, height: 900 } },
      );
    }
  }
});

test("without scripts the figures stand", async () => {
  await withPage(
    running,
    "english",
    async (page) => {
      await unfold(page);
      const seen = await drawings(page);
      assert.ok(seen.length >= 10 && seen.every(Boolean), `${seen}`);
    },
    { javaScriptEnabled: false },
  );
});

test("without WebGL the page says so, and the figures stand", async () => {
  const plain = await browser({ graphics: false });
  try {
    await withPage(plain, "english", async (page) => {
      assert.equal(await page.evaluate(() => Boolean(document.createElement("canvas").getContext("webgl2"))), false);
      assert.equal(await page.evaluate(() => window.tremolite.view.ready), false);
      assert.notEqual((await page.locator("#view").innerText()).trim(), "");
      assert.equal(await page.locator("#view canvas").count(), 0);
      await unfold(page);
      const seen = await page.evaluate(() => [...document.querySelectorAll("figure:not(.answers) > svg")].every((svg) => svg.checkVisibility()));
      assert.equal(seen, true);
    });
  } finally {
    await plain.close();
  }
});

test("on paper the drawings stand, and what needs a pointer does not", async () => {
  await withPage(running, "english", async (page) => {
    await answering(page, "velocity.svg");
    assert.equal(await page.locator('figure[data-curves="velocity.svg"] > svg').isVisible(), false);
    await page.emulateMedia({ media: "print" });
    // What is folded away is left out but for what was opened, and named.
    const folded = () =>
      page.evaluate(() =>
        [...document.querySelectorAll("figure > svg")].map((svg) => Boolean(svg.closest("details.fold:not([open])"))),
      );
    const [seen, away] = [await drawings(page), await folded()];
    assert.ok(away.some(Boolean) && seen.every((drawn, k) => drawn !== away[k]), `${seen} ${away}`);
    assert.ok(await page.locator(".unprinted").isVisible());
    await unfold(page);
    const all = await drawings(page);
    assert.ok(all.every(Boolean), `${all}`);
    assert.equal(await page.locator(".curves:visible").count(), 0);
    assert.equal(await page.locator("#view canvas:visible").count(), 0);
  });
});

test("each of the two sheets fits a page of paper", async () => {
  // What @page leaves of A4 between its margins.
  const [width, height] = [186, 272].map((mm) => (mm / 25.4) * 96);
  for (const folder of ["english", "chinese", "named"]) {
    const options = { viewport: { width: Math.floor(width), height: 900 } };
    await withPage(
      running,
      folder,
      async (page) => {
        await page.emulateMedia({ media: "print" });
        const sheets = await page.evaluate(() =>
          [...document.querySelectorAll(".sheet")].map((sheet) => {
            const top = sheet.getBoundingClientRect().top;
            return Math.max(...[...sheet.querySelectorAll("*")].map((part) => part.getBoundingClientRect().bottom - top));
          }),
        );
        assert.equal(sheets.length, 2);
        const above = await page.evaluate(() => {
          const signed = document.querySelector(".sheet .signed");
          const others = [...signed.closest(".sheet").children].filter((part) => !part.contains(signed));
          const bottom = Math.max(...others.map((part) => part.getBoundingClientRect().bottom));
          return signed.getBoundingClientRect().top - bottom;
        });
        assert.ok(above >= 0, `${folder}: the signatures lie ${-above} px over what stands above`);
        // What is wider than the paper would shrink all pages.
        await unfold(page);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(wide <= Math.ceil(width), `${folder}: ${wide} px wide`);
        assert.ok(sheets.every((tall) => tall <= height), `${folder}: ${sheets} px of ${height}`);
      },
      options,
    );
  }
});

test("names of groups that are markup are shown as they are", async () => {
  await withPage(running, "named", async (page) => {
    const text = await page.evaluate(() => document.body.innerText);
    for (const name of ["<script>", "</script>"]) assert.ok(text.includes(name), `${name} is not on the page`);
    // Those of the template alone: data, blocks, and the page's own.
    const scripts = await page.evaluate(() => [...document.scripts].filter((script) => !script.type).length);
    assert.equal(scripts, 1);
  });
});

/** Texts with three English words or more that a reader sees, less the names of the case, its text, and the values that the run
 *  gives in its own words, which are marked as English. */
function english(page, names) {
  return page.evaluate((names) => {
    const found = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const parent = node.parentElement;
      if (parent.closest("script, style, code, title, desc, data, #case pre, #defaulted [lang=en], [translate=no]") || !parent.checkVisibility()) continue;
      let text = node.textContent;
      for (const name of names) text = text.replaceAll(name, "·");
      // Components of stress and keys of laws are symbols.
      text = text.replace(/\bs[xyz]{2}\b|\b[a-z]+(?:_[a-z]+)+\b/g, "·");
      const words = /[A-Za-z][a-z'’]+(?:[\s,;:–-]+(?:a|[A-Za-z][a-z'’]+)){2,}/.exec(text);
      if (words) found.push(text.trim().slice(0, 160));
    }
    return found;
  }, names);
}

/** What the case names, its title, stages, monitors and the rest, and its keys, which the page lists as they are. */
function names() {
  const named = [...result("chinese", "case.toml").matchAll(/^ *(?:name|title) *= *"([^"\n]*)"/gm)].map((match) => match[1]);
  const keys = [...result("chinese", "case.toml").matchAll(/^ *([a-z_]{4,}) *=/gm)].map((match) => match[1]);
  return [...named, ...keys].sort((a, b) => b.length - a.length);
}

test("a Chinese page has no text left in English", async () => {
  await withPage(running, "chinese", async (page) => {
    await readAll(page);
    await page.evaluate(() => window.tremolite?.view?.ready);
    const screen = await english(page, names());
    await page.emulateMedia({ media: "print" });
    const paper = await english(page, names());
    const left = [...new Set([...screen, ...paper])];
    assert.deepEqual(left, [], `${left.length} texts are in English`);
  });
});
