// The chosen thing, door or window: size, place and turn to type in, lock, remove.
import {Tool} from "../bar";
import type {Layout, LayoutOpening} from "../gen/types";
import {bounds, footprint, on_grid, room_bounds, upright} from "../pure/geometry";
import {places_of} from "../pure/relations";
import {name_of, names_of} from "../pure/scenes";
import {length_value, read_length} from "../pure/units";
import {change_opening, remove, remove_opening, toggle_lock} from "../state/actions";
import {Hand, type Pose, nudge} from "../state/hand";
import {doc, get, shown, use} from "../state/store";
import {texts} from "../texts";
import {Field} from "./fields";

/** Puts the thing so as a hand would. */
async function put_so(id: string, pose: Pose): Promise<boolean> {
  const now = doc();
  if (!now) return false;
  const hand = new Hand(now.layout, id, false);
  hand.move(pose);
  return hand.drop();
}

function Refused({id}: {id: string}) {
  const refused = use((state) => state.refused);
  const preview = use((state) => state.preview);
  const reason = refused?.id === id ? refused.text : preview?.id === id && !preview.legal ? preview.reasons.map((one) => one.text).join("; ") : "";
  return reason ? <p class="bad" role="status" data-testid="reason">{reason}</p> : null;
}

function SelectedOpening({opening, layout}: {opening: LayoutOpening; layout: Layout}) {
  const units = use((state) => state.units);
  const change = (part: Partial<LayoutOpening>) => change_opening(opening.id, part).then(() => get().error === null);
  const length = (key: "w" | "h" | "sill") => ({
    value: length_value(opening[key] ?? 0, units), id: `opening-field-${key}`, of: opening.id, take: change,
    read: (text: string) => {
      const metres = read_length(text, units);
      return metres === null || metres < 0 || (metres === 0 && key !== "sill") || metres > 20 ? null : {[key]: metres};
    },
  });
  const {openings} = texts;
  return (
    <section class="selected" data-testid="selected" aria-label={texts.thing.heading}>
      <header>
        <h2>{places_of(layout).get(opening.id) ?? opening.id}</h2>
        <Tool name="remove" label={texts.thing.remove} id="opening-remove" on={() => void remove_opening(opening.id)} />
      </header>
      <div class="fields">
        <Field label={texts.thing.width} {...length("w")} />
        <Field label={texts.thing.height} {...length("h")} />
        {opening.type === "window" && <Field label={openings.sill} {...length("sill")} />}
        {opening.type === "door" && (
          <label class="field">
            <span>{openings.swing}</span>
            <select value={opening.swing} data-testid="opening-swing" onChange={(event) => void change({swing: event.currentTarget.value as LayoutOpening["swing"] & string})}>
              {Object.entries(openings.swings).map(([name, text]) => <option value={name}>{text}</option>)}
            </select>
          </label>
        )}
      </div>
      <Refused id={opening.id} />
    </section>
  );
}

export function Selected() {
  const layout = use(shown);
  const selected = use((state) => state.selected);
  const units = use((state) => state.units);
  const preview = use((state) => state.preview);
  const locked = use((state) => state.rooms.now?.locked.includes(state.selected ?? "") ?? false);
  const object = layout?.objects.find((one) => one.id === selected);
  const opening = layout?.room.openings?.find((one) => one.id === selected);
  if (layout && opening) return <SelectedOpening opening={opening} layout={layout} />;
  if (!layout || !object) return null;
  const names = names_of(layout);
  const box = bounds(footprint(object));
  const room = room_bounds(layout.room);
  const length = (text: string) => read_length(text, units);
  const side = (index: 0 | 1 | 2) => (text: string) => {
    const metres = length(text);
    if (metres === null || metres <= 0 || metres > 50) return null;
    const size: [number, number, number] = [...object.size];
    size[index] = metres;
    return {size};
  };
  const place = (axis: 0 | 1, from: number) => (text: string) => {
    const metres = length(text);
    if (metres === null) return null;
    const pos: [number, number] = [object.pos[0], object.pos[1]];
    pos[axis] += metres - from;
    return {pos};
  };
  const turn = (text: string) => (/^-?\d+(\.\d+)?°?$/.test(text.trim()) ? {rotation: parseFloat(text)} : null);
  const common = {of: object.id, off: locked, take: (pose: Pose) => put_so(object.id, pose)};
  const carrier = layout.objects.find((one) => one.id === object.supportedBy);
  const moved = preview?.id === object.id && preview.legal ? preview.moved.map((id) => names.get(id) ?? id) : [];
  const value = (metres: number) => length_value(metres, units);
  return (
    <section class="selected" data-testid="selected" aria-label={texts.thing.heading}>
      <header>
        <h2>{names.get(object.id) ?? name_of(object)}{carrier && <small> {texts.thing.stands_on(names.get(carrier.id) ?? carrier.id)}</small>}</h2>
        <Tool name="left" label={texts.thing.turn_left} id="turn-left" off={locked} on={() => nudge(object.id, (now) => ({rotation: now.rotation + 90}))} />
        <Tool name="right" label={texts.thing.turn_right} id="turn-right" off={locked} on={() => nudge(object.id, (now) => ({rotation: now.rotation - 90}))} />
        <Tool name={locked ? "lock" : "unlock"} label={locked ? texts.thing.unlock : texts.thing.lock} id="lock" pressed={locked} on={() => toggle_lock(object.id)} />
        <Tool name="remove" label={texts.thing.remove} id="remove" off={locked} on={() => remove(object.id)} />
      </header>
      <div class="fields">
        <Field label={texts.thing.width} id="field-width" value={value(object.size[0])} read={side(0)} {...common} />
        <Field label={texts.thing.depth} id="field-depth" value={value(object.size[1])} read={side(1)} {...common} />
        <Field label={texts.thing.height} id="field-height" value={value(object.size[2])} read={side(2)} {...common} />
        <Field label={texts.thing.x} id="field-x" value={value(on_grid(box.x0 - room.x0))} read={place(0, box.x0 - room.x0)} {...common} />
        <Field label={texts.thing.y} id="field-y" value={value(on_grid(box.y0 - room.y0))} read={place(1, box.y0 - room.y0)} {...common} />
        <Field label={texts.thing.turn} id="field-turn" value={`${Math.round(upright(object.rotation) * 10) / 10}°`} read={turn} {...common} />
      </div>
      <Refused id={object.id} />
      {moved.length > 0 && <p class="quiet" data-testid="gives-way">{texts.hand.gives_way(moved.join(", "))}</p>}
    </section>
  );
}
