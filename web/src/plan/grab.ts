// What is taken hold of, on the plan or in 3D: things, their knobs, openings, walls and corners.
import type {Layout, LayoutObject, LayoutOpening, LayoutWall} from "../gen/types";
import {type Where, follow} from "../pointer";
import {type Point, in_room, on_grid, turned} from "../pure/geometry";
import {from_wall} from "../pure/corners";
import {move_wall} from "../pure/shell_moves";
import {Hand, type Pose} from "../state/hand";
import {reshape} from "../state/actions";
import {doc, get, set} from "../state/store";

const kSmallest = 0.05;

/** Where things are taken hold of: what follows the pointer, and the room's point under it. */
export interface Ground { element: Element; where: Where }

/** The plan as it lies on the screen when it is taken hold of. */
export function paper(svg: SVGSVGElement): Ground {
  const matrix = svg.getScreenCTM()?.inverse();
  return {
    element: svg,
    where: (event) => {
      if (!matrix) return null;
      const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
      return [point.x / 100, -point.y / 100];
    },
  };
}

function with_hand(event: PointerEvent, {element, where}: Ground, layout: Layout, id: string, pose: (point: Point) => Pose): void {
  const locked = doc()?.locked.includes(id) ?? false;
  const hand = new Hand(layout, id);
  follow(event, element, where, (point) => !locked && hand.move(pose(point)), (how) => {
    if (how === "drop" && !locked) void hand.drop();
    else hand.cancel();
  });
}

export function grab(event: PointerEvent, ground: Ground, layout: Layout, object: LayoutObject): void {
  set({selected: object.id, relation: null, refused: null});
  const start = ground.where(event);
  if (!start) return;
  with_hand(event, ground, layout, object.id, (now) => ({pos: [object.pos[0] + now[0] - start[0], object.pos[1] + now[1] - start[1]]}));
}

export function grab_turn(event: PointerEvent, ground: Ground, layout: Layout, object: LayoutObject): void {
  event.stopPropagation();
  const grain = get().snap ? 15 : 1;
  with_hand(event, ground, layout, object.id, (now) => {
    const angle = (Math.atan2(now[1] - object.pos[1], now[0] - object.pos[0]) * 180) / Math.PI + 90;
    return {rotation: Math.round(angle / grain) * grain};
  });
}

/** The front right corner follows the pointer, the one across stays. */
export function grab_size(event: PointerEvent, ground: Ground, layout: Layout, object: LayoutObject): void {
  event.stopPropagation();
  const [w, d, h] = object.size;
  const fixed = in_room(object, [-w / 2, d / 2]);
  with_hand(event, ground, layout, object.id, (now) => {
    const [x, y] = turned([now[0] - fixed[0], now[1] - fixed[1]], -object.rotation);
    const size: [number, number, number] = [on_grid(Math.max(kSmallest, x)), on_grid(Math.max(kSmallest, -y)), h];
    const [dx, dy] = turned([size[0] / 2, -size[1] / 2], object.rotation);
    return {size, pos: [fixed[0] + dx, fixed[1] + dy]};
  });
}

/** `top` is how high the pointer points, above the thing's foot. */
export function grab_height(event: PointerEvent, element: Element, top: (event: {clientX: number; clientY: number}) => number | null, layout: Layout, object: LayoutObject): void {
  event.stopPropagation();
  const high: Where = (now) => {
    const height = top(now);
    return height === null ? null : [height, 0];
  };
  with_hand(event, {element, where: high}, layout, object.id, ([height]) => ({size: [object.size[0], object.size[1], on_grid(Math.max(kSmallest, height))]}));
}

/** A door or window slid along the walls. */
export function grab_opening(event: PointerEvent, svg: SVGSVGElement, layout: Layout, opening: LayoutOpening): void {
  set({selected: opening.id, relation: null, refused: null});
  with_hand(event, paper(svg), layout, opening.id, (now) => ({pos: now}));
}

/** The room's shell drawn otherwise: `changed` is the room with the pointer there, `show` draws it until it is let go and furnished so. */
export function grab_shell(event: PointerEvent, svg: SVGSVGElement, changed: (now: Point, start: Point) => Layout | null, show: (layout: Layout | null) => void, clicked?: () => void): void {
  const {element, where} = paper(svg);
  const start = where(event);
  let last: Layout | null = null;
  if (!start) return;
  follow(event, element, where, (now) => {
    last = changed(now, start) ?? last;
    show(last);
  }, (how) => {
    if (how === "click") clicked?.();
    if (how !== "drop" || !last) return show(null);
    void reshape(last).finally(() => show(null));
  });
}

/** A wall drawn outwards or inwards. */
export function grab_wall(event: PointerEvent, svg: SVGSVGElement, layout: Layout, wall: LayoutWall, show: (layout: Layout | null) => void): void {
  grab_shell(event, svg, (now, start) => move_wall(layout, wall.id, on_grid(from_wall(wall, now).out - from_wall(wall, start).out)), show);
}
