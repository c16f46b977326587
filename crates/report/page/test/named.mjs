// Gives groups of a result folder names that are markup, and its motion a wave at 25° whose type is: node test/named.mjs FOLDER NAME=NEW …
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

const path = join(folder, "summary.json");
const summary = JSON.parse(readFileSync(path, "utf8"));
const angle = (25 * Math.PI) / 180;
const wave = {
  type: "<SV>",
  angle,
  azimuth: Math.PI / 2,
  way: [Math.sin(angle), 0, Math.cos(angle)],
  polarisation: [Math.cos(angle), 0, -Math.sin(angle)],
  parts: [{ component: "east", factor: 1, phase: 0 }],
  apparent_velocity: 2840,
  arrives: true,
};
summary.motion.waves = [wave];
writeFileSync(path, JSON.stringify(summary));
