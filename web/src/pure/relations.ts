// Relations in words, from the sentences of the service's relation table.
import type {Layout, SceneRelation} from "../gen/types";
import {texts} from "../texts";
import {names_of} from "./scenes";
import {type Units, length_text} from "./units";

const words = texts.places;

/** By the relation's name: its sentence, and what is meant where it names no reference. */
export type Sentences = ReadonlyMap<string, {sentence: string; unnamed: string}>;

export const references = (relation: {relativeTo?: string | string[]}): string[] =>
  relation.relativeTo === undefined ? [] : [relation.relativeTo].flat();

/** What people call a wall or an opening: "the back wall", "the window". */
export function places_of(layout: Layout): Map<string, string> {
  const places = new Map<string, string>([["room", words.room], ["floor", words.floor], ["ceiling", words.ceiling]]);
  const walls = layout.room.walls ?? [];
  if (walls.length === 4) {
    for (const wall of walls) {
      const dx = wall.end[0] - wall.start[0];
      const dy = wall.end[1] - wall.start[1];
      const side = Math.abs(dx) > Math.abs(dy) ? (dx > 0 ? "front" : "back") : dy > 0 ? "right" : "left";
      places.set(wall.id, words.wall(words.sides[side]));
    }
  }
  const kinds = new Map<string, number>();
  const openings = layout.room.openings ?? [];
  for (const opening of openings) kinds.set(opening.type, (kinds.get(opening.type) ?? 0) + 1);
  const seen = new Map<string, number>();
  for (const opening of openings) {
    seen.set(opening.type, (seen.get(opening.type) ?? 0) + 1);
    const name = words[opening.type];
    places.set(opening.id, (kinds.get(opening.type) ?? 0) > 1 ? `${name} ${seen.get(opening.type)}` : name);
  }
  return places;
}

function list(names: string[]): string {
  if (names.length < 2) return names[0] ?? "";
  const [first = "", ...rest] = names;
  const stem = /^(.*\D)\d+$/.exec(first)?.[1];
  // "chair 1, 5 and 9" where all are of one name.
  const said = stem && rest.every((name) => name.startsWith(stem) && /^\d+$/.test(name.slice(stem.length))) ? [first, ...rest.map((name) => name.slice(stem.length))] : names;
  return texts.places.and(said.slice(0, -1).join(", "), said.at(-1) ?? "");
}

/** "between {min} and {max}" where only one of the two is said. */
function open_ended(template: string | undefined, {min, max}: SceneRelation): string | undefined {
  if (!template || (min === undefined) === (max === undefined)) return template;
  return template.replace("between {min} and {max}", min === undefined ? words.at_most("{max}") : words.at_least("{min}"));
}

/** The verb after the targets for one of them or for several. */
function agreed(template: string, count: number): string {
  return template.replace(/^\{targets\} (\w+)/, (all, verb: string) => {
    const pair = words.verbs.find((forms) => forms.includes(verb));
    return pair ? `{targets} ${pair[count === 1 ? 0 : 1]}` : all;
  });
}

export function relation_text(relation: SceneRelation, layout: Layout, sentences: Sentences, units: Units): string {
  const template = open_ended(sentences.get(relation.type)?.sentence, relation);
  const names = new Map([...places_of(layout), ...names_of(layout)]);
  const called = (id: string) => {
    const name = names.get(id) ?? id.replaceAll("_", " ");
    return /\d$/.test(name) ? name : texts.places.the(name);
  };
  const targets = list(relation.targets.map(called));
  const about = references(relation);
  const others = about.length > 0 ? list(about.map(called)) : sentences.get(relation.type)?.unnamed ?? texts.places.the(texts.places.room);
  const values = relation as unknown as Record<string, unknown>;
  const text = agreed(template ?? `{targets}: ${relation.type} {references}`, relation.targets.length).replace(/\{(\w+)\}/g, (_all, name: string) => {
    if (name === "targets") return targets;
    if (name === "references") return others;
    const value = values[name];
    if (typeof value === "number") return name === "columns" ? String(value) : length_text(value, units);
    return typeof value === "string" ? value : "…";
  });
  return text[0] ? text[0].toUpperCase() + text.slice(1) : text;
}
