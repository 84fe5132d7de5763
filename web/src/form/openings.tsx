// Doors and windows of the form. Without any, the room gets a door and a window where they are least in the way.
import {Tool} from "../bar";
import {Icon} from "../icons";
import {type FormOpening, type FormValue, wall_ids} from "../pure/form_scene";
import {texts} from "../texts";
import {fresh_key} from "./pieces";

interface Part { value: FormValue; change: (part: Partial<FormValue>) => void }

export function Openings({value, change}: Part) {
  const {form} = texts;
  const put = (key: number, part: Partial<FormOpening>) =>
    change({openings: value.openings.map((one) => (one.key === key ? {...one, ...part} : one))});
  const add = (type: FormOpening["type"]) => change({openings: [...value.openings, {key: fresh_key(), type, wall: "", offset: "", w: ""}]});
  return (
    <fieldset>
      <legend>{form.openings}</legend>
      <ul class="pieces">
        {value.openings.map((one) => (
          <li key={one.key}>
            <b>{texts.places[one.type]}</b>
            <label class="field">
              <span>{form.wall}</span>
              <select value={one.wall} onChange={(event) => put(one.key, {wall: event.currentTarget.value})}>
                <option value="">{form.any_wall}</option>
                {wall_ids(value).map((id, i) => <option value={id}>{value.outline ? i + 1 : form.walls[id]}</option>)}
              </select>
            </label>
            <label class="field"><span>{form.offset}</span><input value={one.offset} disabled={!one.wall} onInput={(event) => put(one.key, {offset: event.currentTarget.value})} /></label>
            <label class="field"><span>{form.width}</span><input value={one.w} placeholder={form.usual} onInput={(event) => put(one.key, {w: event.currentTarget.value})} /></label>
            <Tool name="remove" label={`${form.remove}: ${texts.places[one.type]}`} id={`form-remove-${one.key}`} on={() => change({openings: value.openings.filter((other) => other !== one)})} />
          </li>
        ))}
      </ul>
      <p class="outs">
        {(["door", "window", "open"] as const).map((type) => (
          <button key={type} type="button" class="small plus" aria-label={texts.openings.adds(texts.openings.add[type])} data-testid={`form-${type}`} onClick={() => add(type)}><Icon name="plus" />{texts.openings.add[type]}</button>
        ))}
      </p>
    </fieldset>
  );
}
