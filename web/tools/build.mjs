// Bundles the page into dist/: index.html, app.js, app.css. `--watch` keeps on; `--out FOLDER` writes elsewhere.
import {build, context} from "esbuild";
import {copyFileSync, mkdirSync, readFileSync} from "node:fs";
import {dirname, join, resolve} from "node:path";
import {fileURLToPath} from "node:url";
import {gzipSync} from "node:zlib";

const web = dirname(dirname(fileURLToPath(import.meta.url)));
const at = process.argv.indexOf("--out");
const out = at < 0 ? join(web, "dist") : resolve(process.argv[at + 1]);
const largest_kb = 400;

const options = {
  entryPoints: {app: join(web, "src/main.tsx")},
  outdir: out,
  bundle: true,
  minify: true,
  format: "esm",
  target: ["es2022"],
  jsx: "automatic",
  jsxImportSource: "preact",
  legalComments: "none",
  banner: {js: "/* Layout-in-a-Box, Apache-2.0; with three.js and preact, MIT (NOTICE) */"},
  logLevel: "warning",
};

mkdirSync(out, {recursive: true});
copyFileSync(join(web, "src/index.html"), join(out, "index.html"));
if (process.argv.includes("--watch")) {
  await (await context(options)).watch();
} else {
  await build(options);
  const sizes = ["index.html", "app.js", "app.css"].map((file) => gzipSync(readFileSync(join(out, file)), {level: 9}).length);
  const kb = sizes.reduce((sum, size) => sum + size, 0) / 1000;
  console.log(`page: ${kb.toFixed(0)} kB compressed`);
  if (kb > largest_kb) {
    console.error(`the page is larger than ${largest_kb} kB`);
    process.exit(1);
  }
}
