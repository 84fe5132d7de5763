import assert from "node:assert/strict";
import {test} from "node:test";
import {form_scene, things_of, wrong_lengths} from "../src/pure/form_scene";
import {moved_corner, outline_area, polygon_of, shape_of, with_corner, without_corner} from "../src/pure/outline";
import {mixed, ratings_csv, rooms_of} from "../src/pure/ratings";
import {relation_text} from "../src/pure/relations";
import {only_gives_up, remedy_text} from "../src/pure/remedies";
import {fresh_id, names_of, open_scene, scene_of, shape_key, with_load, with_names, without, without_opening} from "../src/pure/scenes";
import {length_text, read_length} from "../src/pure/units";
import {named_in_role, pieces} from "../src/pure/words";
import {begin, pushed, redone, undone} from "../src/state/history";
import {Latest} from "../src/state/latest";
import {room} from "./sample";

test("lengths are read as people write them", () => {
  const cases: [string, "m" | "ft", number | null][] = [
    ["1.2", "m", 1.2], ["1,2 m", "m", 1.2], ["120 cm", "m", 1.2], ["120cm", "ft", 1.2], ["4'", "m", 1.2192], ["4' 6\"", "ft", 1.3716],
    ["4 ft 6 in", "m", 1.3716], ["4' 6", "ft", 1.3716], ["6", "ft", 1.8288], ["", "m", null], ["wide", "m", null], ["1 m wide", "m", null],
  ];
  for (const [text, units, metres] of cases) {
    const read = read_length(text, units);
    assert.ok(metres === null ? read === null : Math.abs((read ?? 0) - metres) < 1e-9, `${text}: ${read}`);
  }
  assert.equal(length_text(1.3716, "ft"), "4' 6\"");
  assert.equal(length_text(1.2, "m"), "1.20 m");
});

test("words are cut by bytes, neighbours of one meaning are one", () => {
  const prompt = "Grün: a désk";
  const words = [
    {begin: 0, end: 5, use: "notUnderstood" as const, role: "?"},
    {begin: 7, end: 8, use: "used" as const, role: "object desk_1"},
    {begin: 9, end: 14, use: "used" as const, role: "object desk_1"},
  ];
  assert.deepEqual(pieces(prompt, words).map((piece) => piece.text), ["Grün", ": ", "a désk"]);
  assert.equal(named_in_role("object desk_1", new Set(["desk_1"])), "desk_1");
});

const sentences = new Map([
  ["againstWall", {sentence: "{targets} stands with its back against {references}", unnamed: "a wall"}],
  ["nextTo", {sentence: "{targets} stands next to {references}", unnamed: "the room"}],
]);

test("relations become sentences", () => {
  const layout = room();
  assert.equal(relation_text(layout.relations![0]!, layout, sentences, "m"), "The bed stands with its back against the back wall");
  assert.equal(relation_text(layout.relations![1]!, layout, sentences, "m"), "Nightstand 1 and 2 stand next to the bed");
  const {relativeTo: _, ...anywhere} = layout.relations![0]!;
  assert.equal(relation_text(anywhere, layout, sentences, "m"), "The bed stands with its back against a wall");
});

test("a changed scene is told by what is other than before", () => {
  const layout = room();
  const scene = scene_of(layout);
  const told = (after: typeof scene) => remedy_text(scene, after, layout, sentences, "m");
  assert.equal(told(JSON.parse(JSON.stringify(scene))), "");
  assert.equal(told({...scene, furniture: scene.furniture.slice(1), constraints: scene.constraints!.slice(1)}), "Leave out the bed");
  const [first, ...rest] = scene.constraints!;
  assert.equal(told({...scene, constraints: rest}), "Do without “The bed stands with its back against the back wall”");
  assert.equal(told({...scene, constraints: [{...first!, relativeTo: "wall4"}, ...rest]}), "Rather “The bed stands with its back against the left wall”");
  assert.equal(told({...scene, constraints: [{...first!, hard: false}, ...rest]}), "Only where it can be: “The bed stands with its back against the back wall”");
  assert.equal(told({...scene, room: {dims: {h: 2.7, w: 4.5, d: 3.5}}}), "Make the room 4.50 m × 3.50 m");
  const smaller = scene.furniture.map((one, i) => (i === 0 ? {...one, dims: {d: 2, h: 0.5, w: 1.4}} : one));
  assert.equal(told({...scene, furniture: smaller}), "Make the bed 1.40 m × 2.00 m");
});

test("a way that only gives up what is in conflict is known as such", () => {
  const scene = scene_of(room());
  const [first, ...rest] = scene.constraints!;
  assert.equal(only_gives_up(scene, {...scene, constraints: rest}, ["c1"]), true);
  assert.equal(only_gives_up(scene, {...scene, constraints: [{...first!, hard: false}, ...rest]}, ["c2", "c1"]), true);
  assert.equal(only_gives_up(scene, {...scene, constraints: rest}, ["c2"]), false);
  assert.equal(only_gives_up(scene, {...scene, constraints: [{...first!, relativeTo: "wall4"}, ...rest]}, ["c1"]), false);
});

test("a distance that is open at one end is said so", () => {
  const layout = room();
  const sentences = new Map([["distance", {sentence: "{targets} stands between {min} and {max} from {references}", unnamed: "the room"}]]);
  const relation = {type: "distance" as const, targets: ["bed_1"], relativeTo: "wall1", min: 1};
  assert.equal(relation_text(relation, layout, sentences, "m"), "The bed stands at least 1.00 m from the front wall");
});

test("a thing goes with what stands on it and with its relations", () => {
  const layout = room();
  assert.deepEqual([...with_load(layout, "stand_1")], ["stand_1", "lamp_1"]);
  const left = without(layout, "stand_1");
  assert.deepEqual(left.objects.map((object) => object.id), ["bed_1", "stand_2"]);
  assert.deepEqual(left.relations!.map((relation) => relation.targets), [["bed_1"], ["stand_2"]]);
  assert.equal(layout.objects.length, 4);
});

test("a layout is a scene again", () => {
  const layout = room();
  const scene = scene_of(layout);
  assert.deepEqual(scene.furniture[0]!.dims, {w: 1.6, d: 2, h: 0.5});
  assert.equal(scene.room.openings![0]!.wallId, "wall1");
  const free = open_scene(layout, ["bed_1"]);
  assert.equal(free.furniture[0]!.fixed, true);
  assert.equal(free.furniture[1]!.xform, undefined);
});

test("places do not change what is drawn, sizes do", () => {
  const layout = room();
  const moved = {...layout, objects: layout.objects.map((object) => ({...object, pos: [0, 0, 0] as [number, number, number]}))};
  assert.equal(shape_key(layout), shape_key(moved));
  const grown = {...layout, objects: layout.objects.map((object) => ({...object, size: [1, 1, 1] as [number, number, number]}))};
  assert.notEqual(shape_key(layout), shape_key(grown));
});

test("names tell things of a kind apart, ids in messages become names", () => {
  const names = names_of(room());
  assert.equal(names.get("stand_2"), "nightstand 2");
  assert.equal(names.get("lamp_1"), "table lamp");
  assert.equal(with_names("bed_1 is within the room", names), "bed is within the room");
  assert.equal(fresh_id(["desk_1"], "desk"), "desk_2");
});

test("the form asks for a scene", () => {
  const piece = {key: 1, category: "chair", name: "chair", count: "2", w: "50 cm", d: "", h: ""};
  const value = {
    kind: "office", w: "4", d: "3", h: "", pieces: [piece], openings: [{key: 2, type: "door" as const, wall: "wall1", offset: "0.5", w: ""}], outline: null,
    relations: [{key: 3, type: "row", subject: "chair_1,chair_2", reference: ""}],
  };
  const scene = form_scene(value, "m");
  assert.deepEqual(scene.furniture.map((object) => object.id), ["chair_1", "chair_2"]);
  assert.deepEqual(scene.furniture[0]!.dims, {w: 0.5});
  assert.deepEqual(scene.room.dims, {w: 4, d: 3});
  assert.deepEqual(scene.room.openings, [{id: "door1", type: "door", wallId: "wall1", offset: 0.5}]);
  const windows = form_scene({...value, openings: [{key: 2, type: "window", wall: "", offset: "", w: ""}]}, "m").room.openings;
  assert.deepEqual(windows, [{id: "window1", type: "window"}, {id: "door1", type: "door", origin: "assumed"}]);
  assert.deepEqual(scene.constraints![0]!.targets, ["chair_1", "chair_2"]);
  assert.deepEqual(wrong_lengths({...value, w: "wide"}, "m"), ["wide"]);
  assert.equal(things_of([piece])[1]!.name, "chair 2");
});

test("undo and redo go to the ends", () => {
  const three = pushed(pushed(begin(1), 2), 3);
  assert.equal(undone(undone(undone(three))).now, 1);
  assert.equal(redone(undone(three)).now, 3);
  assert.deepEqual(pushed(undone(three), 4).future, []);
});

test("one request in flight, the latest wins", async () => {
  const sent: number[] = [];
  const got: number[] = [];
  const latest = new Latest<number, number>(
    async (ask) => {
      sent.push(ask);
      await new Promise((resolve) => setTimeout(resolve, 5));
      return ask;
    },
    (answer) => got.push(answer),
    () => assert.fail("refused"),
  );
  for (const ask of [1, 2, 3, 4]) latest.push(ask);
  await latest.settled();
  assert.deepEqual(sent, [1, 4]);
  assert.deepEqual(got, [1, 4]);
});

test("an outline drawn by hand runs counter-clockwise from the corner, on the grid", () => {
  assert.deepEqual(polygon_of([[1, 1], [1, 4], [5, 4], [5, 1]]), [[4, 0], [4, 3], [0, 3], [0, 0]]);
  const corners = shape_of("l", 5, 4);
  assert.equal(corners.length, 6);
  assert.equal(Math.round(outline_area(corners) * 10) / 10, 16.6);
  assert.deepEqual(moved_corner(corners, 1, [6.04, -0.06])[1], [6, -0.1]);
  assert.equal(with_corner(corners, 5).length, 7);
  assert.equal(without_corner(without_corner(corners.slice(0, 4), 0), 0).length, 3);
});

test("what was left out is no part of the scene, nor what was said of it alone", () => {
  const layout = without(room(), "nobody");
  const left = {...layout, objects: layout.objects.filter((one) => one.id !== "stand_2" && one.id !== "lamp_1"),
    relaxed: [{relation: "stand_2", by: 0, why: ""}, {relation: "lamp_1", by: 0, why: ""}]};
  assert.deepEqual(scene_of(left).constraints!.map((one) => [one.id, one.targets]), [["c1", ["bed_1"]], ["c2", ["stand_1"]]]);
});

test("a window that goes lets what stood on its sill stand on the floor", () => {
  const layout = room();
  layout.objects[3]!.supportedBy = "door1";
  const gone = without_opening(layout, "door1");
  assert.deepEqual([gone.room.openings, gone.objects[3]!.supportedBy], [[], "floor"]);
});

test("files become rooms to rate, mixed the same way each time, and a table", () => {
  const files = ["out/a/scene.png", "out/a/layout.json", "out/b/floorplan.svg", "out/b/scene.png", "out/b/blender.py"].map((path) => ({path, file: path}));
  const rooms = rooms_of(files);
  assert.deepEqual(rooms.map((one) => [one.id, one.pictures.length, one.layout]), [["a", 1, "out/a/layout.json"], ["b", 2, null]]);
  assert.deepEqual(rooms_of([{path: "x.png", file: 1}, {path: "y.jpg", file: 2}]).map((one) => one.id), ["x", "y"]);
  assert.deepEqual(mixed([...rooms].reverse()), mixed(rooms));
  assert.equal(ratings_csv([{id: "b", score: 7, kind: "place", reason: 'a "desk", askew', prompt: "x"}]), 'id,score,kind,reason,prompt\nb,7,place,"a ""desk"", askew",x\n');
});
