// An outline drawn by hand: corners in metres, counter-clockwise, on a grid of 10 cm.
import {type Point, area, bounds} from "./geometry";

const kGrid = 0.1;
const kFewest = 3;

const snapped = (metres: number): number => Math.round(metres / kGrid) / (1 / kGrid);

export type Shape = "rectangle" | "l" | "t" | "u";

/** A room of a shape within so many metres. */
export function shape_of(shape: Exclude<Shape, "rectangle">, w: number, d: number): Point[] {
  const [x1, x2, y1] = [snapped(w * 0.35), snapped(w * 0.65), snapped(d * 0.5)];
  const corners: Record<typeof shape, Point[]> = {
    l: [[0, 0], [w, 0], [w, y1], [x2, y1], [x2, d], [0, d]],
    t: [[x1, 0], [x2, 0], [x2, y1], [w, y1], [w, d], [0, d], [0, y1], [x1, y1]],
    u: [[0, 0], [w, 0], [w, d], [x2, d], [x2, y1], [x1, y1], [x1, d], [0, d]],
  };
  return corners[shape].map(([x, y]): Point => [snapped(x), snapped(y)]);
}

export const moved_corner = (points: readonly Point[], index: number, to: Point): Point[] =>
  points.map((point, i): Point => (i === index ? [snapped(to[0]), snapped(to[1])] : point));

/** One corner more, in the middle of the side that begins at `index`. */
export function with_corner(points: readonly Point[], index: number): Point[] {
  const [a, b] = [points[index] as Point, points[(index + 1) % points.length] as Point];
  return [...points.slice(0, index + 1), [snapped((a[0] + b[0]) / 2), snapped((a[1] + b[1]) / 2)], ...points.slice(index + 1)];
}

export const without_corner = (points: readonly Point[], index: number): Point[] =>
  points.length <= kFewest ? [...points] : points.filter((_point, i) => i !== index);

/** As a scene has it: from (0, 0), counter-clockwise. */
export function polygon_of(points: readonly Point[]): Point[] {
  const {x0, y0} = bounds(points);
  const moved = points.map(([x, y]): Point => [snapped(x - x0), snapped(y - y0)]);
  return area(moved) < 0 ? moved.reverse() : moved;
}

export const outline_area = (points: readonly Point[]): number => Math.abs(area(points));
