// Changes by hand and in words, on the real solver; everything can be undone.
import assert from "node:assert/strict";
import {test} from "node:test";
import {corner, drag, furnish, id, kBedroom, layout_of, middle, object_of, studio} from "./studio.mjs";

const here = studio();

const pose = (object) => JSON.stringify([object.pos, object.rotation, object.size]);

/** Waits until a thing stands elsewhere. */
const moved = (page, name, before) =>
  page.waitForFunction(([one, was]) => {
    const found = JSON.parse(sessionStorage.getItem("layoutbox.room")).layout.objects.find((object) => object.id === one);
    return JSON.stringify([found.pos, found.rotation, found.size]) !== was;
  }, [name, before]);

const sound = async (page) => {
  const {body} = await here.service.ask("POST", "/api/verify", {layout: await layout_of(page)});
  return body.checks.filter((check) => check.required && !check.passed).map((check) => check.message);
};

test("a thing dragged elsewhere in the plan stays there, what it was to others is told", async () => {
  const page = await here.open();
  await furnish(page);
  const before = pose(await object_of(page, "nightstand_1"));
  await drag(page, await corner(id(page, "thing-nightstand_1")), 160, 0);
  await page.mouse.up();
  await moved(page, "nightstand_1", before);
  assert.deepEqual(await sound(page), []);
  await id(page, "verdict").filter({hasText: "Changed by hand"}).waitFor();
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("a thing dragged into another is refused with the reason beside it, or the other gives way", async () => {
  const page = await here.open();
  await furnish(page);
  await id(page, "thing-bed_1").click();
  await id(page, "lock").click();
  const before = await layout_of(page);
  const from = await middle(id(page, "thing-desk_1"));
  const to = await middle(id(page, "thing-bed_1"));
  await drag(page, from, to.x - from.x, to.y - from.y);
  await page.locator(".thing.illegal").waitFor();
  await page.locator(".reason text").first().waitFor();
  await page.mouse.up();
  await id(page, "reason").waitFor();
  assert.deepEqual((await layout_of(page)).objects, before.objects);
  await id(page, "thing-bed_1").click();
  await id(page, "lock").click();
  // Unlocked, whatever comes of it is sound.
  await drag(page, from, to.x - from.x + 60, to.y - from.y);
  await page.mouse.up();
  await page.locator(".thing.illegal").waitFor({state: "detached"});
  assert.deepEqual(await sound(page), []);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

/** A point on top of the chosen thing in 3D: below the knob that raises it. */
const on_top = async (page) => {
  const knob = await middle(id(page, "knob3d-height"));
  return {x: knob.x, y: knob.y + 20};
};

test("in 3D a thing is dragged, turned, resized and raised, with its distances beside it", async () => {
  const page = await here.open();
  await furnish(page);
  await id(page, "edit-text").fill("remove the lamp"); // it would be under the pointer
  await id(page, "edit-go").click();
  await id(page, "ghost-take").click();
  await id(page, "thing-nightstand_1").click();
  await id(page, "knob3d-turn").waitFor();
  const now = () => object_of(page, "nightstand_1");
  const by_hand = async (from, dx, dy) => {
    const before = pose(await now());
    await drag(page, from, dx, dy);
    await page.mouse.up();
    await moved(page, "nightstand_1", before);
    assert.deepEqual(await sound(page), []);
  };
  const start = await now();
  await drag(page, await on_top(page), 120, 10);
  await page.locator(".handles .measure").first().waitFor();
  await page.mouse.up();
  await moved(page, "nightstand_1", pose(start));
  await by_hand(await middle(id(page, "knob3d-turn")), 60, -60);
  assert.notEqual((await now()).rotation, start.rotation);
  const [w, d, h] = (await now()).size;
  await by_hand(await middle(id(page, "knob3d-resize")), 30, 25);
  assert.notDeepEqual((await now()).size.slice(0, 2), [w, d]);
  await by_hand(await middle(id(page, "knob3d-height")), 0, -30);
  assert.ok((await now()).size[2] > h + 0.05, `${(await now()).size[2]} is not higher than ${h}`);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("the outline of a finished room is redrawn: corners, a step in a wall, by mouse and by keys; all of it can be undone", async () => {
  const page = await here.open();
  await furnish(page);
  const polygon = async () => JSON.stringify((await layout_of(page)).room.polygon);
  const first = await polygon();
  const changed = (was) => page.waitForFunction((text) => JSON.stringify(JSON.parse(sessionStorage.getItem("layoutbox.room")).layout.room.polygon) !== text, was);
  await id(page, "outlining").click();
  await drag(page, await middle(id(page, "corner-1")), 60, 60);
  await page.mouse.up();
  await changed(first);
  assert.deepEqual(await sound(page), []);
  const second = await polygon();
  await id(page, "split-wall4").click();
  await changed(second);
  const parted = await polygon();
  assert.equal(JSON.parse(parted).length, 5);
  const half = await middle(id(page, "split-wall5"));
  await drag(page, {x: half.x - 4, y: half.y + 30}, -50, 0); // the wall beside its middle
  await page.mouse.up();
  await changed(parted);
  assert.equal(JSON.parse(await polygon()).length, 6);
  assert.deepEqual(await sound(page), []);
  const stepped = await polygon();
  await id(page, "corner-2").focus();
  await page.keyboard.press("Shift+ArrowUp");
  await changed(stepped);
  const moved_by_keys = await polygon();
  const twice = await middle(id(page, "corner-2"));
  await page.mouse.dblclick(twice.x, twice.y);
  await changed(moved_by_keys);
  assert.equal(JSON.parse(await polygon()).length, 5);
  await page.keyboard.press("Escape");
  await id(page, "corner-2").waitFor({state: "detached"});
  for (let i = 0; i < 5; ++i) await id(page, "undo").click();
  assert.equal(await polygon(), first);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("a thing is turned and resized, and typed to a place", async () => {
  const page = await here.open();
  await furnish(page);
  const bed = pose(await object_of(page, "nightstand_1"));
  const stand = await corner(id(page, "thing-nightstand_1"));
  await page.mouse.click(stand.x, stand.y);
  await id(page, "field-x").fill("2.2");
  await id(page, "field-x").press("Enter");
  await moved(page, "nightstand_1", bed);
  assert.ok(Math.abs((await object_of(page, "nightstand_1")).pos[0] - 2.2) < 0.6);
  const turned = pose(await object_of(page, "nightstand_1"));
  await id(page, "turn-left").click();
  await moved(page, "nightstand_1", turned);
  const wide = pose(await object_of(page, "nightstand_1"));
  await id(page, "field-width").fill("60 cm");
  await id(page, "field-width").press("Enter");
  await moved(page, "nightstand_1", wide);
  assert.equal((await object_of(page, "nightstand_1")).size[0], 0.6);
  assert.deepEqual(await sound(page), []);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("what is typed as soon as a thing is chosen is kept", async () => {
  const page = await here.open();
  await furnish(page);
  const before = pose(await object_of(page, "nightstand_1"));
  await page.getByRole("tab", {name: "Things"}).click();
  await page.evaluate(async () => {
    const rows = [...document.querySelectorAll("[data-testid=things] button")];
    rows.find((row) => row.textContent.startsWith("nightstand")).click();
    for (let turn = 0; turn < 20; ++turn) await null;  // the page is drawn anew, nothing is painted yet
    const field = document.querySelector("[data-testid=field-x]");
    field.value = "2.2";
    field.dispatchEvent(new Event("input", {bubbles: true}));
    await new Promise((done) => setTimeout(done, 300));
    field.dispatchEvent(new KeyboardEvent("keydown", {key: "Enter", bubbles: true}));
  });
  await moved(page, "nightstand_1", before);
  await page.context().close();
});

test("a door is dragged along its wall and round a corner, a wall is drawn outwards", async () => {
  const page = await here.open();
  await furnish(page);
  const door = (layout) => layout.room.openings.find((one) => one.type === "door");
  const before = door(await layout_of(page));
  const changed = (was) => page.waitForFunction((text) => {
    const found = JSON.parse(sessionStorage.getItem("layoutbox.room")).layout.room.openings.find((one) => one.type === "door");
    return JSON.stringify([found.wall, found.offset]) !== text;
  }, JSON.stringify([was.wall, was.offset]));
  const from = await middle(id(page, `opening-${before.id}`));
  const plan = await middle(id(page, "plan"));
  await drag(page, from, 130 * Math.sign(plan.x - from.x), 0);
  await page.mouse.up();
  await changed(before);
  assert.deepEqual(await sound(page), []);
  const wall = await middle(id(page, "wall-wall3"));
  await drag(page, {x: wall.x, y: wall.y}, 0, -60);
  await page.mouse.up();
  await page.waitForFunction(() => Math.max(...JSON.parse(sessionStorage.getItem("layoutbox.room")).layout.room.polygon.map(([, y]) => y)) > 3.6);
  assert.deepEqual(await sound(page), []);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("openings are added, changed and removed", async () => {
  const page = await here.open();
  await furnish(page);
  const count = async () => (await layout_of(page)).room.openings.length;
  const before = await count();
  const until = (number) => page.waitForFunction((wanted) => JSON.parse(sessionStorage.getItem("layoutbox.room")).layout.room.openings.length === wanted, number);
  await id(page, "tab-things").click();
  await id(page, "add-window").click();
  await until(before + 1);
  await id(page, "opening-field-w").fill("0.8");
  await id(page, "opening-field-w").press("Enter");
  await page.waitForFunction(() => JSON.parse(sessionStorage.getItem("layoutbox.room")).layout.room.openings.some((one) => one.w === 0.8));
  await id(page, "opening-remove").click();
  await until(before);
  assert.deepEqual(await sound(page), []);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("a change in words is shown before it is taken, and everything is undone to the start", async () => {
  const page = await here.open();
  await furnish(page);
  const first = await layout_of(page);
  await id(page, "edit-text").fill("move the desk to the back wall");
  await id(page, "edit-go").click();
  await id(page, "proposal").filter({hasText: "desk"}).waitFor();
  assert.ok((await page.locator(".ghost .shape").count()) > 0);
  assert.deepEqual((await layout_of(page)).objects, first.objects);
  await id(page, "ghost-take").click();
  await id(page, "proposal").waitFor({state: "detached"});
  const edited = pose(await object_of(page, "desk_1"));
  assert.notEqual(edited, pose(first.objects.find((one) => one.id === "desk_1")));
  await id(page, "thing-desk_1").focus();
  await page.keyboard.press("Delete");
  await id(page, "thing-desk_1").waitFor({state: "detached"});
  await id(page, "another").click();
  await page.waitForFunction(() => JSON.parse(sessionStorage.getItem("layoutbox.room")).seed === 2);
  for (let i = 0; i < 3; ++i) await id(page, "undo").click();
  assert.deepEqual((await layout_of(page)).objects, first.objects);
  await id(page, "redo").click();
  assert.equal(pose(await object_of(page, "desk_1")), edited);
  await id(page, "undo").click();
  assert.deepEqual((await layout_of(page)).objects, first.objects);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("what nobody can do is said, and a change of nothing offers nothing to take", async () => {
  const page = await here.open();
  await furnish(page);
  await id(page, "edit-text").fill("paint the moon");
  await id(page, "edit-go").click();
  await page.locator("[data-testid=error], [data-testid=proposal]").first().waitFor();
  assert.equal(await id(page, "ghost-take").count(), 0);
  await page.context().close();
});

test("by touch: a tap chooses, a drag moves, two panes one after the other", async () => {
  const page = await here.open({viewport: {width: 390, height: 780}, hasTouch: true, isMobile: true, deviceScaleFactor: 2});
  await id(page, "prompt").fill(kBedroom);
  await id(page, "furnish").tap();
  await page.locator("[data-testid=view3d][data-state=ready]").waitFor();
  await id(page, "pane-plan").tap();
  const at = await middle(id(page, "thing-desk_1"));
  await page.touchscreen.tap(at.x, at.y);
  await id(page, "selected").waitFor();
  const before = pose(await object_of(page, "desk_1"));
  Object.assign(at, await middle(id(page, "thing-desk_1")));
  const session = await page.context().newCDPSession(page);
  const touch = (type, x, y) => session.send("Input.dispatchTouchEvent", {type, touchPoints: type === "touchEnd" ? [] : [{x, y}]});
  await touch("touchStart", at.x, at.y);
  for (let i = 1; i <= 8; ++i) await touch("touchMove", at.x, at.y - i * 5);
  await touch("touchEnd");
  await moved(page, "desk_1", before);
  assert.deepEqual(await sound(page), []);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});
