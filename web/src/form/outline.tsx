// The outline of a room, drawn: corners are dragged or moved by keys, a click on a side's middle makes a new one.
import {useRef} from "preact/hooks";
import {type Point, bounds} from "../pure/geometry";
import {moved_corner, outline_area, with_corner, without_corner} from "../pure/outline";
import {area_text, length_text} from "../pure/units";
import {use} from "../state/store";
import {texts} from "../texts";

const kMargin = 0.9;
const kArrows: Record<string, Point> = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1]};

/** A text beside an upright side begins or ends there. */
const anchor = (across: number): "start" | "middle" | "end" => (across > 0.5 ? "start" : across < -0.5 ? "end" : "middle");

interface OutlineProps { points: Point[]; change: (points: Point[]) => void }

export function Outline({points, change}: OutlineProps) {
  const svg = useRef<SVGSVGElement>(null);
  const latest = useRef(points);
  latest.current = points;
  const units = use((state) => state.units);
  const box = bounds(points);
  const [w, d] = [box.x1 - box.x0 + 2 * kMargin, box.y1 - box.y0 + 2 * kMargin];
  const side = Math.max(w, d);
  const at = ([x, y]: Point): string => `${x} ${-y}`;

  const drag = (event: PointerEvent, index: number) => {
    const matrix = svg.current?.getScreenCTM()?.inverse();
    if (!matrix || event.button > 0) return;
    const knob = event.currentTarget as SVGElement;
    knob.setPointerCapture(event.pointerId);
    const move = (now: PointerEvent) => {
      const point = new DOMPoint(now.clientX, now.clientY).matrixTransform(matrix);
      change(moved_corner(latest.current, index, [point.x, -point.y]));
    };
    const done = () => {
      knob.removeEventListener("pointermove", move);
      knob.removeEventListener("pointerup", done);
      knob.removeEventListener("pointercancel", done);
    };
    knob.addEventListener("pointermove", move);
    knob.addEventListener("pointerup", done);
    knob.addEventListener("pointercancel", done);
  };
  const on_key = (event: KeyboardEvent, index: number) => {
    const step = kArrows[event.key];
    const [x, y] = points[index] as Point;
    if (step) change(moved_corner(points, index, [x + step[0], y + step[1]]));
    else if (event.key === "Delete" || event.key === "Backspace") change(without_corner(points, index));
    else return;
    event.preventDefault();
  };
  const {outline} = texts.form;
  return (
    <div class="outline">
      <svg ref={svg} viewBox={`${box.x0 - kMargin} ${-box.y1 - kMargin} ${w} ${d}`} role="group" aria-label={outline.label} data-testid="outline">
        <path class="shape" d={`M${points.map(at).join("L")}Z`} stroke-width={side / 90} />
        {points.map((point, i) => {
          const next = points[(i + 1) % points.length] as Point;
          const middle: Point = [(point[0] + next[0]) / 2, (point[1] + next[1]) / 2];
          const length = Math.hypot(next[0] - point[0], next[1] - point[1]) || 1;
          const out: Point = [(next[1] - point[1]) / length, (point[0] - next[0]) / length];
          return (
            <g key={`side ${i}`}>
              <text x={middle[0] + out[0] * side * 0.03} y={-middle[1] - out[1] * side * 0.04} font-size={side / 34} text-anchor={anchor(out[0])}>{`${i + 1}: ${length_text(length, units)}`}</text>
              <circle
                class="add" cx={middle[0]} cy={-middle[1]} r={side / 75} role="button" tabindex={0} aria-label={outline.add(i + 1)} data-testid={`outline-add-${i}`}
                onClick={() => change(with_corner(points, i))} onKeyDown={(event) => (event.key === "Enter" || event.key === " ") && (event.preventDefault(), change(with_corner(points, i)))}
              />
            </g>
          );
        })}
        {points.map((point, i) => (
          <circle
            key={`corner ${i}`} class="corner" cx={point[0]} cy={-point[1]} r={side / 50} role="button" tabindex={0} data-testid={`outline-corner-${i}`}
            aria-label={outline.corner(i + 1)} onPointerDown={(event) => drag(event, i)} onKeyDown={(event) => on_key(event, i)}
            onDblClick={() => change(without_corner(points, i))}
          />
        ))}
      </svg>
      <p class="quiet">{area_text(outline_area(points), units)} · {outline.hint}</p>
    </div>
  );
}
