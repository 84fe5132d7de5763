// Geometry of the floor plan: metres and degrees in the frame of layout.json. Pure functions only.
import type {Layout, LayoutObject, LayoutRoom} from "../gen/types";

export type Point = [number, number];
export interface Box { x0: number; y0: number; x1: number; y1: number }
export interface Gap { from: Point; to: Point; length: number }

const kTouching = 1e-6;
/** Rugs and mats up to this height are in nobody's way. */
export const kFlat = 0.03;

export function turned([x, y]: Point, degrees: number): Point {
  const angle = (degrees * Math.PI) / 180;
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  return [c * x - s * y, s * x + c * y];
}

/** A point of the object's own frame (front towards −y), in the room's. */
export function in_room(object: LayoutObject, [x, y]: Point): Point {
  const [dx, dy] = turned([x, y], object.rotation);
  return [object.pos[0] + dx, object.pos[1] + dy];
}

/** The corners of the footprint, counter-clockwise from front left. */
export function footprint(object: LayoutObject): Point[] {
  const w = object.size[0] / 2;
  const d = object.size[1] / 2;
  const corners: Point[] = [[-w, -d], [w, -d], [w, d], [-w, d]];
  return corners.map((corner) => in_room(object, corner));
}

export function bounds(points: readonly Point[]): Box {
  const xs = points.map((point) => point[0]);
  const ys = points.map((point) => point[1]);
  return {x0: Math.min(...xs), y0: Math.min(...ys), x1: Math.max(...xs), y1: Math.max(...ys)};
}

export const room_bounds = (room: LayoutRoom): Box => bounds(room.polygon);

/** The same angle from 0 up to 360. */
export const upright = (degrees: number): number => ((degrees % 360) + 360) % 360;

/** To whole centimetres. */
export const on_grid = (metres: number): number => Math.round(metres * 100) / 100;

function nearest_on_segment(p: Point, a: Point, b: Point): Point {
  const dx = b[0] - a[0];
  const dy = b[1] - a[1];
  const length2 = dx * dx + dy * dy;
  if (length2 === 0) return a;
  const t = Math.max(0, Math.min(1, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2));
  return [a[0] + t * dx, a[1] + t * dy];
}

const apart = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

export function contains(polygon: readonly Point[], [x, y]: Point): boolean {
  let inside = false;
  polygon.forEach(([ax, ay], i) => {
    const [bx, by] = polygon[(i + 1) % polygon.length] as Point;
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
  });
  return inside;
}

/** The shortest way in plan between two outlines; of no length where they overlap. */
export function gap_between(a: readonly Point[], b: readonly Point[]): Gap {
  let best: Gap = {from: a[0] as Point, to: b[0] as Point, length: Infinity};
  const look = (points: readonly Point[], outline: readonly Point[], swap: boolean) => {
    for (const point of points) {
      outline.forEach((start, i) => {
        const near = nearest_on_segment(point, start, outline[(i + 1) % outline.length] as Point);
        const length = apart(point, near);
        if (length < best.length) best = swap ? {from: near, to: point, length} : {from: point, to: near, length};
      });
    }
  };
  look(a, b, false);
  look(b, a, true);
  const overlap = b.length > 2 && a.length > 2 && (a.some((point) => contains(b, point)) || b.some((point) => contains(a, point)));
  return overlap ? {...best, length: 0} : best;
}

/** Do two outlines share more than their rims? Convex outlines. */
export function overlaps(a: readonly Point[], b: readonly Point[], slack = 0.005): boolean {
  return ![a, b].some((outline) =>
    outline.some((start, i) => {
      const end = outline[(i + 1) % outline.length] as Point;
      const normal: Point = [end[1] - start[1], start[0] - end[0]];
      const size = Math.hypot(...normal) || 1;
      const along = (point: Point) => (point[0] * normal[0] + point[1] * normal[1]) / size;
      return Math.min(...b.map(along)) > Math.max(...a.map(along)) - slack ||
        Math.min(...a.map(along)) > Math.max(...b.map(along)) - slack;
    }),
  );
}

/** How far a ray along an axis (0 is x, 1 is y) runs from `start` until it meets an outline; no hit: infinite. */
function ray_length(start: Point, axis: 0 | 1, sign: 1 | -1, outline: readonly Point[]): number {
  const other = axis === 0 ? 1 : 0;
  let best = Infinity;
  outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length] as Point;
    const low = Math.min(a[other], b[other]);
    const high = Math.max(a[other], b[other]);
    if (high - low < kTouching || start[other] < low || start[other] > high) return;
    const t = (start[other] - a[other]) / (b[other] - a[other]);
    const length = (a[axis] + t * (b[axis] - a[axis]) - start[axis]) * sign;
    if (length > -kTouching && length < best) best = Math.max(0, length);
  });
  return best;
}

const share_height = (a: LayoutObject, b: LayoutObject): boolean =>
  a.pos[2] < b.pos[2] + b.size[2] - 0.01 && b.pos[2] < a.pos[2] + a.size[2] - 0.01;

/** Free ways from the middle of each side of a thing's extent to the wall or the neighbour there. */
export function free_ways(layout: Layout, object: LayoutObject): Gap[] {
  const box = bounds(footprint(object));
  const middle: Point = [(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2];
  const others = layout.objects
    .filter((other) => other.id !== object.id && other.supportedBy !== object.id && object.supportedBy !== other.id)
    .filter((other) => other.size[2] > kFlat && share_height(object, other))
    .map(footprint);
  const outlines: Point[][] = [layout.room.polygon, ...others];
  const sides: [Point, 0 | 1, 1 | -1][] = [
    [[box.x0, middle[1]], 0, -1],
    [[box.x1, middle[1]], 0, 1],
    [[middle[0], box.y0], 1, -1],
    [[middle[0], box.y1], 1, 1],
  ];
  return sides.flatMap(([from, axis, sign]) => {
    const length = Math.min(...outlines.map((outline) => ray_length(from, axis, sign, outline)));
    if (!Number.isFinite(length)) return [];
    const to: Point = [...from];
    to[axis] += sign * length;
    return [{from, to, length}];
  });
}

/** Area of an outline that runs counter-clockwise. */
export function area(polygon: readonly Point[]): number {
  return polygon.reduce((sum, [x, y], i) => {
    const [nx, ny] = polygon[(i + 1) % polygon.length] as Point;
    return sum + (x * ny - nx * y) / 2;
  }, 0);
}
