// Takes a picture of each state of the studio: node tests/studio/pictures.mjs [FOLDER], by default docs/pictures. To be looked at.
import {mkdirSync} from "node:fs";
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
const shoot = async (name) => {
  await page.waitForTimeout(700);
  await page.screenshot({path: join(folder, `studio-${name}.jpg`), type: "jpeg", quality: 55});
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
  await id(page, "rate-pictures").setInputFiles(["rooms", "families"].map((name) => join(source, `docs/gallery/${name}.jpg`)));
  await id(page, "score-7").click();
  await shoot("rate");
} finally {
  await browser.close();
  await service.stop();
}
