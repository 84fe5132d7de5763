// Relations of the form, chosen from the service's table.
import {Tool} from "../bar";
import {type FormRelation, type FormValue, opening_ids, things_of, wall_ids} from "../pure/form_scene";
import {use} from "../state/store";
import {texts} from "../texts";
import {fresh_key} from "./pieces";

interface Part { value: FormValue; change: (part: Partial<FormValue>) => void }

/** Things to choose from: each, and all of a kind together. */
function choices(value: FormValue): [string, string][] {
  const things = things_of(value.pieces);
  const groups = value.pieces.flatMap((piece): [string, string][] => {
    const ids = things.filter((thing) => thing.piece === piece).map((thing) => thing.id);
    return ids.length > 1 ? [[ids.join(","), `${piece.name} 1–${ids.length}`]] : [];
  });
  return [...groups, ...things.map((thing): [string, string] => [thing.id, thing.name])];
}

export function Relations({value, change}: Part) {
  const sentences = use((state) => state.sentences);
  const {form, places} = texts;
  const things = choices(value);
  const put = (key: number, part: Partial<FormRelation>) =>
    change({relations: value.relations.map((one) => (one.key === key ? {...one, ...part} : one))});
  const named = (sentence: string) => sentence.replace("{targets}", "…").replace("{references}", "…").replace(/\{(\w+)\}/g, "$1");
  const ids = opening_ids(value.openings);
  const others: [string, string][] = [
    ...things,
    ...wall_ids(value).map((id, i): [string, string] => [id, value.outline ? places.wall_number(i + 1) : places.wall(form.walls[id] ?? id)]),
    ...ids.map((id): [string, string] => [id, id.replace(/(\d+)$/, " $1")]),
  ];
  return (
    <fieldset>
      <legend>{form.relations}</legend>
      <ul class="pieces">
        {value.relations.map((one) => (
          <li key={one.key}>
            <label class="field"><span>{form.subject}</span>
              <select value={one.subject} onChange={(event) => put(one.key, {subject: event.currentTarget.value})}>
                {things.map(([id, name]) => <option value={id}>{name}</option>)}
              </select>
            </label>
            <label class="field wide"><span>{form.relation}</span>
              <select value={one.type} onChange={(event) => put(one.key, {type: event.currentTarget.value})}>
                {[...sentences].map(([name, {sentence}]) => <option value={name}>{named(sentence)}</option>)}
              </select>
            </label>
            <label class="field"><span>{form.object}</span>
              <select value={one.reference} onChange={(event) => put(one.key, {reference: event.currentTarget.value})}>
                <option value="">–</option>
                {others.filter(([id]) => id !== one.subject).map(([id, name]) => <option value={id}>{name}</option>)}
              </select>
            </label>
            <Tool name="remove" label={form.remove} id={`form-remove-${one.key}`} on={() => change({relations: value.relations.filter((other) => other !== one)})} />
          </li>
        ))}
      </ul>
      <p class="outs">
        <button
          type="button" class="small" data-testid="form-relation" disabled={things.length === 0 || sentences.size === 0}
          onClick={() => change({relations: [...value.relations, {key: fresh_key(), type: sentences.has("againstWall") ? "againstWall" : [...sentences.keys()][0] ?? "", subject: things[0]?.[0] ?? "", reference: ""}]})}
        >
          {form.add_relation}
        </button>
      </p>
    </fieldset>
  );
}
