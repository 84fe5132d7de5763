// What survives a reload of this tab: the room on the screen, or the kept room that the address names (#room=…).
import {api} from "../api";
import type {KeptRoom, Layout, Scene} from "../gen/types";
import {texts} from "../texts";
import {furnish_scene, show_error} from "./actions";
import {check} from "./hand";
import {type Doc, doc, get, on_change, set, step} from "./store";

const kRoom = "layoutbox.room";

export const room_address = (id: string): string => `${location.origin}${location.pathname}#room=${id}`;

export function show_layout(layout: Layout, prompt = layout.prompt ?? ""): void {
  const next: Doc = {prompt, scene: null, words: [], layouts: [layout], pick: 0, layout, report: null, notes: [], seed: 1, locked: [], by_hand: false};
  set({selected: null, relation: null, other: null, form: false});
  step(next);
  void check(layout);
}

export async function open_room(id: string): Promise<void> {
  set({busy: texts.busy.open, error: null});
  try {
    const room = await api.room(id);
    if (room.layout) show_layout(room.layout, room.prompt);
  } catch (error) {
    show_error(error);
  } finally {
    set({busy: null});
  }
}

export async function list_rooms(): Promise<void> {
  try {
    set({kept: await api.rooms()});
  } catch (error) {
    show_error(error);
  }
}

export async function keep_room(name: string): Promise<KeptRoom | null> {
  const now = doc();
  if (!now) return null;
  try {
    const room = await api.keep({name, layout: now.layout, ...(now.prompt ? {prompt: now.prompt} : {})});
    await list_rooms();
    return room;
  } catch (error) {
    show_error(error);
    return null;
  }
}

/** A layout.json is shown as it is, a scene.json is furnished. */
export async function open_file(file: File): Promise<void> {
  let value: {objects?: unknown; room?: unknown; furniture?: unknown};
  try {
    value = JSON.parse(await file.text()) as typeof value;
  } catch {
    set({error: {message: texts.errors.not_a_file}});
    return;
  }
  if (Array.isArray(value.objects) && value.room) {
    try {
      const layout = value as unknown as Layout;
      await api.verify(layout);
      show_layout(layout);
    } catch (error) {
      show_error(error);
    }
  } else if (Array.isArray(value.furniture)) {
    await furnish_scene(value as unknown as Scene);
  } else {
    set({error: {message: texts.errors.not_a_file}});
  }
}

export async function restore_session(): Promise<void> {
  const from_address = () => /#room=([0-9a-f]{16})/.exec(location.hash)?.[1];
  addEventListener("hashchange", () => {
    const id = from_address();
    if (id) void open_room(id);
  });
  const id = from_address();
  if (id) return open_room(id);
  try {
    const kept = JSON.parse(sessionStorage.getItem(kRoom) ?? "null") as Doc | null;
    if (kept?.layout) set({rooms: {...get().rooms, now: kept}});
  } catch { /* nothing to go on with */ }
}

export function keep_session(): void {
  let last: Doc | null = null;
  on_change(() => {
    const now = doc();
    if (now === last) return;
    last = now;
    try {
      if (now) sessionStorage.setItem(kRoom, JSON.stringify(now));
      else sessionStorage.removeItem(kRoom);
    } catch { /* too large for this browser */ }
  });
}
