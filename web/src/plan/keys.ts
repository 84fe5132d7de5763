// Keys on a thing of the plan.
import type {LayoutObject} from "../gen/types";
import {remove, toggle_lock} from "../state/actions";
import {nudge} from "../state/hand";
import {set} from "../state/store";

const kStep = 0.01;
const kLongStep = 0.1;
const kArrows: Record<string, [number, number]> = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

export function on_thing_key(event: KeyboardEvent, object: LayoutObject): void {
  const arrow = kArrows[event.key];
  const plain = !event.ctrlKey && !event.metaKey && !event.altKey;
  if (arrow && plain) {
    const step = event.shiftKey ? kLongStep : kStep;
    nudge(object.id, (now) => ({pos: [now.pos[0] + arrow[0] * step, now.pos[1] + arrow[1] * step]}));
  } else if (event.key.toLowerCase() === "r" && plain) {
    nudge(object.id, (now) => ({rotation: now.rotation + (event.shiftKey ? -90 : 90)}));
  } else if (event.key.toLowerCase() === "l" && plain) {
    toggle_lock(object.id);
  } else if (event.key === "Delete" || event.key === "Backspace") {
    remove(object.id);
  } else if (event.key === "Enter" || event.key === " ") {
    set({selected: object.id, relation: null});
  } else if (event.key === "Escape") {
    set({selected: null, relation: null, refused: null});
  } else {
    return;
  }
  event.preventDefault();
}
