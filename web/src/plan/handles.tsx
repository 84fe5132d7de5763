// Beside the thing in the hand: free ways with their lengths, why it cannot stand there, knobs to turn and to resize it.
import type {Layout, LayoutObject} from "../gen/types";
import {type Box, type Gap, type Point, free_ways, in_room} from "../pure/geometry";
import {type Units, length_text} from "../pure/units";
import type {Frame} from "./frame";

const kShortest = 0.02;
/** Pixels from a thing's front to the middle of the knob that turns it, and to what is written beyond that. */
export const kKnobAt = 24;
const kBeyondKnob = 58;
const kKnobAside = 10;

/** So far to the right of a way that goes down, or above one that goes across. */
const beside = ([dx, dy]: Point, far: number): Point => (Math.abs(dy) > Math.abs(dx) ? [far, 0] : [0, -far / 2]);

/** `at`: how far along its length is written; `beyond`: at least so many pixels from where it begins. */
interface MeasureProps { gap: Gap; frame: Pick<Frame, "at" | "px">; units: Units; about?: string; at?: number; beyond?: number }

export function Measure({gap, frame, units, about = "way", at = 0.5, beyond = 0}: MeasureProps) {
  const [x1, y1] = frame.at(gap.from);
  const [x2, y2] = frame.at(gap.to);
  const text = length_text(gap.length, units);
  const size = 11 * frame.px;
  const half = text.length * size * 0.3 + 3 * frame.px;
  const way = Math.hypot(x2 - x1, y2 - y1) || 1;
  const share = Math.max(at, (beyond * frame.px) / way);
  // Where the way ends before that, the length is written beside it.
  const aside = share > 1 ? beside([x2 - x1, y2 - y1], half + kKnobAside * frame.px) : [0, 0];
  const along = share > 1 ? at : share;
  const [x, y] = [x1 + (x2 - x1) * along + (aside[0] as number), y1 + (y2 - y1) * along + (aside[1] as number)];
  return (
    <g class={`measure ${about}`}>
      <path d={`M${x1} ${y1}L${x2} ${y2}`} />
      <rect x={x - half} y={y - size * 0.7} width={half * 2} height={size * 1.4} rx={3 * frame.px} />
      <text x={x} y={y} font-size={size}>{text}</text>
    </g>
  );
}

interface WaysProps { layout: Layout; object: LayoutObject; frame: Pick<Frame, "at" | "px">; units: Units }

export function Ways({layout, object, frame, units}: WaysProps) {
  const [fx, fy] = in_room(object, [0, -object.size[1] / 2]);
  const at_front = ({from: [x, y]}: Gap): boolean => Math.hypot(x - fx, y - fy) < 0.01;
  return (
    <g class="ways">
      {free_ways(layout, object).filter((gap) => gap.length > kShortest).map((gap) => (
        <Measure gap={gap} frame={frame} units={units} beyond={at_front(gap) ? kBeyondKnob : 0} />
      ))}
    </g>
  );
}

/** `at`: the thing's middle on the drawing; `reach`: how far it reaches from there; `page`: what of the drawing can be seen. */
interface ReasonProps { at: Point; reach: number; text: string; px: number; page: Box }

export function Reason({at: [x, y], reach, text, px, page}: ReasonProps) {
  const size = 12 * px;
  const fits = Math.max(14, Math.min(38, Math.floor((page.x1 - page.x0) / (size * 0.56)) - 3));
  const lines: string[] = [""];
  for (const word of (text.charAt(0).toUpperCase() + text.slice(1)).split(" ")) {
    if (`${lines.at(-1)} ${word}`.length > fits) lines.push(word);
    else lines[lines.length - 1] = `${lines.at(-1)} ${word}`.trim();
  }
  const half = Math.max(...lines.map((line) => line.length)) * size * 0.28 + size * 0.7;
  const high = (lines.length * 1.25 + 0.7) * size;
  const top = y - reach - high > page.y0 ? y - reach - high + 6 * px : Math.min(y + reach - 6 * px, page.y1 - high);
  const left = Math.min(Math.max(x, page.x0 + half), page.x1 - half);
  return (
    <g class="reason" role="status">
      <rect x={left - half} y={top} width={half * 2} height={high} rx={5 * px} />
      <text font-size={size}>{lines.map((line, i) => <tspan x={left} y={top + size * (0.98 + i * 1.25)}>{line}</tspan>)}</text>
    </g>
  );
}

export type OnPress = (event: PointerEvent) => void;

const kKnob = 7.5;
/** How far from a knob's middle a finger may be. */
const kFinger = 14;

/** A round knob turns, a square one resizes, a pointed one raises. */
export function Knob({look, at: [x, y], px, id, on}: {look: "turn" | "size" | "height"; at: Point; px: number; id: string; on: OnPress}) {
  const r = kKnob * px;
  return (
    <g class={`knob ${look}`} data-testid={id} onPointerDown={on}>
      <circle class="finger" cx={x} cy={y} r={kFinger * px} />
      {look === "turn" && <circle cx={x} cy={y} r={r} />}
      {look === "size" && <rect x={x - r * 0.8} y={y - r * 0.8} width={r * 1.6} height={r * 1.6} rx={2 * px} />}
      {look === "height" && <path d={`M${x} ${y - r * 1.35}L${x + r} ${y}L${x} ${y + r * 1.35}L${x - r} ${y}Z`} />}
    </g>
  );
}

interface KnobsProps { object: LayoutObject; frame: Frame; on_turn: OnPress; on_resize: OnPress }

export function Knobs({object, frame, on_turn, on_resize}: KnobsProps) {
  const [w, d] = [object.size[0] / 2, object.size[1] / 2];
  const at = (point: Point) => frame.at(in_room(object, point));
  const [fx, fy] = at([0, -d]);
  const turn = at([0, -d - (kKnobAt * frame.px) / 100]);
  return (
    <g class="knobs">
      <path d={`M${fx} ${fy}L${turn.join(" ")}`} />
      <Knob look="turn" at={turn} px={frame.px} id="knob-turn" on={on_turn} />
      <Knob look="size" at={at([w, -d])} px={frame.px} id="knob-resize" on={on_resize} />
    </g>
  );
}
