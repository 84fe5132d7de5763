// Takes a picture of each state of the studio, to be looked at: node tests/studio/pictures.mjs [FOLDER [png]], by default docs/pictures.
import {mkdirSync, mkdtempSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {Service, browser_options, chromium, drag, furnish, id, kBedroom, middle, ready, source} from "./studio.mjs";

const folder = process.argv[2] ?? join(source, "docs/pictures");
mkdirSync(folder, {recursive: true});
const service = await Service.start();
const browser = await chromium.launch(browser_options());
let page;
const open = async (options = {}, path = "") => {
  const context = await browser.newContext({viewport: {width: 1360, height: 820}, ...options});
  page = await context.newPage();
  await page.goto(service.url + path);
};
const lossless = process.argv[3] === "png";
const shoot = async (name) => {
  await page.waitForTimeout(700);
  const path = join(folder, `${name === "room" ? "studio" : `studio-${name}`}.${lossless ? "png" : "jpg"}`);
  await page.screenshot({path, ...(lossless ? {} : {type: "jpeg", quality: 55})});
};
const ask = async (path, body) => (await fetch(service.url.slice(0, -1) + path, body && {
  method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(body),
}));
/** A folder with rooms as a run leaves them: ID/layout.json and Blender's ID/scene.png. */
const rooms_to_rate = async (prompts) => {
  const rooms = mkdtempSync(join(tmpdir(), "rooms "));
  for (const [i, prompt] of prompts.entries()) {
    const layout = (await (await ask("/api/generate", {prompt})).json()).layouts[0];
    let job = await (await ask("/api/jobs", {kind: "render", layout, quality: "draft", views: ["iso"]})).json();
    while (job.state === "waiting" || job.state === "running") {
      await new Promise((resolve) => setTimeout(resolve, 500));
      job = await (await ask(`/api/jobs/${job.id}`)).json();
    }
    if (job.state !== "done") throw new Error(`the picture failed: ${job.error?.message}`);
    const picture = await ask(`/api/jobs/${job.id}/files/${job.files.find((name) => name.endsWith(".png"))}`);
    mkdirSync(join(rooms, `room-${i}`));
    writeFileSync(join(rooms, `room-${i}`, "scene.png"), Buffer.from(await picture.arrayBuffer()));
    writeFileSync(join(rooms, `room-${i}`, "layout.json"), JSON.stringify(layout));
  }
  return rooms;
};
const kClash = "A room of 4 x 3 m with a table, a chair and a plant. The chair is left of the table. The chair is right of the table.";
const kLiving = "A living room with a sofa facing the TV, a coffee table on a rug, two armchairs, a bookshelf against the left wall and a plant in the corner";

try {
  await open();
  await shoot("start");
  await id(page, "open-form").click();
  await id(page, "form-kind").fill("office");
  await id(page, "form-shape").selectOption("l");
  for (const name of ["desk", "bookshelf"]) {
    await id(page, "form-search").fill(name);
    await id(page, `form-add-${name}`).click();
  }
  await id(page, "form-window").click();
  await id(page, "form-relation").click();
  await shoot("form");
  await id(page, "form-go").click();
  await ready(page);
  await shoot("outline");
  await furnish(page, kLiving);
  await page.waitForTimeout(1500);
  await shoot("room");
  const relation = page.locator(".relation").first();
  await relation.click();
  await shoot("relation");
  await relation.click();
  await page.locator("[data-testid^=opening-window]").first().click();
  await shoot("window");
  await id(page, "tab-things").click();
  await id(page, "thing-coffee_table_1").click();
  await shoot("things");
  const shelf = id(page, "thing-bookshelf_1");
  await shelf.click();
  const top = await middle(id(page, "knob3d-height"));
  await drag(page, {x: top.x, y: top.y + 22}, 60, -10);
  await shoot("hand-in-3d");
  await page.mouse.up();
  await page.waitForTimeout(500);
  await id(page, "undo").click();
  await id(page, "outlining").click();
  await id(page, "split-wall2").click();
  await id(page, "corner-3").waitFor();
  await page.waitForTimeout(2000);
  const half = await middle(id(page, "split-wall5"));
  await drag(page, {x: half.x + 4, y: half.y - 40}, -60, 0);
  await shoot("outline-redrawn");
  await page.mouse.up();
  await page.waitForTimeout(3000);
  await id(page, "outlining").click();
  for (let i = 0; i < 2; ++i) await id(page, "undo").click();
  await ready(page);
  await id(page, "edit-text").fill("move the bookshelf to the back wall and add a floor lamp");
  await id(page, "edit-go").click();
  await page.locator("[data-testid=proposal], [data-testid=error]").first().waitFor();
  await shoot("proposal");
  await furnish(page, kBedroom);
  await id(page, "thing-bed_1").click();
  await id(page, "lock").click();
  const [from, to] = [await middle(id(page, "thing-desk_1")), await middle(id(page, "thing-bed_1"))];
  await drag(page, from, to.x - from.x, to.y - from.y);
  await page.locator(".thing.illegal").waitFor();
  await shoot("refused");
  await page.mouse.up();
  await furnish(page, kClash);
  await shoot("conflict");
  await page.context().close();

  await open({colorScheme: "dark"});
  await furnish(page, kLiving);
  await id(page, "variants").click();
  await id(page, "variant-list").waitFor();
  await ready(page);
  await shoot("dark");
  await id(page, "tab-rooms").click();
  await id(page, "keep-name").fill("Living room");
  await id(page, "keep").click();
  await page.locator("[data-testid^=beside-]").first().click();
  await page.waitForTimeout(3000);
  await shoot("two-rooms");
  await id(page, "compare-close").click();
  await id(page, "walk").click();
  await page.waitForTimeout(1500);
  await shoot("walk");
  await page.context().close();

  await open({viewport: {width: 390, height: 780}, isMobile: true, hasTouch: true, deviceScaleFactor: 2});
  await id(page, "prompt").fill(kLiving);
  await id(page, "furnish").tap();
  await page.locator("[data-testid=view3d][data-state=ready]").waitFor();
  await shoot("phone");
  await id(page, "pane-about").tap();
  await shoot("phone-details");
  await page.context().close();

  await open({}, "#rate");
  await id(page, "rate-folder").setInputFiles(await rooms_to_rate([kBedroom, kLiving]));
  await id(page, "rate-prompt").waitFor();
  await id(page, "score-7").click();
  await shoot("rate");
} finally {
  await browser.close();
  await service.stop();
}
