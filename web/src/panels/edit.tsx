// Changes in words: proposed as a ghost, then taken or left.
import {useState} from "preact/hooks";
import type {Change, Edited} from "../gen/types";
import {names_of} from "../pure/scenes";
import {type Units, length_text} from "../pure/units";
import {drop_ghost, propose, take_ghost} from "../state/actions";
import {use} from "../state/store";
import {texts} from "../texts";

export function EditBox() {
  const [text, put] = useState("");
  const busy = use((state) => state.busy);
  const go = (event: Event) => {
    event.preventDefault();
    if (text.trim()) void propose(text.trim()).then(() => put(""));
  };
  return (
    <form class="prompt edit" onSubmit={go}>
      <input
        value={text} maxLength={5000} aria-label={texts.edit.label} placeholder={`${texts.edit.label}: ${texts.edit.placeholder}`} data-testid="edit-text"
        onInput={(event) => put(event.currentTarget.value)}
      />
      <button type="submit" class="small" disabled={!text.trim() || busy !== null} data-testid="edit-go">{texts.edit.go}</button>
    </form>
  );
}

function change_text(change: Change, units: Units): string {
  const parts = change.what.map((what) => {
    if (what === "moved") return texts.edit.moved(length_text(change.metres, units));
    if (what === "turned") return texts.edit.turned(`${Math.abs(Math.round(change.degrees))}°`);
    return texts.edit.what[what];
  });
  return parts.join(", ");
}

function Changes({ghost}: {ghost: Edited}) {
  const units = use((state) => state.units);
  const now = use((state) => state.rooms.now);
  const names = new Map([...(now ? names_of(now.layout) : []), ...names_of(ghost.layout)]);
  return (
    <ul class="plain">
      {ghost.changes.length === 0 && <li class="quiet">{texts.edit.nothing}</li>}
      {ghost.changes.map((change) => (
        <li><b>{names.get(change.id) ?? change.id}</b> {change_text(change, units)}{!change.asked && <small> ({texts.edit.gives_way})</small>}</li>
      ))}
      {ghost.dropped.length > 0 && <li class="quiet">{texts.edit.dropped}: {ghost.dropped.join("; ")}</li>}
      {ghost.notes.map((note) => <li class="quiet">{note.message}</li>)}
    </ul>
  );
}

export function Proposal() {
  const ghost = use((state) => state.ghost);
  if (!ghost) return null;
  const changes = ghost.changes.length > 0;
  return (
    <section class="proposal" role="status" data-testid="proposal">
      <h2>{texts.edit.proposal}</h2>
      <Changes ghost={ghost} />
      <p class="outs">
        {changes && <button type="button" class="main" data-testid="ghost-take" onClick={take_ghost}>{texts.edit.take}</button>}
        <button type="button" class="small" data-testid="ghost-drop" onClick={drop_ghost}>{changes ? texts.edit.drop : texts.edit.close}</button>
      </p>
    </section>
  );
}
