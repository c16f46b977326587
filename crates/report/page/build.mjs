// Builds page.js, which the Rust crate includes, and the licences of what is in it: node build.mjs [FOLDER], dist otherwise.
// Equal sources and tools give equal bytes.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { build } from "esbuild";

const folder = process.argv[2] ?? "dist";
/** Bytes that the script may have. */
const LIMIT = 800_000;

const { metafile } = await build({
  entryPoints: ["src/main.ts"],
  outfile: join(folder, "page.js"),
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "utf8",
  legalComments: "inline",
  loader: { ".css": "text" },
  metafile: true,
});

const script = readFileSync(join(folder, "page.js"), "utf8");
const size = Buffer.byteLength(script);
if (size > LIMIT) throw new Error(`page.js has ${size} bytes, more than ${LIMIT}`);
// The script stands within the page.
if (/<\/script|<!--/i.test(script)) throw new Error("page.js holds what ends or hides a <script>");

const inputs = Object.values(metafile.outputs).flatMap((output) => Object.entries(output.inputs));
const used = inputs.filter(([, { bytesInOutput }]) => bytesInOutput > 0).map(([path]) => path);
const packages = new Set(used.map((path) => path.match(/node_modules\/((?:@[^/]+\/)?[^/]+)/)?.[1]).filter(Boolean));
const texts = [...packages].sort().map((name) => {
  const { version, license } = JSON.parse(readFileSync(`node_modules/${name}/package.json`, "utf8"));
  if (license !== "MIT") throw new Error(`${name} is under ${license}, not MIT`);
  return `${name} ${version}\n\n${readFileSync(`node_modules/${name}/LICENSE`, "utf8").trim()}\n`;
});
writeFileSync(join(folder, "LICENSES.txt"), `page.js holds parts of these packages.\n\n${texts.join("\n----\n\n")}`);
console.log(`page.js: ${size} bytes of at most ${LIMIT}, with ${[...packages].sort().join(", ")}`);
