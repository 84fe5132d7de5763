// The furniture of the form: from the catalogue by search, or own pieces; counts and sizes.
import {useState} from "preact/hooks";
import {Tool} from "../bar";
import {Icon} from "../icons";
import type {FormPiece, FormValue} from "../pure/form_scene";
import {size_text} from "../pure/units";
import {use} from "../state/store";
import {texts} from "../texts";
import {useCatalog} from "../panels/things";

let next_key = 1;
export const fresh_key = (): number => next_key++;

interface Part { value: FormValue; change: (part: Partial<FormValue>) => void }

export function Pieces({value, change}: Part) {
  const units = use((state) => state.units);
  const [search, look_for] = useState("");
  const found = useCatalog(search);
  const {form} = texts;
  const put = (key: number, part: Partial<FormPiece>) =>
    change({pieces: value.pieces.map((piece) => (piece.key === key ? {...piece, ...part} : piece))});
  const add = (category: string, name: string) => {
    look_for("");
    change({pieces: [...value.pieces, {key: fresh_key(), category, name, count: "1", w: "", d: "", h: ""}]});
  };
  const own = search.trim();
  const on_key = (event: KeyboardEvent) => {
    if (event.key !== "Enter") return;
    event.preventDefault();
    const first = found?.[0];
    if (first) add(first.id, first.name);
    else if (own) add(own.toLowerCase(), own);
  };
  return (
    <fieldset>
      <legend>{form.furniture}</legend>
      {value.pieces.length > 0 && (
        <ul class="pieces">
          {value.pieces.map((piece) => (
            <li key={piece.key}>
              <b>{piece.name}</b>
              <label class="field count"><span>{form.count}</span><input type="number" min="1" max="100" value={piece.count} onInput={(event) => put(piece.key, {count: event.currentTarget.value})} /></label>
              {(["w", "d", "h"] as const).map((side, i) => (
                <label class="field">
                  <span>{[form.width, form.depth, form.height][i]}</span>
                  <input value={piece[side]} placeholder={form.usual} onInput={(event) => put(piece.key, {[side]: event.currentTarget.value})} />
                </label>
              ))}
              <Tool name="remove" label={`${form.remove}: ${piece.name}`} id={`form-remove-${piece.key}`} on={() => change({pieces: value.pieces.filter((one) => one !== piece)})} />
            </li>
          ))}
        </ul>
      )}
      <label class="field wide">
        <span>{form.search}</span>
        <input type="search" value={search} placeholder={texts.things.add_placeholder} data-testid="form-search" onInput={(event) => look_for(event.currentTarget.value)} onKeyDown={on_key} />
      </label>
      {own && (
        <ul class="articles">
          {(found ?? []).map((article) => (
            <li><button type="button" data-testid={`form-add-${article.id}`} onClick={() => add(article.id, article.name)}><Icon name="plus" /><span>{article.name}</span><small>{size_text(article.size, units)}</small></button></li>
          ))}
          <li><button type="button" data-testid="form-own" onClick={() => add(own.toLowerCase(), own)}><Icon name="plus" /><span>{own}</span><small>{form.own}</small></button></li>
        </ul>
      )}
    </fieldset>
  );
}
