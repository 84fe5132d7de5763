// The chosen thing: name, size, place and turn to type in, lock, remove.
import {useEffect, useState} from "preact/hooks";
import {Tool} from "../bar";
import {bounds, footprint, on_grid, room_bounds, upright} from "../pure/geometry";
import {name_of, names_of} from "../pure/scenes";
import {length_value, read_length} from "../pure/units";
import {remove, toggle_lock} from "../state/actions";
import {Hand, type Pose, nudge} from "../state/hand";
import {doc, shown, use} from "../state/store";
import {texts} from "../texts";

interface FieldProps { label: string; value: string; id: string; off: boolean; read: (text: string) => Pose | null; thing: string }

/** A field whose value is taken with Enter or when it is left. */
function Field({label, value, id, off, read, thing}: FieldProps) {
  const [text, put] = useState(value);
  const [wrong, mark] = useState(false);
  useEffect(() => {
    put(value);
    mark(false);
  }, [value, thing]);
  const take = async () => {
    if (text === value) return;
    const pose = read(text);
    const now = doc();
    mark(pose === null);
    if (!pose || !now) return;
    const hand = new Hand(now.layout, thing, false);
    hand.move(pose);
    if (!(await hand.drop())) put(value);
  };
  return (
    <label class="field">
      <span>{label}</span>
      <input
        value={text} disabled={off} aria-invalid={wrong} data-testid={id} inputMode="text" onInput={(event) => put(event.currentTarget.value)}
        onBlur={() => void take()} onKeyDown={(event) => event.key === "Enter" && void take()}
      />
    </label>
  );
}

export function Selected() {
  const layout = use(shown);
  const selected = use((state) => state.selected);
  const units = use((state) => state.units);
  const refused = use((state) => state.refused);
  const preview = use((state) => state.preview);
  const locked = use((state) => state.rooms.now?.locked.includes(state.selected ?? "") ?? false);
  const object = layout?.objects.find((one) => one.id === selected);
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
  const common = {thing: object.id, off: locked};
  const reason = refused?.id === object.id ? refused.text : preview?.id === object.id && !preview.legal ? preview.reasons.map((one) => one.text).join("; ") : "";
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
      {reason && <p class="bad" role="status" data-testid="reason">{reason}</p>}
      {moved.length > 0 && <p class="quiet" data-testid="gives-way">{texts.hand.gives_way(moved.join(", "))}</p>}
    </section>
  );
}
