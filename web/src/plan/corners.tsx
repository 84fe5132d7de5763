// The outline of a room that is there already, redrawn: its corners are dragged, walls parted, corners taken away.
import {useRef} from "preact/hooks";
import type {Layout} from "../gen/types";
import {move_corner, on_wall, outline_of, remove_corner, split_wall, wall_length} from "../pure/corners";
import {places_of} from "../pure/relations";
import {reshape} from "../state/actions";
import {get, set, use} from "../state/store";
import {texts} from "../texts";
import type {Frame} from "./frame";
import {grab_shell} from "./grab";
import {step_of} from "./grips";
import {Measure} from "./handles";

interface CornersProps { layout: Layout; base: () => Layout; frame: Frame; svg: () => SVGSVGElement; show: (layout: Layout | null) => void }

/** Pixels: dots to take hold of, how far from them a finger may be, and lengths within the walls. */
const kDot = 6.5;
const kFinger = 14;
const kInside = 18;
/** Milliseconds between two clicks that are one double click: the plan has the pointer, so no corner hears of them. */
const kTwice = 400;

export function Corners({layout, base, frame, svg, show}: CornersProps) {
  const units = use((state) => state.units);
  const walls = layout.room.walls ?? [];
  const names = places_of(layout);
  const {outline} = texts.views;
  const dot = (at: [number, number], look: string) => (
    <>
      <circle class="finger" cx={at[0]} cy={at[1]} r={kFinger * frame.px} />
      <circle class={look} cx={at[0]} cy={at[1]} r={kDot * frame.px} />
    </>
  );
  const on_key = (event: KeyboardEvent, index: number) => {
    const step = step_of(event);
    const corner = outline_of(base().room.walls ?? [])[index];
    if (step && corner) return void reshape(move_corner(base(), index, [corner[0] + step[0], corner[1] + step[1]], false));
    if (event.key === "Delete" || event.key === "Backspace") void reshape(remove_corner(base(), index));
    else if (event.key === "Escape") set({outlining: false});
    else return;
    event.preventDefault();
  };
  const clicks = useRef({index: -1, at: 0});
  const clicked = (index: number) => {
    const [before, now] = [clicks.current, performance.now()];
    clicks.current = {index, at: now};
    if (before.index === index && now - before.at < kTwice) void reshape(remove_corner(base(), index));
  };
  const split = (index: number) => void reshape(split_wall(base(), index));
  return (
    <g class="corners">
      {walls.map((wall) => {
        const length = wall_length(wall);
        const inside = (kInside * frame.px) / 100;
        return <Measure key={wall.id} gap={{from: on_wall(wall, 0, -inside), to: on_wall(wall, length, -inside), length}} frame={frame} units={units} about="side" at={0.3} />;
      })}
      {walls.map((wall, i) => {
        const [x, y] = frame.at(on_wall(wall, wall_length(wall) / 2, 0));
        const arm = kDot * 0.55 * frame.px;
        return (
          <g
            key={`split ${wall.id}`} class="dot split" role="button" tabindex={0} aria-label={outline.split(names.get(wall.id) ?? wall.id)} data-testid={`split-${wall.id}`}
            onClick={() => split(i)} onKeyDown={(event) => (event.key === "Enter" || event.key === " ") && (event.preventDefault(), split(i))}
          >
            {dot([x, y], "plus")}
            <path d={`M${x - arm} ${y}h${2 * arm}M${x} ${y - arm}v${2 * arm}`} />
          </g>
        );
      })}
      {outline_of(walls).map((corner, i) => (
        <g
          key={`corner ${i}`} class="dot" role="button" tabindex={0} aria-label={outline.corner(i + 1)} data-testid={`corner-${i}`} onKeyDown={(event) => on_key(event, i)}
          onPointerDown={(event) => grab_shell(event, svg(), (now) => move_corner(base(), i, now, get().snap), show, () => clicked(i))}
        >
          {dot(frame.at(corner), "corner")}
        </g>
      ))}
    </g>
  );
}
