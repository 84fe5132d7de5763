// The shell of the room changed by hand: openings put elsewhere, walls moved outwards or inwards.
import type {Layout, LayoutOpening, LayoutRoom, LayoutWall} from "../gen/types";
import {fresh_wall, on_wall, place_in_walls, wall_length, with_walls} from "./corners";
import {type Point, on_grid} from "./geometry";

/** The opening in the wall that is nearest to a point, centred there as far as the wall is long. */
export function put_opening(layout: Layout, id: string, point: Point): Layout {
  const opening = layout.room.openings?.find((one) => one.id === id);
  if (!opening) return layout;
  const best = place_in_walls(layout.room.walls ?? [], opening.w, point) ?? opening;
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

type Line = Pick<LayoutWall, "start" | "end">;

const in_line = (a: Line, b: Line): boolean => {
  const [ax, ay, bx, by] = [a.end[0] - a.start[0], a.end[1] - a.start[1], b.end[0] - b.start[0], b.end[1] - b.start[1]];
  return Math.abs(ax * by - ay * bx) < 1e-6 * Math.hypot(ax, ay) * Math.hypot(bx, by) && ax * bx + ay * by > 0;
};

/**
 * A wall moved outwards (or, below zero, inwards); its neighbours follow, and where one goes on in the same line a step comes between. Openings stay where they are in
 * the room. Too far: null.
 */
export function move_wall(layout: Layout, id: string, out: number): Layout | null {
  const walls = layout.room.walls ?? [];
  const index = walls.findIndex((one) => one.id === id);
  const wall = walls[index];
  if (!wall || out === 0) return wall ? layout : null;
  const shifted = (along: number): Point => {
    const [x, y] = on_wall(wall, along, out);
    return [on_grid(x), on_grid(y)];
  };
  const [start, end] = [shifted(0), shifted(wall_length(wall))];
  const before = (index + walls.length - 1) % walls.length;
  const after = (index + 1) % walls.length;
  const [step_before, step_after] = [in_line(walls[before] as LayoutWall, wall), in_line(wall, walls[after] as LayoutWall)];
  const steps = fresh_steps(layout);
  const ring = walls.flatMap((one, i): LayoutWall[] => {
    if (i === index) {
      return [
        ...(step_before ? [{...bare(one), id: steps[0], start: one.start, end: start}] : []), {...one, start, end},
        ...(step_after ? [{...bare(one), id: steps[1], start: end, end: one.end}] : []),
      ];
    }
    return [{...one, ...(i === before && !step_before ? {end: start} : {}), ...(i === after && !step_after ? {start: end} : {})}];
  });
  // A step that has come to nothing is none.
  const gone = ring.filter((one) => same(one.start, one.end)).map((one): [string, string] => [one.id, wall.id]);
  return with_walls(layout, ring.filter((one) => !same(one.start, one.end)), new Map(gone));
}

/** A wall's looks without its own mesh. */
const bare = ({mesh: _own, ...wall}: LayoutWall & {mesh?: string}): LayoutWall => wall;

function fresh_steps(layout: Layout): [string, string] {
  const first = fresh_wall(layout);
  const second = fresh_wall({...layout, room: {...layout.room, walls: [...(layout.room.walls ?? []), {id: first, start: [0, 0], end: [0, 0]}]}});
  return [first, second];
}
