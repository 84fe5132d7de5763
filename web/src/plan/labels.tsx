// Names on the plan: within the thing's outline, upright where it is narrow, none over another.
import type {LayoutObject} from "../gen/types";
import {type Box, type Point, bounds, footprint, kFlat} from "../pure/geometry";
import {type Frame, round} from "./frame";

const kPixels = [13, 11, 9.5];
/** Of a letter's height: how wide one is, how far lines are apart, and how far a word may stand out. */
const kWide = 0.56;
const kLine = 1.1;
const kBeyond = 0.2;

interface Label { id: string; at: Point; lines: string[]; size: number; upright: boolean }

/** Lines of a label that fit a width. */
function lines_of(name: string, width: number, size: number): string[] {
  const fits = Math.max(3, Math.floor(width / (size * kWide)));
  const lines: string[] = [];
  for (const word of name.split(" ")) {
    const last = lines.at(-1);
    if (last !== undefined && `${last} ${word}`.length <= fits) lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(word);
  }
  return lines;
}

const over = (a: Box, b: Box): boolean => a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;

/** The largest writing that fits, in the middle or else near an end, where nothing is written yet. */
function label_of(object: LayoutObject, name: string, frame: Frame, taken: Box[]): Label | null {
  const box = bounds(footprint(object));
  const [w, d] = [(box.x1 - box.x0) * 100, (box.y1 - box.y0) * 100];
  const [cx, cy] = frame.at([(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2]);
  for (const pixels of kPixels) {
    for (const upright of d > 1.4 * w ? [false, true] : [false]) {
      const size = pixels * frame.px;
      const [along, across] = upright ? [d, w] : [w, d];
      const lines = lines_of(name, along, size);
      const [wide, high] = [Math.max(...lines.map((line) => line.length)) * size * kWide, lines.length * size * kLine];
      if (high > across || wide > along + 2 * kBeyond * size) continue;
      const [width, height] = upright ? [high, wide] : [wide, high];
      const [sx, sy] = [Math.max(0, (w - width) / 2), Math.max(0, (d - height) / 2)];
      for (const [dx, dy] of [[0, 0], [0, -sy], [0, sy], [-sx, 0], [sx, 0]] as Point[]) {
        const place = {x0: cx + dx - width / 2, x1: cx + dx + width / 2, y0: cy + dy - height / 2, y1: cy + dy + height / 2};
        if (taken.some((one) => over(one, place))) continue;
        taken.push(place);
        return {id: object.id, at: [cx + dx, cy + dy], lines, size, upright};
      }
    }
  }
  return null;
}

export function labels_of(objects: readonly LayoutObject[], names: ReadonlyMap<string, string>, frame: Frame): Label[] {
  const taken: Box[] = [];
  const floor = objects.filter((object) => object.supportedBy === "floor" && object.size[2] > kFlat);
  const largest_first = [...floor].sort((a, b) => b.size[0] * b.size[1] - a.size[0] * a.size[1]);
  return largest_first.flatMap((object) => label_of(object, names.get(object.id) ?? "", frame, taken) ?? []);
}

export function Labels({objects, names, frame}: {objects: readonly LayoutObject[]; names: ReadonlyMap<string, string>; frame: Frame}) {
  return (
    <g class="labels">
      {labels_of(objects, names, frame).map(({id, at: [x, y], lines, size, upright}) => (
        <text key={id} class="label" x={round(x)} y={round(y)} font-size={round(size)} {...(upright ? {transform: `rotate(-90 ${round(x)} ${round(y)})`} : {})}>
          {lines.map((line, i) => <tspan x={round(x)} y={round(y + (i - (lines.length - 1) / 2) * size * kLine)}>{line}</tspan>)}
        </text>
      ))}
    </g>
  );
}
