// From a layout back to a scene, and changes of a layout that need no solver. Nothing here alters what it is given.
import type {Layout, LayoutObject, LayoutOpening, Scene, SceneObject, SceneRelation} from "../gen/types";
import {texts} from "../texts";

function scene_object(object: LayoutObject): SceneObject {
  const {size, pos, rotation, supportedBy: _held, ...same} = object;
  return {
    ...same,
    dims: {w: size[0], d: size[1], h: size[2]},
    xform: {pos, rot: [0, 0, rotation]},
  } as SceneObject;
}

const references = (relation: SceneRelation): string[] =>
  relation.relativeTo === undefined ? [] : [relation.relativeTo].flat();

/** Relations without some things; those that say nothing without them are gone. */
function relations_without(layout: Layout, gone: ReadonlySet<string>): (SceneRelation & {held?: boolean})[] {
  return (layout.relations ?? []).flatMap((relation) => {
    const targets = relation.targets.filter((target) => !gone.has(target));
    const about = references(relation);
    const left = about.filter((reference) => !gone.has(reference));
    if (targets.length === 0 || (about.length > 0 && left.length === 0)) return [];
    return [about.length === left.length ? {...relation, targets} : {...relation, targets, relativeTo: left}];
  });
}

/** Ids that relations name still and that the layout lists as left out. */
function left_out_of(layout: Layout): Set<string> {
  const here = new Set(layout.objects.map((object) => object.id));
  return new Set([...(layout.relaxed ?? []), ...(layout.gaveWay ?? [])].map((one) => one.relation).filter((id) => !here.has(id)));
}

/** What the layout would be asked for as a scene; every thing keeps its place as a hint. */
export function scene_of(layout: Layout): Scene {
  const {room} = layout;
  return {
    format: "layoutbox/scene@1",
    metadata: {units: "m", ...(layout.roomType ? {roomType: layout.roomType} : {}), ...(layout.prompt ? {prompt: layout.prompt} : {})},
    room: {
      polygon: room.polygon,
      height: room.height,
      walls: (room.walls ?? []).map((wall) => ({...wall, start: [...wall.start, 0], end: [...wall.end, 0]})),
      openings: (room.openings ?? []).map(({wall, ...same}) => ({...same, wallId: wall})),
      ...(room.floorMat ? {floorMat: room.floorMat} : {}),
      ...(room.wallMat ? {wallMat: room.wallMat} : {}),
    },
    furniture: layout.objects.map(scene_object),
    constraints: relations_without(layout, left_out_of(layout)).map(({held: _held, ...same}: SceneRelation & {held?: boolean}) => same),
    ...(layout.materials ? {materials: layout.materials} : {}),
  } as Scene;
}

/** The same wishes without today's places; what is locked stays where it is. */
export function open_scene(layout: Layout, locked: readonly string[]): Scene {
  const scene = scene_of(layout);
  return {
    ...scene,
    furniture: scene.furniture.map((object) => {
      if (locked.includes(object.id)) return {...object, fixed: true};
      const {xform: _place, ...free} = object;
      return free;
    }),
  };
}

/** Ids of a thing and of all that stands or hangs on it. */
export function with_load(layout: Layout, id: string): Set<string> {
  const found = new Set([id]);
  for (let before = 0; before !== found.size; ) {
    before = found.size;
    for (const object of layout.objects) if (found.has(object.supportedBy)) found.add(object.id);
  }
  return found;
}

/** The layout without a thing, what stood on it, and the relations that speak of them. */
export function without(layout: Layout, id: string): Layout {
  const gone = with_load(layout, id);
  return {...layout, objects: layout.objects.filter((object) => !gone.has(object.id)), relations: relations_without(layout, gone)};
}

/** The layout without a door or window; what stood on its sill stands on the floor until it is solved. */
export function without_opening(layout: Layout, id: string): Layout {
  const openings = (layout.room.openings ?? []).filter((opening) => opening.id !== id);
  const objects = layout.objects.map((object) => (object.supportedBy === id ? {...object, supportedBy: "floor"} : object));
  return {...layout, room: {...layout.room, openings}, objects, relations: relations_without(layout, new Set([id]))};
}

/** A scene with one opening more, where the solver likes. */
export function with_opening(scene: Scene, type: LayoutOpening["type"], id: string): Scene {
  const openings = [...(scene.room.openings ?? []), {id, type, origin: "asked"}] as Scene["room"]["openings"];
  return {...scene, room: {...scene.room, openings}} as Scene;
}

export function scene_without_relation(scene: Scene, id: string): Scene {
  return {...scene, constraints: (scene.constraints ?? []).filter((relation) => relation.id !== id)};
}

/** "desk" → "desk_3" where desk_1 and desk_2 are taken. */
export function fresh_id(taken: Iterable<string>, category: string): string {
  const used = new Set(taken);
  const stem = category.replace(/[^A-Za-z0-9_]+/g, "_").replace(/^_+|_+$/g, "") || "thing";
  let number = 1;
  while (used.has(`${stem}_${number}`)) number += 1;
  return `${stem}_${number}`;
}

/** Only places and turns differ, so that what is drawn in 3D can be moved instead of made anew. */
export function shape_key(layout: Layout): string {
  return JSON.stringify([layout.room, layout.materials, layout.objects.map(({pos: _p, rotation: _r, supportedBy: _s, ...rest}) => rest)]);
}

export function replaced(layout: Layout, id: string, change: Partial<LayoutObject>): Layout {
  return {...layout, objects: layout.objects.map((object) => (object.id === id ? {...object, ...change} : object))};
}

export const name_of = (object: {id: string; name?: string; category: string}): string =>
  (object.name || object.category.replaceAll("_", " ")).replace(/[a-z]+/g, (word) => (texts.capitals.includes(word) ? word.toUpperCase() : word));

/** Names that tell things of one kind apart: "nightstand 1", "nightstand 2". */
export function names_of(layout: Layout): Map<string, string> {
  const count = new Map<string, number>();
  for (const object of layout.objects) count.set(name_of(object), (count.get(name_of(object)) ?? 0) + 1);
  const seen = new Map<string, number>();
  const names = new Map<string, string>();
  for (const object of layout.objects) {
    const name = name_of(object);
    seen.set(name, (seen.get(name) ?? 0) + 1);
    names.set(object.id, (count.get(name) ?? 0) > 1 ? `${name} ${seen.get(name)}` : name);
  }
  return names;
}

/** A message of the service with what people call the things in place of their ids. */
export function with_names(text: string, names: ReadonlyMap<string, string>): string {
  return text.replace(/[A-Za-z][A-Za-z0-9_-]*/g, (word) => names.get(word) ?? word);
}
