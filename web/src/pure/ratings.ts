// Rating rooms: which pictures belong together, in which order they are shown, and the table that comes of it.
export interface RoomFiles<F> { id: string; pictures: F[]; layout: F | null }
export interface Rating { id: string; score: number; kind: string; reason: string; prompt: string }

const kPicture = /\.(png|jpe?g|webp|svg)$/i;

/** Files of DIR/ID/… are a room ID each; a picture beside no other folder is a room by its own name. */
export function rooms_of<F>(files: readonly {path: string; file: F}[]): RoomFiles<F>[] {
  const depth = Math.max(...files.map(({path}) => path.split("/").length), 0);
  const rooms = new Map<string, RoomFiles<F>>();
  for (const {path, file} of [...files].sort((a, b) => (a.path < b.path ? -1 : 1))) {
    const parts = path.split("/");
    const name = parts.at(-1) as string;
    const picture = kPicture.test(name);
    if (!picture && name !== "layout.json") continue;
    const id = depth > 2 && parts.length > 1 ? parts.at(-2) as string : name.replace(/\.[^.]+$/, "");
    const room = rooms.get(id) ?? {id, pictures: [], layout: null};
    if (picture) room.pictures.push(file);
    else room.layout = file;
    rooms.set(id, room);
  }
  return [...rooms.values()].filter((room) => room.pictures.length > 0);
}

/** An order that tells nothing, the same each time: by a hash of the ids (FNV-1a). */
export function mixed<T extends {id: string}>(rooms: readonly T[]): T[] {
  const hash = (text: string): number => {
    let value = 0x811c9dc5;
    for (const sign of text) value = Math.imul(value ^ (sign.codePointAt(0) as number), 0x01000193) >>> 0;
    return value;
  };
  return [...rooms].sort((a, b) => hash(a.id) - hash(b.id) || (a.id < b.id ? -1 : 1));
}

const cell = (text: string): string => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

export function ratings_csv(ratings: readonly Rating[]): string {
  const rows = [...ratings].sort((a, b) => (a.id < b.id ? -1 : 1)).map((one) => [one.id, String(one.score), one.kind, one.reason, one.prompt]);
  return [["id", "score", "kind", "reason", "prompt"], ...rows].map((row) => `${row.map(cell).join(",")}\n`).join("");
}
