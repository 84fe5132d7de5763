// The shell of the room changed by hand: openings put elsewhere, walls moved outwards or inwards.
import type {Layout, LayoutOpening, LayoutRoom, LayoutWall} from "../gen/types";
import {type Point, on_grid} from "./geometry";

const kSmallestRoom = 1;

export const wall_length = (wall: LayoutWall): number => Math.hypot(wall.end[0] - wall.start[0], wall.end[1] - wall.start[1]);

/** A wall's own frame: `along` metres from its start, `out` metres out of the room. */
export function on_wall(wall: LayoutWall, along: number, out: number): Point {
  const dx = wall.end[0] - wall.start[0];
  const dy = wall.end[1] - wall.start[1];
  const length = Math.hypot(dx, dy) || 1;
  return [wall.start[0] + (dx * along + dy * out) / length, wall.start[1] + (dy * along - dx * out) / length];
}

/** How far a point lies along a wall from its start, and out of the room. */
export function from_wall(wall: LayoutWall, [x, y]: Point): {along: number; out: number} {
  const dx = wall.end[0] - wall.start[0];
  const dy = wall.end[1] - wall.start[1];
  const length = Math.hypot(dx, dy) || 1;
  const [px, py] = [x - wall.start[0], y - wall.start[1]];
  return {along: (px * dx + py * dy) / length, out: (px * dy - py * dx) / length};
}

/** The opening in the wall that is nearest to a point, centred there as far as the wall is long. */
export function put_opening(layout: Layout, id: string, point: Point): Layout {
  const opening = layout.room.openings?.find((one) => one.id === id);
  if (!opening) return layout;
  let best = {distance: Infinity, wall: opening.wall, offset: opening.offset};
  for (const wall of layout.room.walls ?? []) {
    if (wall_length(wall) < opening.w) continue;
    const offset = Math.max(0, Math.min(wall_length(wall) - opening.w, from_wall(wall, point).along - opening.w / 2));
    const [x, y] = on_wall(wall, offset + opening.w / 2, 0);
    const distance = Math.hypot(x - point[0], y - point[1]);
    if (distance < best.distance) best = {distance, wall: wall.id, offset: on_grid(offset)};
  }
  const openings = layout.room.openings?.map((one): LayoutOpening => (one.id === id ? {...one, wall: best.wall, offset: best.offset} : one));
  return {...layout, room: {...layout.room, openings}};
}

/** An opening with other sizes: its middle stays, as far as its wall is long. */
export function changed_opening(layout: Layout, id: string, change: Partial<LayoutOpening>): Layout {
  const openings = (layout.room.openings ?? []).map((opening): LayoutOpening => {
    const wall = layout.room.walls?.find((one) => one.id === opening.wall);
    if (opening.id !== id || !wall) return opening;
    const w = Math.min(change.w ?? opening.w, wall_length(wall));
    const offset = Math.max(0, Math.min(wall_length(wall) - w, opening.offset + (opening.w - w) / 2));
    return {...opening, ...change, w, offset: on_grid(offset)};
  });
  return {...layout, room: {...layout.room, openings}};
}

const same = (a: Point, b: Point): boolean => Math.hypot(a[0] - b[0], a[1] - b[1]) < 0.001;

/** The middle of an opening on the inner face of its wall. */
export function opening_middle(room: LayoutRoom, opening: LayoutOpening): Point | null {
  const wall = room.walls?.find((one) => one.id === opening.wall);
  return wall ? on_wall(wall, opening.offset + opening.w / 2, 0) : null;
}

/** A wall moved outwards (or, below zero, inwards); its neighbours follow, openings stay where they are in the room. Too far: null. */
export function move_wall(layout: Layout, id: string, out: number): Layout | null {
  const {room} = layout;
  const wall = room.walls?.find((one) => one.id === id);
  if (!wall) return null;
  const length = wall_length(wall) || 1;
  const normal: Point = [(wall.end[1] - wall.start[1]) / length, (wall.start[0] - wall.end[0]) / length];
  const shift = (point: Point): Point =>
    same(point, wall.start) || same(point, wall.end) ? [on_grid(point[0] + normal[0] * out), on_grid(point[1] + normal[1] * out)] : point;
  const walls = room.walls?.map((one) => ({...one, start: shift(one.start), end: shift(one.end)})) ?? [];
  const kept = walls.every((one, i) => {
    const before = room.walls?.[i] as LayoutWall;
    const turned = (one.end[0] - one.start[0]) * (before.end[0] - before.start[0]) + (one.end[1] - one.start[1]) * (before.end[1] - before.start[1]);
    const shortened = wall_length(one) < wall_length(before) - 0.001;
    return turned > 0 && !(shortened && wall_length(one) < kSmallestRoom);
  });
  if (!kept) return null;
  const openings = (room.openings ?? []).map((opening) => {
    const now = walls.find((one) => one.id === opening.wall);
    const middle = opening_middle(room, opening);
    if (!now || !middle || opening.wall === id) return opening;
    const offset = from_wall(now, middle).along - opening.w / 2;
    return {...opening, offset: on_grid(Math.max(0, Math.min(wall_length(now) - opening.w, offset)))};
  });
  return {...layout, room: {...room, polygon: room.polygon.map(shift), walls, openings}};
}
