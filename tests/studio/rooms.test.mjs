// Rooms from words, from a form and from files; what survives a reload, and what two tabs do to each other.
import assert from "node:assert/strict";
import {readFile} from "node:fs/promises";
import {test} from "node:test";
import {furnish, id, kBedroom, layout_of, ready, studio} from "./studio.mjs";

const here = studio();

test("a prompt becomes a room, with what was understood", async () => {
  const page = await here.open();
  await furnish(page);
  const words = await id(page, "words").textContent();
  assert.ok(words.includes("a nightstand beside the bed"), words);
  await id(page, "verdict").filter({hasText: "All as asked"}).waitFor();
  await id(page, "checks").filter({hasText: /All \d+ checks passed/}).waitFor();
  const layout = await layout_of(page);
  const relation = layout.relations.find((one) => one.type === "nextTo");
  await id(page, `relation-${relation.id}`).click();
  await id(page, `relation-${relation.id}`).filter({hasText: /0\.\d\d m apart/}).waitFor();
  assert.equal(await page.locator(".thing.about").count(), 2);
  const calls = Number(await page.locator("[data-testid=view3d] canvas").getAttribute("data-calls"));
  assert.ok(calls > 0 && calls < 150, `${calls} draw calls`);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("a form becomes a room: kind, size, furniture, an opening and a relation", async () => {
  const page = await here.open();
  await id(page, "open-form").click();
  await id(page, "form-kind").fill("office");
  await id(page, "form-w").fill("13'");
  await id(page, "form-d").fill("300 cm");
  for (const name of ["desk", "bookshelf"]) {
    await id(page, "form-search").fill(name);
    await id(page, `form-add-${name}`).click();
  }
  await id(page, "form-search").fill("Grandfather's globe");
  await id(page, "form-own").click();
  await id(page, "form-window").click();
  await id(page, "form-relation").click();
  await id(page, "form-go").click();
  await ready(page);
  const layout = await layout_of(page);
  const xs = layout.room.polygon.map(([x]) => x);
  assert.ok(Math.abs(Math.max(...xs) - Math.min(...xs) - 3.96) < 0.02, "13 feet wide");
  assert.deepEqual(layout.room.openings.map((one) => one.type).sort(), ["door", "window"]);
  for (const word of ["desk", "bookshelf", "globe"]) assert.ok(layout.objects.some((one) => one.name.toLowerCase().includes(word)), word);
  assert.ok(layout.relations.some((one) => one.type === "againstWall" && one.targets.includes("desk_1") && one.origin === "asked"));
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("a conflict is told in words, and each way out is a button", async () => {
  const page = await here.open();
  await furnish(page, "A room of 4 x 3 m with a table, a chair and a plant. The chair is left of the table. The chair is right of the table.");
  await id(page, "conflicts").waitFor();
  await id(page, "verdict").filter({hasText: "Not all as asked"}).waitFor();
  const text = await id(page, "conflicts").textContent();
  assert.match(text, /chair/);
  await id(page, "remedies").waitFor({state: "detached"}); // the other side is what the other sentence says: it is no further way out
  await id(page, "conflicts").getByRole("button", {name: /Do without/}).first().click();
  await id(page, "conflicts").waitFor({state: "detached"});
  await id(page, "verdict").filter({hasText: "All as asked"}).waitFor();
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("changes that the solver has tried are offered, and give a room as asked", async () => {
  const page = await here.open();
  await furnish(page, "A bedroom of 3 x 2.5 m with a king size bed and a piano. The bed is against the left wall. The piano is against the left wall.");
  await id(page, "remedy-0").filter({hasText: /Rather “The (piano|bed) stands with its back against the/}).waitFor();
  await id(page, "remedy-0").click();
  await id(page, "verdict").filter({hasText: "All as asked"}).waitFor();
  await id(page, "remedies").waitFor({state: "detached"});
  await id(page, "undo").click();
  await id(page, "conflicts").waitFor();
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("a layout that was downloaded can be opened again, also one with something left out", async () => {
  const page = await here.open();
  await furnish(page, "A room of 1.2 x 1.2 m with a piano, a stool in front of the piano and a lamp on the piano.");
  await id(page, "relaxed").waitFor();
  await id(page, "tab-files").click();
  const [download] = await Promise.all([page.waitForEvent("download"), id(page, "download-json").click()]);
  const path = await download.path();
  const before = JSON.parse(await readFile(path, "utf8"));
  const second = await here.open();
  await id(second, "open-file").setInputFiles({name: "layout.json", mimeType: "application/json", buffer: await readFile(path)});
  await ready(second);
  assert.deepEqual(await layout_of(second), before);
  await id(second, "relaxed").waitFor();
  await id(second, "tab-things").click();
  await id(second, "add-search").fill("stool");
  await id(second, "add-stool").click();
  await second.waitForFunction((count) => JSON.parse(sessionStorage.getItem("layoutbox.room")).layout.objects.length > count, before.objects.length);
  for (const one of [page, second]) {
    assert.deepEqual(one.faults, []);
    await one.context().close();
  }
});

test("what is no room says so, and the room on the screen stays", async () => {
  const page = await here.open();
  await furnish(page);
  await id(page, "tab-files").click();
  for (const text of ["{", "[1, 2]", '{"objects": [], "room": {}}']) {
    await id(page, "open-file").setInputFiles({name: "x.json", mimeType: "application/json", buffer: Buffer.from(text)});
    await id(page, "error").waitFor();
    await id(page, "error").getByRole("button").click();
  }
  assert.ok((await layout_of(page)).objects.length > 3);
  await page.context().close();
});

test("a picture's job goes on over a reload, and can be cancelled", async (self) => {
  const page = await here.open();
  const job_of = () => page.evaluate(() => sessionStorage.getItem("layoutbox.job"));
  const state_of = async (job) => (await here.service.ask("GET", `/api/jobs/${job}`)).body.state;
  await furnish(page);
  await id(page, "tab-files").click();
  await id(page, "picture-quality").selectOption("final"); // takes long enough to be at work still when the page is there again
  await id(page, "picture-start").click();
  await id(page, "picture-progress").waitFor();
  const job = await job_of();
  await page.reload();
  await ready(page);
  await id(page, "tab-files").click();
  await page.locator("[data-testid=picture-progress], [data-testid=picture] .bad").first().waitFor();
  if ((await state_of(job)) === "failed") return self.skip("there is no Blender");
  assert.equal(await job_of(), job);
  assert.ok(["waiting", "running"].includes(await state_of(job)));
  await id(page, "picture-cancel").click();
  await id(page, "picture-start").waitFor();
  assert.equal(await state_of(job), "cancelled");
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("two tabs have a room each; what one keeps the other can open and put beside its own", async () => {
  const first = await here.open();
  const second = await here.tab(first.context());
  await furnish(first);
  await furnish(second, "A bathroom with a bathtub, a toilet and a sink.");
  assert.notEqual((await layout_of(first)).prompt, (await layout_of(second)).prompt);
  await id(first, "tab-rooms").click();
  await id(first, "keep-name").fill("My bedroom");
  await id(first, "keep").click();
  await first.getByText("My bedroom", {exact: true}).waitFor();
  const address = first.url();
  assert.match(address, /#room=[0-9a-f]{16}$/);
  await id(second, "tab-rooms").click();
  await second.locator("[data-testid^=beside-]").first().click();
  await id(second, "compare").waitFor();
  await id(second, "compare-close").click();
  await second.getByText("My bedroom", {exact: true}).click();
  await second.waitForFunction((prompt) => JSON.parse(sessionStorage.getItem("layoutbox.room")).layout.prompt === prompt, kBedroom);
  await id(second, "undo").click();
  assert.match((await layout_of(second)).prompt, /bathroom/);
  const third = await here.tab(first.context(), address.slice(here.service.url.length));
  await ready(third);
  assert.equal((await layout_of(third)).prompt, kBedroom);
  for (const page of [first, second, third]) assert.deepEqual(page.faults, []);
  await first.context().close();
});

test("an outline is drawn in the form, by dragging and by keys", async () => {
  const page = await here.open();
  await id(page, "open-form").click();
  await id(page, "form-kind").fill("office");
  await id(page, "form-shape").selectOption("l");
  await id(page, "outline-corner-1").focus();
  for (let i = 0; i < 5; ++i) await page.keyboard.press("ArrowRight");
  await id(page, "outline-add-0").click();
  await id(page, "outline-corner-1").waitFor();
  await page.keyboard.press("Tab");
  await id(page, "form-go").click();
  await ready(page);
  const {polygon} = (await layout_of(page)).room;
  assert.equal(Math.max(...polygon.map(([x]) => x)), 5.5);
  assert.ok(polygon.length >= 6);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("pictures of rooms are rated, and a table comes out", async () => {
  const page = await here.open({}, "#rate");
  const picture = {mimeType: "image/png", buffer: Buffer.from("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==", "base64")};
  await id(page, "rate-pictures").setInputFiles(["a", "b"].map((name) => ({...picture, name: `${name}.png`})));
  await id(page, "score-7").click();
  await id(page, "rate-kind").selectOption("place");
  await id(page, "rate-reason").fill("the desk, askew");
  await id(page, "rate-next").click();
  await id(page, "rate-count").filter({hasText: "2 of 2"}).waitFor();
  await page.keyboard.press("0");
  await id(page, "rate-count").filter({hasText: "2 rated"}).waitFor();
  const [download] = await Promise.all([page.waitForEvent("download"), id(page, "rate-save").click()]);
  const rows = (await readFile(await download.path(), "utf8")).trim().split("\n");
  assert.equal(rows[0], "id,score,kind,reason,prompt");
  assert.deepEqual(rows.slice(1).map((row) => row.split(",")[1]).sort(), ["10", "7"]);
  assert.ok(rows.some((row) => row.endsWith(',place,"the desk, askew",')), rows.join("; "));
  assert.deepEqual(page.faults, []);
  await page.context().close();
});
