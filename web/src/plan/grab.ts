// Pointers on the plan: a press that moves is a drag, one that does not is a click.
import type {Layout, LayoutObject, LayoutOpening, LayoutWall} from "../gen/types";
import {type Point, in_room, on_grid, turned} from "../pure/geometry";
import {from_wall, move_wall} from "../pure/shell_moves";
import {Hand, type Pose} from "../state/hand";
import {shift_wall} from "../state/actions";
import {doc, get, set} from "../state/store";

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

/** A door or window slid along the walls. */
export function grab_opening(event: PointerEvent, svg: SVGSVGElement, layout: Layout, opening: LayoutOpening): void {
  set({selected: opening.id, relation: null, refused: null});
  with_hand(event, svg, layout, opening.id, (now) => ({pos: now}));
}

/** A wall drawn outwards or inwards; `show` draws the room so meanwhile. */
export function grab_wall(event: PointerEvent, svg: SVGSVGElement, layout: Layout, wall: LayoutWall, show: (layout: Layout | null) => void): void {
  let start: number | null = null;
  let out = 0;
  follow(event, svg, (now) => {
    const far = from_wall(wall, now).out;
    start ??= far;
    out = on_grid(far - start);
    show(move_wall(layout, wall.id, out));
  }, (dragged) => {
    if (!dragged || out === 0) return show(null);
    void shift_wall(wall.id, out).finally(() => show(null));
  });
}
