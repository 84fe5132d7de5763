// By keyboard alone, on a phone's width, in dark and light: nothing runs out of the page, and axe finds nothing.
import assert from "node:assert/strict";
import {test} from "node:test";
import {axe_faults, furnish, id, kBedroom, layout_of, object_of, ready, studio} from "./studio.mjs";

const here = studio();

const tab_to = async (page, wanted) => {
  for (let i = 0; i < 80; ++i) {
    await page.keyboard.press("Tab");
    if ((await page.evaluate(() => document.activeElement?.dataset.testid)) === wanted) return;
  }
  assert.fail(`Tab does not lead to ${wanted}`);
};

test("by keyboard alone: a room made, a thing chosen, moved, turned, locked, removed, undone", async () => {
  const page = await here.open();
  await page.keyboard.type(kBedroom); // the box has the focus from the start
  await page.keyboard.press("Enter");
  await ready(page);
  await tab_to(page, "thing-desk_1");
  const before = await object_of(page, "desk_1");
  for (let i = 0; i < 3; ++i) await page.keyboard.press("Shift+ArrowLeft");
  await page.waitForFunction((x) => {
    const found = JSON.parse(sessionStorage.getItem("layoutbox.room")).layout.objects.find((one) => one.id === "desk_1");
    return found.pos[0] < x - 0.25;
  }, before.pos[0]);
  await page.keyboard.press("l");
  await page.waitForFunction(() => JSON.parse(sessionStorage.getItem("layoutbox.room")).locked.includes("desk_1"));
  await page.keyboard.press("l");
  await page.keyboard.press("Delete");
  await id(page, "thing-desk_1").waitFor({state: "detached"});
  await page.keyboard.press("Control+z");
  await id(page, "thing-desk_1").waitFor();
  for (let i = 0; i < 3; ++i) await page.keyboard.press("Control+z");
  assert.deepEqual((await object_of(page, "desk_1")).pos, before.pos);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("a form is filled in by keyboard alone", async () => {
  const page = await here.open();
  await tab_to(page, "open-form");
  await page.keyboard.press("Enter");
  await tab_to(page, "form-kind");
  await page.keyboard.type("bedroom");
  await tab_to(page, "form-search");
  await page.keyboard.type("wardrobe");
  await id(page, "form-add-wardrobe").waitFor();
  await page.keyboard.press("Enter");
  await tab_to(page, "form-go");
  await page.keyboard.press("Enter");
  await ready(page);
  assert.ok((await layout_of(page)).objects.some((one) => one.category === "wardrobe"));
  await page.context().close();
});

test("a walk through the room at eye level, by keys, ends with Escape", async () => {
  const page = await here.open();
  await furnish(page);
  await id(page, "walk").click();
  await page.keyboard.down("ArrowUp");
  await page.waitForTimeout(200);
  await page.keyboard.up("ArrowUp");
  assert.equal(await id(page, "walk").getAttribute("aria-pressed"), "true");
  await page.keyboard.press("Escape");
  assert.equal(await id(page, "walk").getAttribute("aria-pressed"), "false");
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

for (const width of [320, 390, 768, 1024]) {
  test(`nothing runs out of a window ${width} wide`, async () => {
    const page = await here.open({viewport: {width, height: 740}});
    const beyond = () => page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.ok((await beyond()) <= 0, "first page");
    await id(page, "prompt").fill(kBedroom);
    await id(page, "prompt").press("Enter");
    await page.locator("[data-testid=view3d][data-state=ready]").waitFor();
    assert.ok((await beyond()) <= 0, "room");
    if (width < 760) await id(page, "pane-about").click();
    for (const name of ["things", "files", "rooms"]) {
      await id(page, `tab-${name}`).click();
      assert.ok((await beyond()) <= 0, name);
    }
    await id(page, "form").click();
    assert.ok((await beyond()) <= 0, "form");
    await page.context().close();
  });
}

for (const colorScheme of ["light", "dark"]) {
  test(`axe finds nothing in any state, ${colorScheme}`, async () => {
    const page = await here.open({colorScheme});
    const faults = [];
    const look = async (state) => faults.push(...(await axe_faults(page)).map((fault) => `${state}: ${fault}`));
    await look("start");
    await id(page, "open-form").click();
    await id(page, "form-search").fill("desk");
    await id(page, "form-add-desk").click();
    for (const name of ["form-window", "form-relation"]) await id(page, name).click();
    await look("form");
    await id(page, "form-close").click();
    await furnish(page, "A room of 4 x 3 m with a table, a chair and a plant. The chair is left of the table. The chair is right of the table. A gizmoid.");
    await look("conflict");
    await page.locator("[data-testid^=thing-]").first().click();
    await look("chosen");
    await id(page, "outlining").click();
    await look("outline");
    await id(page, "outlining").click();
    for (const name of ["things", "files", "rooms"]) {
      await id(page, `tab-${name}`).click();
      await look(name);
    }
    await id(page, "edit-text").fill("remove the plant");
    await id(page, "edit-go").click();
    await id(page, "proposal").waitFor();
    await look("proposal");
    assert.deepEqual(faults, []);
    await page.context().close();
  });
}
