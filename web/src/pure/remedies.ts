// A changed scene in words: what is other than before, as a person would ask for it.
import type {Layout, Scene, SceneObject, SceneRelation} from "../gen/types";
import {texts} from "../texts";
import {relation_text, type Sentences} from "./relations";
import {name_of} from "./scenes";
import {type Units, length_text} from "./units";

const floor_size = ({w, d}: {w?: number; d?: number}, units: Units): string => `${length_text(w ?? 0, units)} × ${length_text(d ?? 0, units)}`;
/** The same text for the same value, in whatever order its members stand. */
const canonical = (value: unknown): string => JSON.stringify(value, (_key, part: unknown) =>
  (part && typeof part === "object" && !Array.isArray(part) ? Object.fromEntries(Object.entries(part).sort(([a], [b]) => (a < b ? -1 : 1))) : part));
const same = (a: unknown, b: unknown): boolean => canonical(a ?? null) === canonical(b ?? null);

/** Pairs of what has the same id before and after; `null` where it is gone. */
function pairs<T extends {id?: string}>(before: readonly T[], after: readonly T[]): [T, T | null][] {
  const now = new Map(after.map((one) => [one.id, one]));
  return before.map((one) => [one, now.get(one.id) ?? null]);
}

export function remedy_text(before: Scene, after: Scene, layout: Layout, sentences: Sentences, units: Units): string {
  const words = texts.remedies;
  const said: string[] = [];
  const quoted = (relation: SceneRelation) => relation_text(relation, layout, sentences, units);
  const gone = new Set<string>();
  for (const [was, is] of pairs<SceneObject>(before.furniture, after.furniture)) {
    const name = texts.places.the(name_of(was).toLowerCase());
    if (!is) {
      gone.add(was.id);
      said.push(words.leave_out(name));
    } else if (is.dims && !same(was.dims, is.dims)) {
      said.push(words.resize(name, floor_size(is.dims, units)));
    }
  }
  for (const [was, is] of pairs<SceneRelation>(before.constraints ?? [], after.constraints ?? [])) {
    if (!is) {
      if (![was.targets, was.relativeTo ?? []].flat().some((id) => gone.has(id))) said.push(words.drop(quoted(was)));
    } else if (was.type !== is.type || !same(was.relativeTo, is.relativeTo)) {
      said.push(words.instead(quoted(is)));
    } else if (was.hard !== is.hard) {
      said.push(words.wish(quoted(was)));
    }
  }
  const {dims} = after.room;
  if (dims && !same(before.room.dims, dims)) said.push(words.room(floor_size(dims, units)));
  return said.join("; ");
}

/** Is all that changes that one of these relations binds no more? */
export function only_gives_up(before: Scene, after: Scene, relations: readonly string[]): boolean {
  return relations.some((id) => {
    const others = (scene: Scene) => ({...scene, constraints: (scene.constraints ?? []).filter((one) => one.id !== id)});
    const left = after.constraints?.find((one) => one.id === id);
    return same(others(before), others(after)) && (!left || left.hard === false);
  });
}
