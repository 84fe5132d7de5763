// Over the picture in 3D, as on the plan: knobs to turn, to resize and to raise the chosen thing, free ways while it moves, why it cannot stand there.
import {useEffect, useRef, useState} from "preact/hooks";
import type {Layout, LayoutObject} from "../gen/types";
import {type Point, in_room} from "../pure/geometry";
import {type Ground, grab_height, grab_size, grab_turn} from "../plan/grab";
import {Knob, Reason, Ways, kKnobAt} from "../plan/handles";
import {get, use} from "../state/store";
import type {RoomView} from "./room_view";

/** Pixels above a thing's top. */
const kAboveTop = 18;

interface KnobsProps { object: LayoutObject; base: LayoutObject; view: RoomView; svg: SVGSVGElement }

function Knobs({object, base, view, svg}: KnobsProps) {
  const {aim} = view;
  const [w, d, h] = object.size;
  const foot = object.pos[2];
  const middle: Point = [object.pos[0], object.pos[1]];
  const before = in_room(object, [0, -d / 2]);
  const front = aim.on_canvas(before, foot);
  const turn = aim.on_canvas(in_room(object, [0, -d / 2 - kKnobAt * aim.metres_per_pixel(before, foot)]), foot);
  const size = aim.on_canvas(in_room(object, [w / 2, -d / 2]), foot);
  const top = aim.on_canvas(middle, foot + h);
  const layout = get().rooms.now?.layout;
  if (!front || !turn || !size || !top || !layout) return null;
  const ground: Ground = {element: svg, where: ({clientX, clientY}) => aim.at_height(clientX, clientY, foot)};
  const raised: Point = [top[0], top[1] - kAboveTop];
  const high = ({clientX, clientY}: {clientX: number; clientY: number}) => {
    const height = aim.height_over(clientX, clientY + kAboveTop, middle);
    return height === null ? null : height - foot;
  };
  return (
    <g class="knobs">
      <path d={`M${front.join(" ")}L${turn.join(" ")}M${top.join(" ")}L${raised.join(" ")}`} />
      <Knob look="height" at={raised} px={1} id="knob3d-height" on={(event) => grab_height(event, svg, high, layout, base)} />
      <Knob look="turn" at={turn} px={1} id="knob3d-turn" on={(event) => grab_turn(event, ground, layout, base)} />
      <Knob look="size" at={size} px={1} id="knob3d-resize" on={(event) => grab_size(event, ground, layout, base)} />
    </g>
  );
}

export function Handles3D({layout, view}: {layout: Layout; view: () => RoomView | null}) {
  const svg = useRef<SVGSVGElement>(null);
  const [, seen_anew] = useState(0);
  const {selected, preview, refused, units, rooms} = use((state) => state);
  useEffect(() => {
    const now = view();
    if (!now) return undefined;
    now.on_frame = () => seen_anew((count) => count + 1);
    return () => { now.on_frame = null; };
  }, []);
  const now = view();
  const object = layout.objects.find((one) => one.id === selected);
  const base = rooms.now?.layout.objects.find((one) => one.id === selected);
  const held = preview?.id === selected ? preview : null;
  const reason = held && !held.legal ? held.reasons.map((one) => one.text).join("; ") : refused?.id === selected ? refused?.text : "";
  const locked = rooms.now?.locked.includes(selected ?? "") ?? false;
  const shown = now && object;
  const on_floor = (point: Point): Point => (shown && now.aim.on_canvas(point, object.pos[2])) || [0, 0];
  const page = {x0: 4, y0: 4, x1: (now?.canvas.clientWidth ?? 0) - 4, y1: (now?.canvas.clientHeight ?? 0) - 4};
  const top = shown ? now.aim.on_canvas([object.pos[0], object.pos[1]], object.pos[2] + object.size[2]) : null;
  return (
    <svg ref={svg} class="handles" aria-hidden="true">
      {shown && held?.legal && <Ways layout={layout} object={object} frame={{at: on_floor, px: 1}} units={units} />}
      {shown && base && !locked && svg.current && <Knobs object={object} base={base} view={now} svg={svg.current} />}
      {top && reason && <Reason at={top} reach={kAboveTop + 26} text={reason} px={1} page={page} />}
    </svg>
  );
}
