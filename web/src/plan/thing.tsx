// One thing on the plan: its outline with a tick at the front, or the program's own drawing of it, and its label.
import type {LayoutObject} from "../gen/types";
import {kFlat} from "../pure/geometry";
import {round} from "./frame";
import type {Frame} from "./frame";
import type {Stroke} from "./symbols";

const kLabelPixels = [13, 11, 9.5];

interface ThingProps {
  object: LayoutObject;
  name: string;
  frame: Frame;
  strokes: Stroke[] | undefined;
  state: string;
}

/** Lines of a label that fit a width, shortened where nothing fits. */
export function label_lines(name: string, width: number, size: number): string[] {
  const fits = Math.max(3, Math.floor(width / (size * 0.56)));
  if (name.length <= fits) return [name];
  const lines: string[] = [];
  for (const word of name.split(" ")) {
    const last = lines.at(-1);
    if (last !== undefined && `${last} ${word}`.length <= fits) lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(word);
  }
  return lines;
}

export function Outline({object, frame, strokes, state}: Omit<ThingProps, "name">) {
  const [w, d] = [object.size[0] * 100, object.size[1] * 100];
  const [x, y] = frame.at([object.pos[0], object.pos[1]]);
  const tick = Math.min(w * 0.3, 14);
  const flat = object.size[2] <= kFlat;
  return (
    <g class={`thing ${state}${flat ? " flat" : ""}`} transform={`translate(${x} ${y}) rotate(${round(-object.rotation)})`}>
      <rect class="hit" x={-w / 2 - 2} y={-d / 2 - 2} width={w + 4} height={d + 4} />
      {strokes ? strokes.map((stroke) => <path class={stroke.closed ? "body" : "line"} d={stroke.d} />)
        : <rect class="body" x={-w / 2} y={-d / 2} width={w} height={d} rx="2" />}
      <rect class="rim" x={-w / 2} y={-d / 2} width={w} height={d} rx="2" />
      {object.usedSides?.includes("front") && <path class="front" d={`M${-tick} ${d / 2}H${tick}`} />}
    </g>
  );
}

export function Label({object, name, frame}: Pick<ThingProps, "object" | "name" | "frame">) {
  const sideways = Math.abs(Math.round(object.rotation / 90)) % 2 === 1;
  const [w, d] = sideways ? [object.size[1], object.size[0]] : [object.size[0], object.size[1]];
  if (w < 0.3 || d < 0.2) return null;
  const [x, y] = frame.at([object.pos[0], object.pos[1]]);
  for (const pixels of kLabelPixels) {
    const size = pixels * frame.px;
    const lines = label_lines(name, w * 100 - 4, size);
    const high = lines.length * size * 1.1;
    const wide = Math.max(...lines.map((line) => line.length)) * size * 0.52;
    if (high > d * 100 || wide > w * 100 + 10) continue;
    return (
      <text class="label" x={x} y={y} font-size={round(size)}>
        {lines.map((line, i) => (
          <tspan x={x} y={round(y + (i - (lines.length - 1) / 2) * size * 1.1)}>{line}</tspan>
        ))}
      </text>
    );
  }
  return null;
}
