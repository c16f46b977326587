// A module of the script by itself.
import { build } from "esbuild";

/** What a source file exports. */
export async function bundled(path) {
  const { outputFiles } = await build({ entryPoints: [path], bundle: true, format: "esm", write: false });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`);
}
