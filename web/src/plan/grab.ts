// Pointers on the plan: a press that moves is a drag, one that does not is a click.
import type {Layout, LayoutObject, LayoutOpening, LayoutWall} from "../gen/types";
import {type Point, in_room, on_grid, turned} from "../pure/geometry";
import {Hand, type Pose} from "../state/hand";
import {move_opening} from "../state/actions";
import {doc, get, set} from "../state/store";
import {wall_length} from "./frame";

const kClick = 4;
const kSmallest = 0.05;

/** Follows one press until it ends. `moved` gets the room's point under the pointer. */
export function follow(event: PointerEvent, svg: SVGSVGElement, moved: (point: Point) => void, ended: (dragged: boolean) => void): void {
  const matrix = svg.getScreenCTM()?.inverse();
  if (!matrix || event.button > 0) return;
  event.preventDefault();
  const target = svg;
  target.setPointerCapture(event.pointerId);
  const start: Point = [event.clientX, event.clientY];
  let dragged = false;
  const at = (now: PointerEvent): Point => {
    const point = new DOMPoint(now.clientX, now.clientY).matrixTransform(matrix);
    return [point.x / 100, -point.y / 100];
  };
  const on_move = (now: PointerEvent) => {
    if (now.pointerId !== event.pointerId) return;
    dragged ||= Math.hypot(now.clientX - start[0], now.clientY - start[1]) > kClick;
    if (dragged) moved(at(now));
  };
  const done = (now: PointerEvent) => {
    if (now.pointerId !== event.pointerId) return;
    target.removeEventListener("pointermove", on_move);
    target.removeEventListener("pointerup", done);
    target.removeEventListener("pointercancel", done);
    ended(dragged && now.type === "pointerup");
  };
  target.addEventListener("pointermove", on_move);
  target.addEventListener("pointerup", done);
  target.addEventListener("pointercancel", done);
}

function with_hand(event: PointerEvent, svg: SVGSVGElement, layout: Layout, id: string, pose: (point: Point) => Pose): void {
  const locked = doc()?.locked.includes(id) ?? false;
  const hand = new Hand(layout, id);
  follow(event, svg, (point) => !locked && hand.move(pose(point)), (dragged) => {
    if (dragged && !locked) void hand.drop();
    else hand.cancel();
  });
}

export function grab(event: PointerEvent, svg: SVGSVGElement, layout: Layout, object: LayoutObject): void {
  set({selected: object.id, relation: null, refused: null});
  let from: Point | null = null;
  const matrix = svg.getScreenCTM()?.inverse();
  if (!matrix) return;
  const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
  from = [point.x / 100, -point.y / 100];
  const start = from;
  with_hand(event, svg, layout, object.id, (now) => ({pos: [object.pos[0] + now[0] - start[0], object.pos[1] + now[1] - start[1]]}));
}

export function grab_turn(event: PointerEvent, svg: SVGSVGElement, layout: Layout, object: LayoutObject): void {
  event.stopPropagation();
  const grain = get().snap ? 15 : 1;
  with_hand(event, svg, layout, object.id, (now) => {
    const angle = (Math.atan2(now[1] - object.pos[1], now[0] - object.pos[0]) * 180) / Math.PI + 90;
    return {rotation: Math.round(angle / grain) * grain};
  });
}

/** The front right corner follows the pointer, the one across stays. */
export function grab_size(event: PointerEvent, svg: SVGSVGElement, layout: Layout, object: LayoutObject): void {
  event.stopPropagation();
  const [w, d, h] = object.size;
  const fixed = in_room(object, [-w / 2, d / 2]);
  with_hand(event, svg, layout, object.id, (now) => {
    const [x, y] = turned([now[0] - fixed[0], now[1] - fixed[1]], -object.rotation);
    const size: [number, number, number] = [on_grid(Math.max(kSmallest, x)), on_grid(Math.max(kSmallest, -y)), h];
    const [dx, dy] = turned([size[0] / 2, -size[1] / 2], object.rotation);
    return {size, pos: [fixed[0] + dx, fixed[1] + dy]};
  });
}

export function clamp_offset(wall: LayoutWall, opening: LayoutOpening, offset: number): number {
  return on_grid(Math.max(0, Math.min(wall_length(wall) - opening.w, offset)));
}

/** A door or window slid along its wall; `show` draws it meanwhile. */
export function grab_opening(
  event: PointerEvent, svg: SVGSVGElement, wall: LayoutWall, opening: LayoutOpening, show: (offset: number | null) => void,
): void {
  let offset = opening.offset;
  const length = wall_length(wall) || 1;
  follow(event, svg, (now) => {
    const along = ((now[0] - wall.start[0]) * (wall.end[0] - wall.start[0]) + (now[1] - wall.start[1]) * (wall.end[1] - wall.start[1])) / length;
    offset = clamp_offset(wall, opening, along - opening.w / 2);
    show(offset);
  }, (dragged) => {
    if (!dragged || offset === opening.offset) return show(null);
    void move_opening(opening.id, offset).finally(() => show(null));
  });
}
