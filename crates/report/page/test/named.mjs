// Gives groups of a result folder names that are markup: node test/named.mjs FOLDER NAME=NEW …
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const [folder, ...renamed] = process.argv.slice(2);
const pairs = renamed.map((pair) => pair.split(/=(.*)/s, 2));

/** The name with nothing of a name beside it. */
const exactly = (name) => new RegExp(`(?<![\\w.])${name.replaceAll(".", "\\.")}(?![\\w.])`, "g");
const markup = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");

for (const file of readdirSync(folder, { recursive: true }).filter((name) => /\.(vtu|csv|json)$/.test(name))) {
  const path = join(folder, file);
  // One character a byte: fields are binary behind their markup.
  let text = readFileSync(path, "latin1");
  for (const [name, given] of pairs) {
    if (file.endsWith(".vtu")) text = text.replaceAll(`"group:${name}"`, `"group:${markup(given)}"`);
    else if (file.endsWith(".csv")) text = text.split("\n").map((line, row) => (row === 0 ? line.replaceAll(`${name}.`, `${given}.`) : line.replace(new RegExp(`^${name.replaceAll(".", "\\.")},`), `${given},`))).join("\n");
    else text = text.replace(exactly(name), given);
  }
  writeFileSync(path, text, "latin1");
}
