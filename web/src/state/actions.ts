// What a person can do: each asks the service and makes one step that can be undone.
import {Refused, api} from "../api";
import type {Article, GenerateRequest, Layout, LayoutOpening, Room, Scene, SceneObject} from "../gen/types";
import {fresh_id, open_scene, replaced, scene_of, scene_without_relation, with_opening, without, without_opening} from "../pure/scenes";
import {changed_opening, move_wall} from "../pure/shell_moves";
import {texts} from "../texts";
import {check} from "./hand";
import {redone, undone} from "./history";
import {type Doc, change_layout, doc, get, set, step} from "./store";

let running: AbortController | null = null;

/** Runs one piece of work; a new one ends the one before. */
async function work(said: string, job: (signal: AbortSignal) => Promise<void>): Promise<void> {
  running?.abort();
  const mine = new AbortController();
  running = mine;
  set({busy: said, share: null, error: null, refused: null});
  try {
    await job(mine.signal);
  } catch (error) {
    if (!mine.signal.aborted) show_error(error);
  } finally {
    if (running === mine) {
      running = null;
      set({busy: null});
    }
  }
}

export function show_error(error: unknown): void {
  if (!(error instanceof Refused)) {
    set({error: {message: texts.errors.unexpected}});
    console.error(error);
    return;
  }
  const {message, hint, details} = error.body;
  set({error: {message, ...(hint ? {hint} : {}), ...(details ? {details: details.map((detail) => detail.message)} : {})}});
}

/** What is being done at the moment, in words. */
const told = (stage: string, share?: number): void => {
  if (get().busy !== null) set({busy: texts.stages[stage] ?? get().busy, share: share ?? null});
};

export const stop = (): void => running?.abort();

function take(room: Room, prompt: string, seed: number): void {
  const layout = room.layouts[0] as Layout;
  const next: Doc = {
    prompt, scene: room.scene, words: room.words ?? [], layouts: room.layouts, pick: 0, layout,
    report: room.report, notes: room.notes, seed, locked: [], by_hand: false,
  };
  set({selected: null, relation: null, other: null, form: false, said: texts.said.furnished(layout.objects.length)});
  if (!room.asAsked) set({panel: "about"}); // what is the matter stands there
  step(next);
}

const read_by = (): Pick<GenerateRequest, "planner"> => (get().planner === "offline" ? {} : {planner: get().planner});

export const furnish = (prompt: string): Promise<void> =>
  work(texts.busy.furnish, async (signal) => take(await api.generate({prompt, ...read_by()}, signal, told), prompt, 1));

export const furnish_scene = (scene: Scene, prompt = ""): Promise<void> =>
  work(texts.busy.furnish, async (signal) => {
    const room = await api.generate({scene}, signal, told);
    take({...room, words: room.words ?? doc()?.words ?? []}, prompt, 1);
  });

function asked_again(now: Doc): GenerateRequest {
  if (now.by_hand || now.locked.length > 0 || !now.prompt) return {scene: now.scene && !now.by_hand && now.locked.length === 0 ? now.scene : open_scene(now.layout, now.locked)};
  return {prompt: now.prompt, ...read_by()};
}

export const another = (): Promise<void> =>
  work(texts.busy.another, async (signal) => {
    const now = doc();
    if (!now) return;
    const room = await api.generate({...asked_again(now), seed: now.seed + 1}, signal, told);
    take({...room, words: room.words ?? now.words}, now.prompt, now.seed + 1);
  });

export const variants = (): Promise<void> =>
  work(texts.busy.variants, async (signal) => {
    const now = doc();
    if (!now) return;
    const room = await api.generate({...asked_again(now), seed: now.seed, variants: 4}, signal, told);
    take({...room, words: room.words ?? now.words}, now.prompt, now.seed);
  });

export function pick(index: number): void {
  const now = doc();
  const layout = now?.layouts[index];
  if (!now || !layout) return;
  step({...now, layout, pick: index, report: null, by_hand: false, locked: []});
  void check(layout);
}

export function undo(): void {
  if (get().rooms.past.length > 0) set({rooms: undone(get().rooms), preview: null, ghost: null, refused: null, error: null});
}

export function redo(): void {
  if (get().rooms.future.length > 0) set({rooms: redone(get().rooms), preview: null, ghost: null, refused: null, error: null});
}

/** The text's change is proposed; `take_ghost` makes it the room. */
export const propose = (text: string): Promise<void> =>
  work(texts.busy.edit, async (signal) => {
    const now = doc();
    if (now) set({ghost: await api.edit({layout: now.layout, text}, signal, told)});
  });

export function take_ghost(): void {
  const {ghost} = get();
  if (ghost) change_layout(ghost.layout, {report: ghost.report});
}

export const drop_ghost = (): void => set({ghost: null});

/** The scene of the room as it stands, changed, and solved so that all else stays where it is. */
export function solve_change(said: string, change: (scene: Scene, layout: Layout) => {scene: Scene; from: Layout; select?: string}): Promise<void> {
  return work(said, async (signal) => {
    const now = doc();
    if (!now) return;
    const {scene, from, select} = change(scene_of(now.layout), now.layout);
    const {layouts} = await api.solve({scene, from, locked: now.locked.filter((id) => from.objects.some((object) => object.id === id))}, signal, told);
    const layout = layouts[0] as Layout;
    change_layout(layout);
    if (select) set({selected: select});
    void check(layout);
  });
}

export function add(piece: {category: string; name?: string; dims?: SceneObject["dims"]}): Promise<void> {
  return solve_change(texts.busy.add, (scene, layout) => {
    const id = fresh_id(layout.objects.map((object) => object.id), piece.category);
    return {scene: {...scene, furniture: [...scene.furniture, {id, ...piece, origin: "asked"} as SceneObject]}, from: layout, select: id};
  });
}

export const add_article = (article: Article): Promise<void> => add({category: article.id, name: article.name});

export function remove(id: string): void {
  const now = doc();
  if (!now || now.locked.includes(id)) return;
  const layout = without(now.layout, id);
  set({selected: null, relation: null});
  change_layout(layout, {locked: now.locked.filter((locked) => layout.objects.some((object) => object.id === locked))});
  void check(layout);
}

export function toggle_lock(id: string): void {
  const now = doc();
  if (!now) return;
  const locked = now.locked.includes(id) ? now.locked.filter((one) => one !== id) : [...now.locked, id];
  step({...now, locked});
}

/** The room with another shell; what stands in it keeps its place as far as can be. */
export const reshape = (changed: Layout | null): Promise<void> =>
  (changed ? solve_change(texts.busy.move, () => ({scene: scene_of(changed), from: changed})) : Promise.resolve());

/** A wall moved outwards by so many metres. */
export function shift_wall(id: string, out: number): Promise<void> {
  const now = doc();
  return reshape(now && move_wall(now.layout, id, out));
}

export function add_opening(type: LayoutOpening["type"]): Promise<void> {
  return solve_change(texts.busy.add, (scene, layout) => {
    const taken = new Set((layout.room.openings ?? []).map((opening) => opening.id));
    const stem = type === "open" ? "opening" : type;
    let number = 1;
    while (taken.has(`${stem}${number}`)) number += 1;
    return {scene: with_opening(scene, type, `${stem}${number}`), from: layout, select: `${stem}${number}`};
  });
}

export function change_opening(id: string, change: Partial<LayoutOpening>): Promise<void> {
  return solve_change(texts.busy.move, (_scene, layout) => {
    const changed = changed_opening(layout, id, change);
    return {scene: scene_of(changed), from: changed, select: id};
  });
}

export function remove_opening(id: string): Promise<void> {
  set({selected: null, relation: null});
  return solve_change(texts.busy.move, (_scene, layout) => {
    const changed = without_opening(layout, id);
    return {scene: scene_of(changed), from: changed};
  });
}

/** One way out of a conflict: without that relation. */
export function give_up(relation: string): Promise<void> {
  const now = doc();
  const scene = now?.scene && !now.by_hand ? now.scene : now && open_scene(now.layout, now.locked);
  return scene ? furnish_scene(scene_without_relation(scene, relation), now?.prompt) : Promise.resolve();
}

export const rename = (id: string, name: string): void => {
  const now = doc();
  if (now && name.trim()) change_layout(replaced(now.layout, id, {name: name.trim()}));
};
