// Keys that work everywhere on the page.
import {redo, undo} from "./actions";
import {get, set} from "./store";

const typing = (target: EventTarget | null): boolean =>
  target instanceof HTMLInputElement || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement;

export function install_keys(): void {
  addEventListener("keydown", (event) => {
    if (event.key === "Escape" && get().outlining && !typing(event.target)) set({outlining: false});
    if (!(event.ctrlKey || event.metaKey) || typing(event.target)) return;
    const key = event.key.toLowerCase();
    if (key === "z" && !event.shiftKey) undo();
    else if (key === "y" || (key === "z" && event.shiftKey)) redo();
    else return;
    event.preventDefault();
  });
}
