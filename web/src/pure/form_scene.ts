// What the form holds, and the scene it asks for.
import type {Scene, SceneObject, SceneOpening, SceneRelation} from "../gen/types";
import {fresh_id} from "./scenes";
import {type Units, read_length} from "./units";

export interface FormPiece { key: number; category: string; name: string; count: string; w: string; d: string; h: string }
export interface FormOpening { key: number; type: "door" | "window"; wall: string; offset: string }
export interface FormRelation { key: number; type: string; subject: string; reference: string }
export interface FormValue { kind: string; w: string; d: string; h: string; openings: FormOpening[]; pieces: FormPiece[]; relations: FormRelation[] }

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
  const texts = [value.w, value.d, value.h, ...value.pieces.flatMap((piece) => [piece.w, piece.d, piece.h]), ...value.openings.map((one) => one.offset)];
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

export function form_scene(value: FormValue, units: Units): Scene {
  const things = things_of(value.pieces);
  const furniture = things.map(({id, piece}): SceneObject => {
    const size = dims(piece, units);
    return {id, category: piece.category, name: piece.name, ...(size ? {dims: size} : {})} as SceneObject;
  });
  const counts = {door: 0, window: 0};
  const openings = value.openings.map((one): SceneOpening => {
    const offset = one.wall && one.offset.trim() ? read_length(one.offset, units) : null;
    counts[one.type] += 1;
    return {id: `${one.type}${counts[one.type]}`, type: one.type, ...(one.wall ? {wallId: one.wall} : {}), ...(offset === null ? {} : {offset})} as SceneOpening;
  });
  const constraints = value.relations.filter((one) => one.type && one.subject).map((one, i): SceneRelation => ({
    id: `c${i + 1}`, type: one.type, targets: one.subject.split(","), ...(one.reference ? {relativeTo: one.reference.split(",")} : {}), hard: true,
  } as SceneRelation));
  const size = dims(value, units);
  return {
    format: "layoutbox/scene@1",
    metadata: {units: "m", ...(value.kind.trim() ? {roomType: value.kind.trim()} : {})},
    room: {...(size ? {dims: size} : {}), ...(openings.length > 0 ? {openings} : {})},
    furniture,
    constraints,
  } as Scene;
}
