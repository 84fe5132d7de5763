// Bundles the tests in test/ and runs them with node's own runner.
import {build} from "esbuild";
import {spawnSync} from "node:child_process";
import {readdirSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";

const web = dirname(dirname(fileURLToPath(import.meta.url)));
const tests = readdirSync(join(web, "test")).filter((file) => file.endsWith(".test.ts"));
const out = join(web, "node_modules/.cache/layoutbox-test");
await build({
  entryPoints: tests.map((file) => join(web, "test", file)),
  outdir: out,
  bundle: true,
  platform: "node",
  format: "esm",
  outExtension: {".js": ".mjs"},
  logLevel: "warning",
});
const files = tests.map((file) => join(out, file.replace(/\.ts$/, ".mjs")));
process.exit(spawnSync(process.execPath, ["--test", ...files], {stdio: "inherit"}).status ?? 1);
