// A room by form: kind, size, openings, furniture, relations. Asks for the same as a scene file does.
import {useEffect, useRef, useState} from "preact/hooks";
import {Icon} from "../icons";
import {type FormValue, form_scene, wrong_lengths} from "../pure/form_scene";
import {type Shape, shape_of} from "../pure/outline";
import {read_length} from "../pure/units";
import {furnish_scene} from "../state/actions";
import {OpenFile, Prompt, ReadBy} from "../prompt";
import {get, set, use} from "../state/store";
import {texts} from "../texts";
import {Openings} from "./openings";
import {Outline} from "./outline";
import {Pieces} from "./pieces";
import {Relations} from "./relations";

const kEmpty: FormValue = {kind: "", w: "", d: "", h: "", outline: null, openings: [], pieces: [], relations: []};
let kept: FormValue = kEmpty;

function Size({value, change}: {value: FormValue; change: (part: Partial<FormValue>) => void}) {
  const units = use((state) => state.units);
  const {form} = texts;
  const side = (key: "w" | "d" | "h", label: string, usual: string) => (
    <label class="field">
      <span>{label} ({texts.bar[units === "m" ? "metres" : "feet"]})</span>
      <input value={value[key]} placeholder={usual} disabled={value.outline !== null && key !== "h"} data-testid={`form-${key}`} onInput={(event) => change({[key]: event.currentTarget.value})} />
    </label>
  );
  const [shape, put] = useState<Shape>(value.outline ? "l" : "rectangle");
  const reshape = (next: Shape) => {
    put(next);
    const read = (text: string, usual: number) => read_length(text, units) || usual;
    change({outline: next === "rectangle" ? null : shape_of(next, read(value.w, 5), read(value.d, 4))});
  };
  return (
    <fieldset>
      <legend>{form.room}</legend>
      <div class="fields">
        <label class="field">
          <span>{form.kind}</span>
          <input list="kinds" value={value.kind} data-testid="form-kind" onInput={(event) => change({kind: event.currentTarget.value})} />
          <datalist id="kinds">{form.kinds.map((kind) => <option value={kind} />)}</datalist>
        </label>
        <label class="field">
          <span>{form.shape}</span>
          <select value={shape} data-testid="form-shape" onChange={(event) => reshape(event.currentTarget.value as Shape)}>
            {Object.entries(form.shapes).map(([name, text]) => <option value={name}>{text}</option>)}
          </select>
        </label>
        {side("w", form.width, units === "m" ? "4" : "13'")}
        {side("d", form.depth, units === "m" ? "3.5" : "11' 6\"")}
        {side("h", form.height, units === "m" ? "2.7" : "9'")}
        <button type="button" class="small" data-testid="form-units" onClick={() => set({units: get().units === "m" ? "ft" : "m"})}>{texts.bar.units}</button>
      </div>
      {value.outline && <Outline points={value.outline} change={(outline) => change({outline})} />}
    </fieldset>
  );
}

export function Form() {
  const dialog = useRef<HTMLDialogElement>(null);
  const [value, put] = useState(kept);
  const [wrong, tell] = useState("");
  const open = use((state) => state.rooms.now !== null);
  useEffect(() => {
    dialog.current?.showModal();
    return () => dialog.current?.close();
  }, []);
  const change = (part: Partial<FormValue>) => put((now) => {
    kept = {...now, ...part};
    return kept;
  });
  const go = (event: Event) => {
    event.preventDefault();
    const {units} = get();
    const [bad] = wrong_lengths(value, units);
    if (bad !== undefined) return tell(texts.form.wrong_length(bad));
    if (value.pieces.length === 0 && !value.kind.trim()) return tell(texts.form.empty);
    tell("");
    void furnish_scene(form_scene(value, units));
    set({form: false});
  };
  return (
    <dialog ref={dialog} class="form" aria-labelledby="form-heading" data-testid="form-dialog" onClose={() => set({form: false})}>
      <header>
        <h2 id="form-heading">{open ? texts.bar.start : texts.form.heading}</h2>
        <button type="button" class="tool" aria-label={texts.form.close} data-testid="form-close" onClick={() => set({form: false})}><Icon name="close" /></button>
      </header>
      {open && <div class="anew"><Prompt large empty /><OpenFile /><ReadBy /><h3>{texts.form.heading}</h3></div>}
      <form onSubmit={go}>
        <Size value={value} change={change} />
        <Pieces value={value} change={change} />
        <Openings value={value} change={change} />
        <Relations value={value} change={change} />
        {wrong && <p class="bad" role="alert">{wrong}</p>}
        <footer><button type="submit" class="main" data-testid="form-go">{texts.form.go}</button></footer>
      </form>
    </dialog>
  );
}
