// Where doors, windows and walls are taken hold of.
import type {Layout, LayoutOpening, LayoutWall} from "../gen/types";
import {on_wall, wall_length} from "../pure/corners";
import {opening_middle} from "../pure/shell_moves";
import {places_of} from "../pure/relations";
import {remove_opening, shift_wall} from "../state/actions";
import {nudge_opening} from "../state/hand";
import {set, use} from "../state/store";
import {texts} from "../texts";
import type {Frame} from "./frame";
import {grab_opening, grab_wall} from "./grab";

const kWallWidth = 0.1;
const kArrows: Record<string, [number, number]> = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

interface GripsProps { layout: Layout; base: () => Layout; frame: Frame; svg: () => SVGSVGElement; show: (layout: Layout | null) => void }

/** Metres that an arrow key stands for. */
export function step_of(event: KeyboardEvent): [number, number] | null {
  const arrow = kArrows[event.key];
  if (!arrow) return null;
  event.preventDefault();
  const step = event.shiftKey ? 0.1 : 0.01;
  return [arrow[0] * step, arrow[1] * step];
}

function opening_key(event: KeyboardEvent, layout: Layout, opening: LayoutOpening): void {
  if (event.key === "Delete" || event.key === "Backspace") {
    event.preventDefault();
    return void remove_opening(opening.id);
  }
  const step = step_of(event);
  const middle = opening_middle(layout.room, opening);
  if (step && middle) nudge_opening(opening.id, [middle[0] + step[0], middle[1] + step[1]]);
}

function wall_key(event: KeyboardEvent, wall: LayoutWall): void {
  const step = step_of(event);
  if (!step) return;
  const [x0, y0] = on_wall(wall, 0, 0);
  const [x1, y1] = on_wall(wall, 0, 1);
  const out = step[0] * (x1 - x0) + step[1] * (y1 - y0);
  if (Math.abs(out) > 0.001) void shift_wall(wall.id, Math.round(out * 100) / 100);
}

export function Grips({layout, base, frame, svg, show}: GripsProps) {
  const names = places_of(layout);
  const selected = use((state) => state.selected);
  const walls = layout.room.walls ?? [];
  const band = (wall: LayoutWall, from: number, to: number, inner: number) => {
    const thick = wall.thickness ?? kWallWidth;
    return frame.path([on_wall(wall, from, -inner), on_wall(wall, to, -inner), on_wall(wall, to, thick + 0.05), on_wall(wall, from, thick + 0.05)]);
  };
  const upright = (wall: LayoutWall) => Math.abs(wall.end[1] - wall.start[1]) > Math.abs(wall.end[0] - wall.start[0]);
  return (
    <>
      {walls.map((wall) => (
        <path
          key={wall.id} class={`grip ${upright(wall) ? "across" : "updown"}`} d={band(wall, 0, wall_length(wall), 0)} tabindex={0} role="button"
          data-testid={`wall-${wall.id}`} aria-label={texts.views.wall(names.get(wall.id) ?? wall.id)}
          onKeyDown={(event) => wall_key(event, wall)}
          onPointerDown={(event) => grab_wall(event, svg(), base(), base().room.walls?.find((one) => one.id === wall.id) ?? wall, show)}
        />
      ))}
      {(layout.room.openings ?? []).map((opening) => {
        const wall = walls.find((one) => one.id === opening.wall);
        return wall && (
          <path
            key={opening.id} class={`grip${selected === opening.id ? " selected" : ""}`} d={band(wall, opening.offset, opening.offset + opening.w, 0.06)} tabindex={0} role="button"
            data-testid={`opening-${opening.id}`} aria-label={texts.views.opening(names.get(opening.id) ?? opening.id)}
            onKeyDown={(event) => opening_key(event, layout, opening)} onFocus={() => set({selected: opening.id, relation: null})} onPointerDown={(event) => grab_opening(event, svg(), base(), opening)}
          />
        );
      })}
    </>
  );
}
