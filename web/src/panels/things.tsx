// Adding from the catalogue or by hand, and the table of all things.
import {useEffect, useState} from "preact/hooks";
import {Icon} from "../icons";
import {api} from "../api";
import type {Article} from "../gen/types";
import {upright} from "../pure/geometry";
import {names_of} from "../pure/scenes";
import {length_value, read_length, size_text} from "../pure/units";
import {add, add_article, add_opening} from "../state/actions";
import {set, shown, use} from "../state/store";
import {texts} from "../texts";

const kFew = 8;

/** What the catalogue has for a word; asks when the typing rests. */
export function useCatalog(search: string): Article[] | null {
  const [found, put] = useState<Article[] | null>(null);
  useEffect(() => {
    if (!search.trim()) {
      put(null);
      return undefined;
    }
    let current = true;
    const timer = setTimeout(() => {
      api.catalog(search.trim(), kFew).then((articles) => current && put(articles)).catch(() => current && put([]));
    }, 120);
    return () => {
      current = false;
      clearTimeout(timer);
    };
  }, [search]);
  return found;
}

function Own({name}: {name: string}) {
  const units = use((state) => state.units);
  const [called, call] = useState(name);
  const [sides, put] = useState(["", "", ""]);
  useEffect(() => call(name), [name]);
  const read = sides.map((side) => read_length(side, units));
  const good = called.trim() && read.every((side) => side !== null && side > 0 && side <= 50);
  const labels = [texts.thing.width, texts.thing.depth, texts.thing.height];
  const go = (event: Event) => {
    event.preventDefault();
    const [w, d, h] = read as number[];
    if (good) void add({category: called.trim().toLowerCase(), name: called.trim(), dims: {w: w as number, d: d as number, h: h as number, source: "user"}});
  };
  return (
    <form class="fields own" onSubmit={go}>
      <label class="field"><span>{texts.things.own_name}</span><input value={called} data-testid="own-name" onInput={(event) => call(event.currentTarget.value)} /></label>
      {labels.map((label, i) => (
        <label class="field">
          <span>{label}</span>
          <input value={sides[i]} data-testid={`own-${i}`} onInput={(event) => put(sides.map((side, k) => (k === i ? event.currentTarget.value : side)))} />
        </label>
      ))}
      <button type="submit" class="small" disabled={!good} data-testid="own-add">{texts.things.own_add}</button>
    </form>
  );
}

function Add() {
  const units = use((state) => state.units);
  const [search, look_for] = useState("");
  const found = useCatalog(search);
  return (
    <section>
      <h3><label for="add-search">{texts.things.add}</label></h3>
      <input
        id="add-search" type="search" class="wide" value={search} placeholder={texts.things.add_placeholder} data-testid="add-search"
        onInput={(event) => look_for(event.currentTarget.value)}
      />
      {found && found.length > 0 && (
        <ul class="articles">
          {found.map((article) => (
            <li>
              <button type="button" data-testid={`add-${article.id}`} onClick={() => { look_for(""); void add_article(article); }}>
                <Icon name="plus" /><span>{article.name}</span><small>{size_text(article.size, units)}</small>
              </button>
            </li>
          ))}
        </ul>
      )}
      {found?.length === 0 && <p class="quiet">{texts.things.nothing}</p>}
      <details open={found?.length === 0}><summary>{texts.things.own}</summary><Own name={found?.length === 0 ? search : ""} /></details>
    </section>
  );
}

export function Things() {
  const layout = use(shown);
  const selected = use((state) => state.selected);
  const units = use((state) => state.units);
  const locked = use((state) => state.rooms.now?.locked);
  if (!layout) return null;
  const names = names_of(layout);
  const {columns} = texts.things;
  return (
    <>
      <Add />
      <section>
        <h3>{texts.openings.heading}</h3>
        <p class="outs">
          {(["door", "window", "open"] as const).map((type) => (
            <button key={type} type="button" class="small plus" aria-label={texts.openings.adds(texts.openings.add[type])} data-testid={`add-${type}`} onClick={() => void add_opening(type)}><Icon name="plus" />{texts.openings.add[type]}</button>
          ))}
        </p>
      </section>
      <section>
        <h3>{texts.things.table} <small>({layout.objects.length})</small></h3>
        <div class="scroll">
          <table data-testid="things">
            <thead><tr><th>{columns.name}</th><th>{columns.size}</th><th>{columns.place}</th><th>{columns.turn}</th></tr></thead>
            <tbody>
              {layout.objects.map((object) => (
                <tr class={object.id === selected ? "chosen" : ""} onPointerEnter={() => set({hovered: object.id})} onPointerLeave={() => set({hovered: null})}>
                  <td>
                    <button type="button" class="bare" aria-pressed={object.id === selected} onClick={() => set({selected: object.id, relation: null})}>{names.get(object.id)}</button>
                    {locked?.includes(object.id) && <Icon name="lock" />}
                  </td>
                  <td class="number">{object.size.map((side) => length_value(side, units)).join("×")}</td>
                  <td class="number">{object.pos.slice(0, object.pos[2] > 0 ? 3 : 2).map((side) => length_value(Math.round(side * 100) / 100, units)).join(", ")}</td>
                  <td class="number">{Math.round(upright(object.rotation))}°</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      </section>
    </>
  );
}
