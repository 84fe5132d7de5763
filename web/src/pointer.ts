// A press that moves is a drag, one that does not is a click; on the plan as in 3D.
import type {Point} from "./pure/geometry";

const kClick = 4;

/** The room's point under a pointer, in metres; none where the pointer points past the floor. */
export type Where = (event: {clientX: number; clientY: number}) => Point | null;
export type Ending = "click" | "drop" | "cancel";

/** Follows one press until it ends; `element` has the pointer until then. */
export function follow(event: PointerEvent, element: Element, where: Where, moved: (point: Point) => void, ended: (how: Ending) => void): void {
  if (event.button > 0) return;
  event.preventDefault();
  element.setPointerCapture(event.pointerId);
  const over = new AbortController();
  let dragged = false;
  const mine = (done: (now: PointerEvent) => void) => (now: Event) => {
    if ((now as PointerEvent).pointerId === event.pointerId) done(now as PointerEvent);
  };
  const on_move = mine((now) => {
    dragged ||= Math.hypot(now.clientX - event.clientX, now.clientY - event.clientY) > kClick;
    const point = dragged ? where(now) : null;
    if (point) moved(point);
  });
  const done = mine((now) => {
    over.abort();
    ended(now.type !== "pointerup" ? "cancel" : dragged ? "drop" : "click");
  });
  element.addEventListener("pointermove", on_move, {signal: over.signal});
  for (const end of ["pointerup", "pointercancel"]) element.addEventListener(end, done, {signal: over.signal});
}
