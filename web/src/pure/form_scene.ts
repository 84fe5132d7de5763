// What the form holds, and the scene it asks for.
import type {Scene, SceneObject, SceneOpening, SceneRelation} from "../gen/types";
import type {Point} from "./geometry";
import {polygon_of} from "./outline";
import {fresh_id} from "./scenes";
import {type Units, read_length} from "./units";

export interface FormPiece { key: number; category: string; name: string; count: string; w: string; d: string; h: string }
export interface FormOpening { key: number; type: "door" | "window" | "open"; wall: string; offset: string; w: string }
export interface FormRelation { key: number; type: string; subject: string; reference: string }
/** `outline`: drawn by hand; else it is as wide and deep as said. */
export interface FormValue { kind: string; w: string; d: string; h: string; outline: Point[] | null; openings: FormOpening[]; pieces: FormPiece[]; relations: FormRelation[] }

export const kMost = 100;

/** How many of a piece are asked for: at least one. */
export const count_of = (piece: FormPiece): number => Math.max(1, Math.min(kMost, Math.round(Number(piece.count)) || 1));

/** Ids of the things that the pieces stand for, in their order, with the piece's key. */
export function things_of(pieces: readonly FormPiece[]): {id: string; piece: FormPiece; name: string}[] {
  const things: {id: string; piece: FormPiece; name: string}[] = [];
  for (const piece of pieces) {
    const count = count_of(piece);
    for (let i = 0; i < count; i += 1) {
      const id = fresh_id(things.map((thing) => thing.id), piece.category);
      things.push({id, piece, name: count > 1 ? `${piece.name} ${i + 1}` : piece.name});
    }
  }
  return things;
}

/** The text of fields that hold no length; empty fields are fine. */
export function wrong_lengths(value: FormValue, units: Units): string[] {
  const texts = [value.w, value.d, value.h, ...value.pieces.flatMap((piece) => [piece.w, piece.d, piece.h]), ...value.openings.flatMap((one) => [one.offset, one.w])];
  return texts.filter((text) => text.trim() !== "" && !((read_length(text, units) ?? -1) >= 0));
}

function dims(sides: {w: string; d: string; h: string}, units: Units): SceneObject["dims"] | undefined {
  const found = (["w", "d", "h"] as const).flatMap((side) => {
    const text = sides[side];
    const metres = text.trim() ? read_length(text, units) : null;
    return metres ? [[side, metres]] : [];
  });
  return found.length > 0 ? Object.fromEntries(found) : undefined;
}

/** door1, window1, window2, … in the order of the form. */
export function opening_ids(openings: readonly FormOpening[]): string[] {
  const counts = {door: 0, window: 0, open: 0};
  return openings.map(({type}) => {
    counts[type] += 1;
    return `${type === "open" ? "opening" : type}${counts[type]}`;
  });
}

/** The walls that the form can name: by their sides, or by number where the outline is drawn. */
export const wall_ids = (value: FormValue): string[] => Array.from({length: value.outline?.length ?? 4}, (_none, i) => `wall${i + 1}`);

export function form_scene(value: FormValue, units: Units): Scene {
  const things = things_of(value.pieces);
  const furniture = things.map(({id, piece}): SceneObject => {
    const size = dims(piece, units);
    return {id, category: piece.category, name: piece.name, ...(size ? {dims: size} : {})} as SceneObject;
  });
  const ids = opening_ids(value.openings);
  const openings = value.openings.map((one, i): SceneOpening => {
    const offset = one.wall && one.offset.trim() ? read_length(one.offset, units) : null;
    const w = one.w.trim() ? read_length(one.w, units) : null;
    return {
      id: ids[i], type: one.type, ...(one.wall ? {wallId: one.wall} : {}), ...(offset === null ? {} : {offset}), ...(w ? {w} : {}),
    } as SceneOpening;
  });
  // Whoever names windows alone did not ask for a room without a way in.
  if (openings.length > 0 && openings.every((one) => one.type === "window")) openings.push({id: "door1", type: "door", origin: "assumed"} as SceneOpening);
  const constraints = value.relations.filter((one) => one.type && one.subject).map((one, i): SceneRelation => ({
    id: `c${i + 1}`, type: one.type, targets: one.subject.split(","), ...(one.reference ? {relativeTo: one.reference.split(",")} : {}), hard: true,
  } as SceneRelation));
  const size = dims(value, units);
  return {
    format: "layoutbox/scene@1",
    metadata: {units: "m", ...(value.kind.trim() ? {roomType: value.kind.trim()} : {})},
    room: {...(value.outline ? {polygon: polygon_of(value.outline), ...(size?.h ? {height: size.h} : {})} : size ? {dims: size} : {}), ...(openings.length > 0 ? {openings} : {})},
    furniture,
    constraints,
  } as Scene;
}
