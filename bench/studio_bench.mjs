// From Enter on an open page to the first frame with all furniture, service included; and draw calls of a large room.
//     LAYOUTBOX_BINARY=build/release/src/layoutbox/layoutbox node bench/studio_bench.mjs [RUNS]
// Needs the built page (scripts/page.sh) and Chromium; the service is one of its own on this machine.
import {readFileSync, readdirSync} from "node:fs";
import {loadavg} from "node:os";
import {Service, browser_options, chromium, furnish, id, ready} from "../tests/studio/studio.mjs";

const runs = Math.min(Number(process.argv[2] ?? 20), 200);
const kRoom = "A bedroom with a double bed, two nightstands with a lamp on each, a wardrobe, a desk under the window, a chair and a rug.";
const kLarge = "A dining hall of 9 by 7 m with four dining tables, six chairs around each table, a sideboard against the left wall and a plant in the corner.";

/** Milliseconds of processor of all that this process has started, the service and the browser: what no other load changes much. */
function processor() {
  const stats = new Map();
  for (const pid of readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
    try {
      const fields = readFileSync(`/proc/${pid}/stat`, "utf8").split(") ")[1].split(" ");
      stats.set(pid, {parent: fields[1], ticks: Number(fields[11]) + Number(fields[12])});
    } catch { /* it has just ended */ }
  }
  const ours = (pid) => pid !== undefined && (pid === String(process.pid) || ours(stats.get(pid)?.parent));
  let sum = 0;
  for (const [pid, {parent, ticks}] of stats) if (pid !== String(process.pid) && ours(parent)) sum += ticks * 10;
  return sum;
}

const service = await Service.start();
const browser = await chromium.launch(browser_options());
try {
  const page = await browser.newPage({viewport: {width: 1360, height: 820}});
  await page.goto(service.url);
  await page.evaluate(() => addEventListener("keydown", (event) => { if (event.key === "Enter") globalThis.began = performance.now(); }, true));
  await furnish(page, kRoom);
  const canvas = page.locator("[data-testid=view3d] canvas");
  const times = [];
  const work = [];
  await page.waitForTimeout(3000); // the first room's shaders are compiled
  for (let run = 0; run < runs; ++run) {
    const before = Number(await canvas.getAttribute("data-room"));
    await page.waitForTimeout(500);
    await id(page, "prompt").fill(`${kRoom} The room is ${(4 + run * 0.05).toFixed(2)} by 4 m.`);
    const spent = processor();
    await id(page, "prompt").press("Enter");
    await page.waitForFunction((last) => Number(document.querySelector("[data-testid=view3d] canvas").dataset.room) > last, before);
    times.push(await canvas.evaluate((element) => Number(element.dataset.at) - globalThis.began));
    work.push(processor() - spent);
  }
  const at = (share, list = times) => list.sort((a, b) => a - b)[Math.min(list.length - 1, Math.floor(share * list.length))].toFixed(0);
  console.log(`Enter to the first frame: p50 ${at(0.5)} ms, p95 ${at(0.95)} ms of ${runs}; p50 of processor ${at(0.5, work)} ms, drawing included; ` +
    `load of the machine ${loadavg()[0].toFixed(1)}`);
  await furnish(page, kLarge);
  await page.waitForFunction(() => JSON.parse(sessionStorage.getItem("layoutbox.room")).layout.objects.length > 20);
  await ready(page);
  await page.waitForTimeout(1000);
  const count = await page.evaluate(() => JSON.parse(sessionStorage.getItem("layoutbox.room")).layout.objects.length);
  console.log(`${await canvas.getAttribute("data-calls")} draw calls with ${count} things`);
} finally {
  await browser.close();
  await service.stop();
}
