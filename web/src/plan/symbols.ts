// How things look from above: taken from the service's own floor plan, so that the page draws them as the program does.
import {api} from "../api";
import type {Layout} from "../gen/types";
import {room_bounds} from "../pure/geometry";
import {shape_key} from "../pure/scenes";

export interface Stroke { d: string; closed: boolean }
export type Symbols = ReadonlyMap<string, Stroke[]>;

type Place = (x: number, y: number) => [number, number];

function numbers(text: string | null): number[] {
  return (text ?? "").trim().split(/[\s,]+/).map(Number).filter(Number.isFinite);
}

function extent(points: number[]): {x0: number; y0: number; x1: number; y1: number} {
  const xs = points.filter((_value, i) => i % 2 === 0);
  const ys = points.filter((_value, i) => i % 2 === 1);
  return {x0: Math.min(...xs), y0: Math.min(...ys), x1: Math.max(...xs), y1: Math.max(...ys)};
}

function path_of(element: Element, place: Place): Stroke | null {
  const points = numbers(element.getAttribute("points"));
  const closed = element.tagName === "polygon";
  if (points.length < 4 || (!closed && element.tagName !== "polyline")) return null;
  const parts: string[] = [];
  for (let i = 0; i + 1 < points.length; i += 2) {
    parts.push(place(points[i] as number, points[i + 1] as number).map((value) => value.toFixed(1)).join(" "));
  }
  return {d: `M${parts.join("L")}${closed ? "Z" : ""}`, closed};
}

/** The drawing of each thing in its own frame: centimetres, y downwards, front down the page at rotation 0. */
export function read_symbols(svg: Document, layout: Layout): Symbols {
  const symbols = new Map<string, Stroke[]>();
  const floor = svg.querySelectorAll("svg > polygon")[1];
  if (!floor) return symbols;
  const page = extent(numbers(floor.getAttribute("points")));
  const room = room_bounds(layout.room);
  const scale = (room.x1 - room.x0) / (page.x1 - page.x0);
  for (const object of layout.objects) {
    const angle = (object.rotation * Math.PI) / 180;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const place: Place = (x, y) => {
      const dx = room.x0 + (x - page.x0) * scale - object.pos[0];
      const dy = room.y0 + (page.y1 - y) * scale - object.pos[1];
      return [100 * (c * dx + s * dy), -100 * (c * dy - s * dx)];
    };
    const group = svg.querySelector(`g[data-id="${CSS.escape(object.id)}"]`);
    const strokes = [...(group?.children ?? [])].map((element) => path_of(element, place)).filter((stroke) => stroke !== null);
    if (strokes.length > 0) symbols.set(object.id, strokes);
  }
  return symbols;
}

const known = new Map<string, Promise<Symbols>>();

export function symbols_of(layout: Layout): Promise<Symbols> {
  const key = shape_key(layout);
  let found = known.get(key);
  if (!found) {
    if (known.size > 8) known.clear();
    found = api.export({layout, format: "svg"})
      .then((blob) => blob.text())
      .then((text) => read_symbols(new DOMParser().parseFromString(text, "image/svg+xml"), layout))
      .catch(() => new Map());
    known.set(key, found);
  }
  return found;
}
