import assert from "node:assert/strict";
import {test} from "node:test";
import {leaves} from "../src/plan/frame";
import {area, bounds, contains, footprint, free_ways, gap_between, in_room, overlaps, turned, upright} from "../src/pure/geometry";
import {move_corner, on_wall, remove_corner, split_wall} from "../src/pure/corners";
import {move_wall, put_opening} from "../src/pure/shell_moves";
import {room} from "./sample";

const near = (a: number, b: number) => assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);

test("a turn is counter-clockwise", () => {
  const [x, y] = turned([1, 0], 90);
  near(x, 0);
  near(y, 1);
  assert.equal(upright(-90), 270);
});

test("the front of a thing faces −y at rotation 0, +x after a quarter", () => {
  const bed = {...room().objects[0]!, rotation: 90};
  const [x, y] = in_room(bed, [0, -1]);
  near(x, 3);
  near(y, 2);
  const box = bounds(footprint(bed));
  near(box.x1 - box.x0, 2);
  near(box.y1 - box.y0, 1.6);
});

test("gaps are measured between outlines, none where they overlap", () => {
  const [bed, stand] = room().objects;
  near(gap_between(footprint(bed!), footprint(stand!)).length, 0);
  const moved = {...stand!, pos: [0.5, 2.8, 0] as [number, number, number]};
  near(gap_between(footprint(bed!), footprint(moved)).length, 0.5);
  near(gap_between(footprint(bed!), footprint({...bed!, pos: [2.1, 2, 0]})).length, 0);
});

test("things that only touch do not overlap", () => {
  const [bed, stand] = room().objects;
  assert.equal(overlaps(footprint(bed!), footprint(stand!)), false);
  assert.equal(overlaps(footprint(bed!), footprint({...stand!, pos: [1.1, 2.8, 0]})), true);
});

test("free ways end at walls and neighbours, not at what stands on the thing", () => {
  const layout = room();
  const lengths = free_ways(layout, layout.objects[1]!).map((gap) => Math.round(gap.length * 100) / 100);
  assert.deepEqual(lengths, [0.8, 0, 2.6, 0]);
});

test("an outline contains its middle and has its area", () => {
  const {polygon} = room().room;
  assert.equal(contains(polygon, [2, 1]), true);
  assert.equal(contains(polygon, [4.1, 1]), false);
  near(area(polygon), 12);
});

test("an in-left door hangs at the wall's end and opens into the room", () => {
  const layout = room();
  const wall = layout.room.walls![0]!;
  const [leaf] = leaves(wall, layout.room.openings![0]!);
  near(leaf!.hinge[0], 1.1);
  near(leaf!.open[1], 0.9);
  near(leaf!.shut[0], 0.2);
  near(on_wall(wall, 1, 0.1)[1], -0.1);
});

test("a door goes to the wall that is nearest, centred where the hand is", () => {
  const moved = put_opening(room(), "door1", [3.9, 1.5]);
  assert.deepEqual([moved.room.openings![0]!.wall, moved.room.openings![0]!.offset], ["wall2", 1.05]);
});

test("a wall takes its neighbours along, openings stay where they are in the room", () => {
  const wider = move_wall(room(), "wall4", 0.5)!;
  assert.deepEqual(wider.room.polygon, [[-0.5, 0], [4, 0], [4, 3], [-0.5, 3]]);
  assert.equal(wider.room.openings![0]!.offset, 0.7);
  assert.equal(area(wider.room.polygon), 13.5);
  assert.equal(move_wall(room(), "wall4", -3.5), null);
});

const outline = (layout: ReturnType<typeof move_corner>) => layout?.room.polygon.map(([x, y]) => `${x},${y}`).join(" ");

test("a corner is put elsewhere, in line with its neighbours where it comes near; no room crosses itself", () => {
  assert.equal(outline(move_corner(room(), 2, [5, 3.5], false)), "0,0 4,0 5,3.5 0,3");
  assert.equal(outline(move_corner(room(), 2, [4.6, 3.1], true)), "0,0 4,0 4.6,3 0,3");
  assert.equal(move_corner(room(), 2, [-1, -1], true), null);
  assert.equal(move_corner(room(), 2, [2, -0.5], true), null);
});

test("a wall is parted and half of it drawn out: a step comes between, is gone where it is drawn back, and turns inwards beyond", () => {
  const parted = split_wall(room(), 1)!;
  assert.equal(outline(parted), "0,0 4,0 4,1.5 4,3 0,3");
  assert.deepEqual(parted.room.walls!.map((wall) => wall.id), ["wall1", "wall2", "wall5", "wall3", "wall4"]);
  const drawn = move_wall(parted, "wall5", 0.5)!;
  assert.equal(outline(drawn), "0,0 4,0 4,1.5 4.5,1.5 4.5,3 0,3");
  assert.equal(outline(move_wall(drawn, "wall5", -0.5)), "0,0 4,0 4,1.5 4,3 0,3");
  assert.equal(outline(move_wall(drawn, "wall5", -1)), "0,0 4,0 4,1.5 3.5,1.5 3.5,3 0,3");
});

test("a door in a wall that is parted keeps its place in the room; what spoke of a wall that is gone speaks of the one in its place", () => {
  const door = {...room().room.openings![0]!, wall: "wall3", offset: 2.5};
  const parted = split_wall({...room(), room: {...room().room, openings: [door]}}, 2)!;
  assert.deepEqual([parted.room.openings![0]!.wall, parted.room.openings![0]!.offset], ["wall5", 0.5]);
  const joined = remove_corner(parted, 3)!;
  assert.deepEqual([joined.room.openings![0]!.wall, joined.room.openings![0]!.offset], ["wall3", 2.5]);
  const cut = remove_corner(room(), 2)!;
  assert.equal(outline(cut), "0,0 4,0 0,3");
  assert.equal(cut.relations![0]!.relativeTo, "wall2");
});
