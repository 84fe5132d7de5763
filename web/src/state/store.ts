// The one place for state. What undo brings back is in `Doc`; all else is how it is looked at.
import {useEffect, useState} from "preact/hooks";
import type {Edited, KeptRoom, Layout, Notes, Report, Scene, Word} from "../gen/types";
import type {Sentences} from "../pure/relations";
import type {Units} from "../pure/units";
import {type History, amended, begin, pushed} from "./history";

export interface Doc {
  prompt: string;
  scene: Scene | null;
  words: Word[];
  layouts: Layout[];
  pick: number;
  layout: Layout;
  report: Report | null;
  notes: Notes;
  seed: number;
  locked: string[];
  by_hand: boolean;
}

/** What the hand shows at the moment. */
export interface Preview {
  id: string;
  layout: Layout;
  legal: boolean;
  moved: string[];
  reasons: {text: string; subject?: string}[];
}

export interface State {
  rooms: History<Doc | null>;
  selected: string | null;
  hovered: string | null;
  relation: string | null;
  preview: Preview | null;
  /** Why the last thing that the hand let go went back. */
  refused: {id: string; text: string} | null;
  ghost: Edited | null;
  other: {name: string; layout: Layout} | null;
  busy: string | null;
  /** How much of that is done, 0 to 1, where it is known. */
  share: number | null;
  error: {message: string; hint?: string; details?: string[]} | null;
  said: string;
  kept: KeptRoom[];
  sentences: Sentences;
  panel: string;
  pane: "3d" | "plan" | "about";
  form: boolean;
  rating: boolean;
  walking: boolean;
  /** The plan's corners can be taken hold of. */
  outlining: boolean;
  snap: boolean;
  units: Units;
  /** Who reads prompts, of those that the service has. */
  planner: "offline" | "llm";
  planners: readonly string[];
  theme: "auto" | "light" | "dark";
}

const kSaved = "layoutbox.view";

function saved(): Partial<State> {
  try {
    return JSON.parse(localStorage.getItem(kSaved) ?? "{}") as Partial<State>;
  } catch {
    return {};
  }
}

const kept_view = saved();

let state: State = {
  rooms: begin<Doc | null>(null),
  selected: null, hovered: null, relation: null, preview: null, refused: null, ghost: null, other: null,
  busy: null, share: null, error: null, said: "", kept: [], sentences: new Map(),
  panel: "about", pane: "3d", form: false, rating: false, walking: false, outlining: false,
  snap: kept_view.snap ?? true, units: kept_view.units ?? "m", theme: kept_view.theme ?? "auto",
  planner: "offline", planners: ["offline"],
};

const listeners = new Set<() => void>();

export const get = (): State => state;

export function set(change: Partial<State>): void {
  state = {...state, ...change};
  if ("snap" in change || "units" in change || "theme" in change) {
    try {
      localStorage.setItem(kSaved, JSON.stringify({snap: state.snap, units: state.units, theme: state.theme}));
    } catch { /* a browser that keeps nothing */ }
  }
  for (const listener of listeners) listener();
}

export function on_change(listener: () => void): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

/** A part of the state; the component is drawn anew when that part is another. */
export function use<T>(part: (state: State) => T): T {
  const [, again] = useState(0);
  const now = part(state);
  useEffect(() => {
    let before = part(state);
    if (before !== now) again((count) => count + 1);
    return on_change(() => {
      const next = part(state);
      if (next !== before) {
        before = next;
        again((count) => count + 1);
      }
    });
  }, []);
  return now;
}

export const doc = (): Doc | null => state.rooms.now;

/** What is on the screen: what the hand shows, else what is proposed, else the room. */
export const shown = (now: State): Layout | null => now.preview?.layout ?? now.rooms.now?.layout ?? null;

/** A step that can be undone. */
export function step(next: Doc): void {
  set({rooms: pushed(state.rooms, next), preview: null, ghost: null, refused: null, error: null});
}

export function change_layout(layout: Layout, more: Partial<Doc> = {}): void {
  const now = doc();
  if (now) step({...now, layout, report: null, by_hand: true, ...more});
}

/** The report of a layout that is already on the screen. */
export function put_report(layout: Layout, report: Report): void {
  const now = doc();
  if (now && now.layout === layout) set({rooms: amended(state.rooms, {...now, report})});
}
