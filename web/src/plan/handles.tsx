// Beside the thing in the hand: free ways with their lengths, why it cannot stand there, knobs to turn and to resize it.
import type {Layout, LayoutObject} from "../gen/types";
import {type Gap, type Point, free_ways, in_room} from "../pure/geometry";
import {type Units, length_text} from "../pure/units";
import type {Frame} from "./frame";

const kShortest = 0.02;
/** Pixels from a thing's front to the middle of the knob that turns it, and to what is written beyond that. */
const kKnobAt = 24;
const kBeyondKnob = 58;

interface MeasureProps { gap: Gap; frame: Frame; units: Units; about?: string; /** at least so many pixels from where it begins */ beyond?: number }

export function Measure({gap, frame, units, about = "way", beyond = 0}: MeasureProps) {
  const [x1, y1] = frame.at(gap.from);
  const [x2, y2] = frame.at(gap.to);
  const share = Math.max(0.5, (beyond * frame.px) / (Math.hypot(x2 - x1, y2 - y1) || 1));
  const [x, y] = [x1 + (x2 - x1) * share, y1 + (y2 - y1) * share];
  const text = length_text(gap.length, units);
  const size = 11 * frame.px;
  const half = text.length * size * 0.3 + 3 * frame.px;
  return (
    <g class={`measure ${about}`}>
      <path d={`M${x1} ${y1}L${x2} ${y2}`} />
      <rect x={x - half} y={y - size * 0.7} width={half * 2} height={size * 1.4} rx={3 * frame.px} />
      <text x={x} y={y} font-size={size}>{text}</text>
    </g>
  );
}

export function Ways({layout, object, frame, units}: {layout: Layout; object: LayoutObject; frame: Frame; units: Units}) {
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

export function Reason({object, text, frame}: {object: Pick<LayoutObject, "pos" | "size">; text: string; frame: Frame}) {
  const [x, y] = frame.at([object.pos[0], object.pos[1]]);
  const size = 12 * frame.px;
  const width = (frame.box.x1 - frame.box.x0) * 100 + 40;
  const fits = Math.max(14, Math.min(38, Math.floor(width / (size * 0.56)) - 3));
  const lines: string[] = [""];
  for (const word of text.split(" ")) {
    if (`${lines.at(-1)} ${word}`.length > fits) lines.push(word);
    else lines[lines.length - 1] = `${lines.at(-1)} ${word}`.trim();
  }
  const half = Math.max(...lines.map((line) => line.length)) * size * 0.28 + size * 0.7;
  const reach = Math.hypot(object.size[0], object.size[1]) * 50;
  const high = (lines.length * 1.25 + 0.7) * size;
  const above = y - reach - high > -frame.box.y1 * 100 - 20;
  const top = above ? y - reach - high + 6 : y + reach - 6;
  const left = Math.min(Math.max(x, frame.box.x0 * 100 + half - 16), frame.box.x1 * 100 - half + 16);
  return (
    <g class="reason" role="status">
      <rect x={left - half} y={top} width={half * 2} height={high} rx={5 * frame.px} />
      <text font-size={size}>{lines.map((line, i) => <tspan x={left} y={top + size * (0.98 + i * 1.25)}>{line}</tspan>)}</text>
    </g>
  );
}

interface KnobsProps { object: LayoutObject; frame: Frame; on_turn: (event: PointerEvent) => void; on_resize: (event: PointerEvent) => void }

export function Knobs({object, frame, on_turn, on_resize}: KnobsProps) {
  const [w, d] = [object.size[0] / 2, object.size[1] / 2];
  const at = (point: Point) => frame.at(in_room(object, point));
  const [fx, fy] = at([0, -d]);
  const knob = 7.5 * frame.px;
  const [tx, ty] = at([0, -d - (kKnobAt * frame.px) / 100]);
  const [cx, cy] = at([w, -d]);
  return (
    <g class="knobs">
      <path d={`M${fx} ${fy}L${tx} ${ty}`} />
      <circle class="knob turn" data-testid="knob-turn" cx={tx} cy={ty} r={knob} onPointerDown={on_turn} />
      <rect class="knob size" data-testid="knob-resize" x={cx - knob * 0.8} y={cy - knob * 0.8} width={knob * 1.6} height={knob * 1.6} rx={2 * frame.px} onPointerDown={on_resize} />
    </g>
  );
}
