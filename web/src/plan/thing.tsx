// One thing on the plan: its outline with a tick at the front, or the program's own drawing of it.
import type {LayoutObject} from "../gen/types";
import {kFlat} from "../pure/geometry";
import {round} from "./frame";
import type {Frame} from "./frame";
import type {Stroke} from "./symbols";

interface ThingProps {
  object: LayoutObject;
  frame: Frame;
  strokes: Stroke[] | undefined;
  state: string;
}

export function Outline({object, frame, strokes, state}: ThingProps) {
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
