// A running service with the built page, and a browser to look at it: what all tests of the studio start from.
import {spawn} from "node:child_process";
import {existsSync, mkdtempSync, readFileSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {dirname, join} from "node:path";
import {after, before} from "node:test";
import {fileURLToPath} from "node:url";
import {chromium} from "../../web/node_modules/playwright-core/index.mjs";

export {chromium};

export const source = process.env.LAYOUTBOX_SOURCE ?? dirname(dirname(dirname(fileURLToPath(import.meta.url))));
const program = process.env.LAYOUTBOX_BINARY ?? "layoutbox";
/** A test waits so long for anything at most: machines that do other things besides are slow. */
export const kPatience = Number(process.env.LAYOUTBOX_PATIENCE ?? 60000);

// The window's wall is named: what the tests drag and move must not depend on which of the good layouts is found.
export const kBedroom = "A bedroom (4 x 3.5 m) with a window in the right wall, a bed against the left wall, a nightstand beside the bed with a lamp on it, and a desk under the window.";

/** `layoutbox serve` on a free port, in a folder of its own. */
export class Service {
  static async start(environment = {}, folder = mkdtempSync(join(tmpdir(), "studio "))) {
    const service = new Service();
    service.folder = folder;
    service.process = spawn(program, ["serve", "--port", "0", "--folder", folder, "--page", join(source, "build/page")], {
      stdio: ["ignore", "ignore", "pipe"], env: {...process.env, ...environment},
    });
    service.ended = new Promise((resolve) => service.process.once("exit", resolve));
    service.url = await new Promise((resolve, reject) => {
      let said = "";
      const late = setTimeout(() => reject(new Error(`the service does not start: ${said}`)), kPatience);
      service.process.stderr.setEncoding("utf8").on("data", (text) => {
        said += text;
        const found = /http:\/\/\S+?\//.exec(said);
        if (found) {
          clearTimeout(late);
          resolve(found[0]);
        }
      });
      service.process.once("exit", (code) => reject(new Error(`the service ended with ${code}: ${said}`)));
    });
    return service;
  }

  async stop(signal = "SIGINT") {
    const late = setTimeout(() => this.process.kill("SIGKILL"), kPatience);
    this.process.kill(signal);
    await this.ended;
    clearTimeout(late);
  }

  async ask(method, path, body) {
    const answer = await fetch(this.url.slice(0, -1) + path, {
      method, ...(body === undefined ? {} : {body: JSON.stringify(body), headers: {"Content-Type": "application/json"}}),
    });
    return {status: answer.status, body: await answer.json().catch(() => null)};
  }
}

function browser_program() {
  const names = [process.env.LAYOUTBOX_CHROMIUM, "/usr/bin/chromium", "/usr/bin/google-chrome"];
  return names.find((name) => name && existsSync(name));
}

export const browser_options = () => ({
  executablePath: browser_program(), args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});

/** One service and one browser for the tests of a file; each test opens pages of its own. */
export function studio(environment = {}) {
  const self = {service: null, browser: null};
  before(async () => {
    self.service = await Service.start(environment);
    self.browser = await chromium.launch(browser_options());
  }, {timeout: 2 * kPatience});
  after(async () => {
    await self.browser?.close();
    await self.service?.stop();
    if (self.service) rmSync(self.service.folder, {recursive: true, force: true});
  }, {timeout: 2 * kPatience});
  /** A page in a context of its own; what it logs as an error fails the test at `close`. */
  self.open = async (options = {}, path = "") => {
    const context = await self.browser.newContext({viewport: {width: 1360, height: 820}, ...options});
    context.setDefaultTimeout(kPatience);
    return self.tab(context, path);
  };
  self.tab = async (context, path = "") => {
    const page = await context.newPage();
    page.faults = [];
    page.on("pageerror", (error) => page.faults.push(String(error)));
    page.on("console", (line) => { if (line.type() === "error" && !/Failed to load resource/.test(line.text())) page.faults.push(line.text()); });
    await page.goto(self.service.url + path);
    return page;
  };
  return self;
}

export const id = (page, name) => page.getByTestId(name);

/** Types a description and waits until the room is there, in the plan and in 3D. */
export async function furnish(page, prompt = kBedroom) {
  await id(page, "prompt").first().fill(prompt);
  await id(page, "prompt").first().press("Enter");
  await ready(page);
}

export async function ready(page) {
  await id(page, "plan").waitFor();
  await page.locator("[data-testid=view3d][data-state=ready]").waitFor();
}

/** The room that the page has, as it keeps it for a reload. */
export const layout_of = (page) => page.evaluate(() => JSON.parse(sessionStorage.getItem("layoutbox.room"))?.layout);

export const object_of = async (page, name) => (await layout_of(page)).objects.find((one) => one.id === name);

/** The middle of what is drawn, in pixels. */
export async function middle(locator) {
  const box = await locator.boundingBox();
  return {x: box.x + box.width / 2, y: box.y + box.height / 2};
}

/** The right corner at the top of what is drawn: its middle may be under what stands on it. */
export async function corner(locator) {
  const box = await locator.boundingBox();
  return {x: box.x + box.width - 6, y: box.y + 6};
}

/** A drag of the mouse by so many pixels; the button stays down. */
export async function drag(page, from, dx, dy, steps = 6) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let i = 1; i <= steps; ++i) await page.mouse.move(from.x + (dx * i) / steps, from.y + (dy * i) / steps);
}

const axe = readFileSync(join(source, "web/node_modules/axe-core/axe.min.js"), "utf8");

/** What axe finds wrong, a line each. */
export async function axe_faults(page) {
  await page.evaluate(axe);
  const {violations} = await page.evaluate(() => globalThis.axe.run(document, {runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"]}));
  return violations.flatMap((one) => one.nodes.map((node) => `${one.id}: ${node.target.join(" ")} ${node.failureSummary?.split("\n")[1] ?? ""}`));
}
