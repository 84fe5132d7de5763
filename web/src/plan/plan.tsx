// The floor plan: drawn from the layout, everything on it can be taken hold of.
import {useEffect, useMemo, useRef, useState} from "preact/hooks";
import type {Layout, LayoutObject} from "../gen/types";
import {footprint, gap_between} from "../pure/geometry";
import {references} from "../pure/relations";
import {names_of, shape_key} from "../pure/scenes";
import {opening_middle} from "../pure/shell_moves";
import {size_text} from "../pure/units";
import {type State, get, set, use} from "../state/store";
import {texts} from "../texts";
import {Corners} from "./corners";
import {grab, grab_size, grab_turn, paper} from "./grab";
import {type Frame, frame_of, round} from "./frame";
import {Grips} from "./grips";
import {Knobs, Measure, Reason, Ways} from "./handles";
import {on_thing_key} from "./keys";
import {Labels} from "./labels";
import {Shell} from "./shell";
import {type Symbols, symbols_of} from "./symbols";
import {Outline} from "./thing";

function useSymbols(layout: Layout | null): Symbols {
  const [symbols, put] = useState<Symbols>(new Map());
  const key = useMemo(() => (layout ? shape_key(layout) : ""), [layout]);
  useEffect(() => {
    let current = true;
    put(new Map());
    if (layout) void symbols_of(layout).then((found) => current && put(found));
    return () => {
      current = false;
    };
  }, [key]);
  return symbols;
}

/** Where to write about a thing, a door or a window. */
function middle_of(layout: Layout, id: string): Pick<LayoutObject, "pos" | "size"> {
  const opening = layout.room.openings?.find((one) => one.id === id);
  const [x, y] = (opening && opening_middle(layout.room, opening)) ?? [0, 0];
  return {pos: [x, y, 0], size: [0.6, 0.6, 0]};
}

const by_height = (a: LayoutObject, b: LayoutObject): number => a.pos[2] + a.size[2] - (b.pos[2] + b.size[2]);

/** Units of the drawing in a pixel of the screen. */
function useScale(svg: {current: SVGSVGElement | null}, layout: Layout): number {
  const [px, put] = useState(1);
  useEffect(() => {
    const element = svg.current;
    if (!element) return undefined;
    const watch = new ResizeObserver(() => {
      const {width, height} = element.viewBox.baseVal;
      const box = element.getBoundingClientRect();
      if (box.width > 0 && box.height > 0) put(round(Math.max(width / box.width, height / box.height)));
    });
    watch.observe(element);
    return () => watch.disconnect();
  }, [layout.room]);
  return px;
}

function looks(object: LayoutObject, state: State, about: ReadonlySet<string>): string {
  const marks: string[] = [];
  if (state.selected === object.id) marks.push("selected");
  if (state.hovered === object.id) marks.push("hovered");
  if (about.has(object.id)) marks.push("about");
  if (state.rooms.now?.locked.includes(object.id)) marks.push("locked");
  if (state.preview?.id === object.id && !state.preview.legal) marks.push("illegal");
  if (state.preview?.moved.includes(object.id)) marks.push("moved");
  return marks.join(" ");
}

/** The two things of a relation, and the way between them. */
function Between({layout, relation, frame}: {layout: Layout; relation: string; frame: Frame}) {
  const units = use((state) => state.units);
  const found = layout.relations?.find((one) => one.id === relation);
  const subject = layout.objects.find((object) => object.id === found?.targets[0]);
  const other = found && references(found)[0];
  const thing = layout.objects.find((object) => object.id === other);
  const wall = layout.room.walls?.find((one) => one.id === other);
  if (!subject || (!thing && !wall)) return null;
  const gap = gap_between(footprint(subject), thing ? footprint(thing) : [wall!.start, wall!.end]);
  return gap.length > 0.005 ? <Measure gap={gap} frame={frame} units={units} about="between" /> : null;
}

function Ghost({layout, now, frame}: {layout: Layout; now: Layout; frame: Frame}) {
  const before = new Map(now.objects.map((object) => [object.id, object]));
  const other = layout.objects.filter((object) => {
    const same = before.get(object.id);
    return !same || JSON.stringify([same.pos, same.rotation, same.size]) !== JSON.stringify([object.pos, object.rotation, object.size]);
  });
  return (
    <g class="ghost">
      {other.map((object) => {
        const same = before.get(object.id);
        const [x, y] = frame.at([object.pos[0], object.pos[1]]);
        const [px, py] = same ? frame.at([same.pos[0], same.pos[1]]) : [x, y];
        return (
          <g key={object.id}>
            <path class="trail" d={`M${px} ${py}L${x} ${y}`} />
            <path class="shape" d={frame.path(footprint(object))} />
          </g>
        );
      })}
    </g>
  );
}

export function Plan({layout, live}: {layout: Layout; live: boolean}) {
  const state = use((now) => now);
  const svg = useRef<SVGSVGElement>(null);
  const [shell, show_shell] = useState<Layout | null>(null);
  const symbols = useSymbols(layout);
  const names = useMemo(() => names_of(layout), [layout]);
  const px = useScale(svg, layout);
  const frame = useMemo(() => frame_of(layout, px), [layout.room, px]);
  const things = useMemo(() => [...layout.objects].sort(by_height), [layout]);
  const relation = live ? layout.relations?.find((one) => one.id === state.relation) : undefined;
  const about = new Set(relation ? [...relation.targets, ...references(relation)] : []);
  const chosen = live ? layout.objects.find((object) => object.id === state.selected) : undefined;
  const held = state.preview?.id === chosen?.id ? state.preview : null;
  const refused = live && state.refused ? layout.objects.find((object) => object.id === state.refused?.id) ?? middle_of(layout, state.refused.id) : null;
  const outlining = live && state.outlining;
  const base = () => get().rooms.now?.layout ?? layout;
  const element = () => svg.current as SVGSVGElement;
  const why = (thing: Pick<LayoutObject, "pos" | "size">, text: string) => (
    <Reason at={frame.at([thing.pos[0], thing.pos[1]])} reach={Math.hypot(thing.size[0], thing.size[1]) * 50} text={text} px={frame.px} page={frame.page} />
  );
  const on = (object: LayoutObject) => ({
    onPointerDown: (event: PointerEvent) => {
      (event.currentTarget as SVGGElement).focus({preventScroll: true});
      grab(event, paper(element()), base(), base().objects.find((one) => one.id === object.id) ?? object);
    },
    onPointerEnter: () => set({hovered: object.id}),
    onPointerLeave: () => get().hovered === object.id && set({hovered: null}),
    onKeyDown: (event: KeyboardEvent) => on_thing_key(event, object),
    onFocus: () => get().selected !== object.id && !get().preview && set({selected: object.id, relation: null}),
  });
  return (
    <svg
      ref={svg} class={`plan${live ? " live" : ""}${outlining ? " outlining" : ""}`} viewBox={frame.view} data-testid={live ? "plan" : "plan-other"} role={live ? "group" : "img"}
      aria-label={texts.views.plan} aria-describedby={live ? "thing-help" : undefined}
      onPointerDown={(event) => live && event.target === event.currentTarget && set({selected: null, relation: null, refused: null})}
    >
      <Shell layout={shell ?? layout} frame={frame} />
      {things.map((object) => {
        const outline = <Outline object={object} frame={frame} strokes={symbols.get(object.id)} state={live ? looks(object, state, about) : ""} />;
        if (!live) return outline;
        return (
          <g
            key={object.id} class="grab" tabindex={0} role="button" data-testid={`thing-${object.id}`} aria-pressed={state.selected === object.id}
            aria-label={texts.views.thing(names.get(object.id) ?? object.id, size_text(object.size, state.units))} {...on(object)}
          >
            {outline}
            <title>{names.get(object.id)}</title>
          </g>
        );
      })}
      {chosen && held && <path class={`in-hand${held.legal ? "" : " wrong"}`} d={frame.path(footprint(chosen))} />}
      <Labels objects={things} names={names} frame={frame} />
      {live && <Grips layout={layout} base={base} frame={frame} svg={element} show={show_shell} />}
      {outlining && <Corners layout={shell ?? layout} base={base} frame={frame} svg={element} show={show_shell} />}
      {live && state.ghost && <Ghost layout={state.ghost.layout} now={layout} frame={frame} />}
      {live && relation && <Between layout={layout} relation={state.relation ?? ""} frame={frame} />}
      {chosen && !outlining && !state.ghost && !relation && held?.legal !== false && <Ways layout={layout} object={chosen} frame={frame} units={state.units} />}
      {chosen && !outlining && !state.ghost && !state.rooms.now?.locked.includes(chosen.id) && (
        <Knobs
          object={chosen} frame={frame}
          on_turn={(event) => grab_turn(event, paper(element()), base(), base().objects.find((one) => one.id === chosen.id) ?? chosen)}
          on_resize={(event) => grab_size(event, paper(element()), base(), base().objects.find((one) => one.id === chosen.id) ?? chosen)}
        />
      )}
      {chosen && held && !held.legal && why(chosen, held.reasons.map((reason) => reason.text).join("; "))}
      {live && state.preview && !state.preview.legal && !held && why(middle_of(layout, state.preview.id), state.preview.reasons.map((reason) => reason.text).join("; "))}
      {refused && !held && why(refused, state.refused?.text ?? "")}
    </svg>
  );
}
