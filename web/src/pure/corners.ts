// The walls of a room as a ring that is redrawn: corners put elsewhere, added, taken away. Doors and windows stay where they are in the room.
import type {Layout, LayoutOpening, LayoutWall} from "../gen/types";
import {type Point, area, bounds, on_grid} from "./geometry";

const kSmallestRoom = 1;
const kShortestWall = 0.1;
const kReach = 0.15;

export const wall_length = (wall: LayoutWall): number => Math.hypot(wall.end[0] - wall.start[0], wall.end[1] - wall.start[1]);

export const outline_of = (walls: readonly LayoutWall[]): Point[] => walls.map((wall): Point => [wall.start[0], wall.start[1]]);

const cross = (a: Point, b: Point, c: Point): number => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

/** Sides that share more than the corner between neighbours. */
function crosses_itself(points: readonly Point[]): boolean {
  const at = (i: number): Point => points[i % points.length] as Point;
  const apart = (a: Point, b: Point, c: Point, d: Point): boolean => cross(a, b, c) * cross(a, b, d) > 0 || cross(c, d, a) * cross(c, d, b) > 0;
  return points.some((a, i) => {
    const b = at(i + 1);
    const back = Math.abs(cross(a, b, at(i + 2))) < 1e-9 && (b[0] - a[0]) * (at(i + 2)[0] - b[0]) + (b[1] - a[1]) * (at(i + 2)[1] - b[1]) < 0;
    return back || points.some((c, j) => j > i + 1 && (j + 1) % points.length !== i && !apart(a, b, c, at(j + 1)));
  });
}

/** Large enough to stand in, and no wall through another. */
export function is_sound(walls: readonly LayoutWall[]): boolean {
  const points = outline_of(walls);
  const {x0, x1, y0, y1} = bounds(points);
  return walls.length >= 3 && Math.min(x1 - x0, y1 - y0) >= kSmallestRoom && area(points) >= kSmallestRoom && walls.every((wall) => wall_length(wall) >= kShortestWall - 0.001) &&
    !crosses_itself(points);
}

/** A name that no wall, opening or thing has. */
export function fresh_wall(layout: Layout): string {
  const {walls, openings} = layout.room;
  const taken = new Set([...walls ?? [], ...openings ?? [], ...layout.objects].map((one) => one.id));
  let number = (walls?.length ?? 0) + 1;
  while (taken.has(`wall${number}`)) number += 1;
  return `wall${number}`;
}

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

/** The place in the walls that is nearest to a point, for something so wide; none where no wall is long enough. */
export function place_in_walls(walls: readonly LayoutWall[], width: number, point: Point): {wall: string; offset: number; distance: number} | null {
  let best: {wall: string; offset: number; distance: number} | null = null;
  for (const wall of walls) {
    if (wall_length(wall) < width - 0.001) continue;
    const offset = on_grid(Math.max(0, Math.min(wall_length(wall) - width, from_wall(wall, point).along - width / 2)));
    const [x, y] = on_wall(wall, offset + width / 2, 0);
    const distance = Math.hypot(x - point[0], y - point[1]);
    if (!best || distance < best.distance) best = {wall: wall.id, offset, distance};
  }
  return best;
}

/** The room with other walls; `heirs` says which wall has taken the place of one that is gone. No such room: null. */
export function with_walls(layout: Layout, walls: LayoutWall[], heirs: ReadonlyMap<string, string> = new Map()): Layout | null {
  if (!is_sound(walls)) return null;
  const before = new Map((layout.room.walls ?? []).map((wall) => [wall.id, wall]));
  const now = new Map(walls.map((wall) => [wall.id, wall]));
  const heir = (id: string): string => heirs.get(id) ?? id;
  const openings: LayoutOpening[] = [];
  for (const opening of layout.room.openings ?? []) {
    const was = before.get(opening.wall);
    const own = now.get(heir(opening.wall));
    if (!was) return null;
    const middle = on_wall(was, opening.offset + opening.w / 2, 0);
    // A wall that has moved takes its openings along; one that was parted or shortened may leave them to a neighbour.
    const along = own ? from_wall(own, middle).along : 0;
    const fits = own && along >= opening.w / 2 - 0.001 && along <= wall_length(own) - opening.w / 2 + 0.001;
    const place = fits ? {wall: own.id, offset: on_grid(along - opening.w / 2)} : place_in_walls(walls, opening.w, middle);
    if (!place) return null;
    openings.push({...opening, wall: place.wall, offset: place.offset});
  }
  const relations = layout.relations?.map((relation) => {
    if (relation.relativeTo === undefined || heirs.size === 0) return relation;
    return {...relation, relativeTo: Array.isArray(relation.relativeTo) ? relation.relativeTo.map(heir) : heir(relation.relativeTo)};
  });
  return {
    ...layout,
    room: {...layout.room, polygon: outline_of(walls), walls, openings},
    objects: layout.objects.map((object) => ({...object, supportedBy: heir(object.supportedBy)})),
    ...(relations ? {relations} : {}),
  };
}

const previous = (index: number, count: number): number => (index + count - 1) % count;

/** In line with the corners beside it where it comes near that, so that walls are upright. */
function aligned(points: readonly Point[], index: number, [x, y]: Point): Point {
  const beside = [points[previous(index, points.length)], points[(index + 1) % points.length]] as Point[];
  const near = (axis: 0 | 1, value: number): number => beside.map((point) => point[axis]).find((other) => Math.abs(other - value) < kReach) ?? value;
  return [near(0, x), near(1, y)];
}

/** The corner where the wall of that index begins. */
export function move_corner(layout: Layout, index: number, to: Point, snap: boolean): Layout | null {
  const walls = layout.room.walls ?? [];
  const [x, y] = snap ? aligned(outline_of(walls), index, to) : to;
  const corner: Point = [on_grid(x), on_grid(y)];
  const before = previous(index, walls.length);
  return with_walls(layout, walls.map((wall, i) => (i === index ? {...wall, start: corner} : i === before ? {...wall, end: corner} : wall)));
}

/** A wall parted in two, at a point or in its middle; the second half has a name of its own. */
export function split_wall(layout: Layout, index: number, at?: Point): Layout | null {
  const walls = layout.room.walls ?? [];
  const wall = walls[index];
  if (!wall) return null;
  const [x, y] = at ?? [(wall.start[0] + wall.end[0]) / 2, (wall.start[1] + wall.end[1]) / 2];
  const corner: Point = [on_grid(x), on_grid(y)];
  return with_walls(layout, walls.flatMap((one, i) => (i === index ? [{...one, end: corner}, {...one, id: fresh_wall(layout), start: corner}] : [one])));
}

/** Without the corner where that wall begins: the wall before goes on to its end. */
export function remove_corner(layout: Layout, index: number): Layout | null {
  const walls = layout.room.walls ?? [];
  const wall = walls[index];
  const before = walls[previous(index, walls.length)];
  if (!wall || !before || walls.length < 4) return null;
  const joined = walls.flatMap((one) => (one === wall ? [] : one === before ? [{...one, end: wall.end}] : [one]));
  return with_walls(layout, joined, new Map([[wall.id, before.id]]));
}
