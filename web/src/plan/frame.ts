// From metres in the room to centimetres on the drawing, y downwards.
import type {Layout, LayoutOpening, LayoutWall} from "../gen/types";
import {type Box, type Point, room_bounds} from "../pure/geometry";
import {on_wall} from "../pure/corners";

/** `page`: the drawing's own edges, in its units. */
export interface Frame { box: Box; page: Box; at: (point: Point) => Point; path: (points: readonly Point[]) => string; view: string; px: number }

const kMargin = 28;

/** `px`: how many units of the drawing are one pixel of the screen, so that writing has the same size in every room. */
export function frame_of(layout: Layout, px = 1): Frame {
  const box = room_bounds(layout.room);
  const at = ([x, y]: Point): Point => [round(x * 100), round(-y * 100)];
  const page = {x0: box.x0 * 100 - kMargin, y0: -box.y1 * 100 - kMargin, x1: box.x1 * 100 + kMargin, y1: -box.y0 * 100 + kMargin};
  return {
    box,
    page,
    px,
    at,
    path: (points) => `M${points.map((point) => at(point).join(" ")).join("L")}Z`,
    view: [page.x0, page.y0, page.x1 - page.x0, page.y1 - page.y0].join(" "),
  };
}

export const round = (value: number): number => Math.round(value * 100) / 100;

export interface Leaf { hinge: Point; open: Point; shut: Point; width: number; sweep: 0 | 1 }

const kWidestLeaf = 1.3;

/** The leaves of a door: hinge, free edge when open and when shut, and the sense of the arc on the page. Seen from within, a wall's end is at the left. */
export function leaves(wall: LayoutWall, door: LayoutOpening): Leaf[] {
  const swing = door.swing ?? "in-left";
  if (door.type !== "door" || swing === "none" || swing === "sliding") return [];
  const inward = swing.startsWith("in");
  const leaf = (at_end: boolean, width: number): Leaf => {
    const hinge = at_end ? door.offset + door.w : door.offset;
    return {
      hinge: on_wall(wall, hinge, 0),
      open: on_wall(wall, hinge, inward ? -width : width),
      shut: on_wall(wall, at_end ? hinge - width : hinge + width, 0),
      width,
      sweep: at_end === inward ? 0 : 1,
    };
  };
  if (door.w > kWidestLeaf) return [leaf(false, door.w / 2), leaf(true, door.w / 2)];
  return [leaf(swing.endsWith("left"), door.w)];
}
