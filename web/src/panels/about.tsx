// What was understood: the words, the relations with tick or cross, what could not be, what the checks say.
import {useMemo} from "preact/hooks";
import {Icon} from "../icons";
import type {Layout, SceneRelation} from "../gen/types";
import {footprint, gap_between} from "../pure/geometry";
import {references, relation_text} from "../pure/relations";
import {names_of, with_names} from "../pure/scenes";
import {length_text} from "../pure/units";
import {named_in_role, pieces} from "../pure/words";
import {give_up} from "../state/actions";
import {set, shown, use} from "../state/store";
import {texts} from "../texts";
import {Remedies} from "./remedies";

type Held = SceneRelation & {held?: boolean};
interface Check { name: string; subject: string; passed: boolean; required: boolean; message: string }

const kFewOuts = 3;
const kOrigins = ["asked", "concluded", "added", "assumed"] as const;

function Words({layout}: {layout: Layout}) {
  const now = use((state) => state.rooms.now);
  const parts = useMemo(() => (now ? pieces(now.prompt, now.words) : []), [now?.prompt, now?.words]);
  const things = useMemo(() => new Set(layout.objects.map((object) => object.id)), [layout]);
  const relations = useMemo(() => new Set((layout.relations ?? []).flatMap((one) => one.id ?? [])), [layout]);
  if (!now?.prompt) return <p class="quiet">{texts.about.nothing_said}</p>;
  const missed = parts.filter((part) => part.word?.use === "notUnderstood").map((part) => part.text);
  return (
    <>
      <p class="words" data-testid="words">
        {parts.map(({text, word}) => {
          if (!word) return text;
          const thing = named_in_role(word.role, things);
          const relation = named_in_role(word.role, relations);
          const title = `${texts.about.uses[word.use]}: ${word.role}`;
          if (!thing && !relation) return <span class={word.use} title={title}>{text}</span>;
          const choose = () => set(relation ? {relation, selected: null} : {selected: thing, relation: null});
          return <button type="button" class={word.use} title={title} onClick={choose}>{text}</button>;
        })}
      </p>
      {missed.length > 0 && <p class="warn" data-testid="not-understood"><Icon name="warn" />{texts.about.not_understood}: {missed.join(", ")}</p>}
    </>
  );
}

function measured(relation: Held, layout: Layout): number | null {
  const subject = layout.objects.find((object) => object.id === relation.targets[0]);
  const id = references(relation)[0];
  const thing = layout.objects.find((object) => object.id === id);
  const wall = layout.room.walls?.find((one) => one.id === id);
  if (!subject || (!thing && !wall)) return null;
  return gap_between(footprint(subject), thing ? footprint(thing) : [wall!.start, wall!.end]).length;
}

function Relation({relation, layout}: {relation: Held; layout: Layout}) {
  const chosen = use((state) => state.relation === relation.id);
  const sentences = use((state) => state.sentences);
  const units = use((state) => state.units);
  const state = relation.held === undefined ? "unknown" : relation.held ? "held" : "not_held";
  const gap = chosen ? measured(relation, layout) : null;
  return (
    <li>
      <button
        type="button" class={`relation ${state}`} aria-pressed={chosen} data-testid={`relation-${relation.id}`}
        onClick={() => set(chosen ? {relation: null} : {relation: relation.id ?? null, selected: null})}
      >
        <span class="sign"><Icon name={relation.held === false ? "cross" : "tick"} /><span class="unseen">{texts.about[state]}</span></span>
        <span>{relation_text(relation, layout, sentences, units)}{gap !== null && <small> · {texts.about.measured(length_text(gap, units))}</small>}</span>
      </button>
    </li>
  );
}

function Relations({layout}: {layout: Layout}) {
  const all = (layout.relations ?? []) as Held[];
  if (all.length === 0) return <p class="quiet">{texts.about.no_relations}</p>;
  return (
    <>
      {kOrigins.map((origin) => {
        const some = all.filter((one) => (one.origin ?? "asked") === origin);
        if (some.length === 0) return null;
        const list = <ul class="relations">{some.map((one) => <Relation key={one.id} relation={one} layout={layout} />)}</ul>;
        if (origin === "asked" || origin === "concluded") return <><h3>{texts.about[origin]}</h3>{list}</>;
        return <details><summary>{texts.about[origin]} ({some.length})</summary>{list}</details>;
      })}
    </>
  );
}

/** A button for each relation that may be done without; the first few at once. */
function Outs({ids, text_of}: {ids: string[]; text_of: (id: string) => string}) {
  const button = (id: string) => (
    <button key={id} type="button" class="small" data-testid={`without-${id}`} onClick={() => void give_up(id)}>{texts.about.do_without(text_of(id))}</button>
  );
  const more = ids.slice(kFewOuts);
  return (
    <>
      <p class="outs">{ids.slice(0, kFewOuts).map(button)}</p>
      {more.length > 0 && <details><summary>{texts.about.more_outs(more.length)}</summary><p class="outs">{more.map(button)}</p></details>}
    </>
  );
}

function Conflicts({layout}: {layout: Layout}) {
  const sentences = use((state) => state.sentences);
  const units = use((state) => state.units);
  const scene = use((state) => state.rooms.now?.scene);
  const by_hand = use((state) => state.rooms.now?.by_hand ?? false);
  const names = useMemo(() => names_of(layout), [layout]);
  const conflicts = layout.conflicts ?? [];
  const text_of = (id: string) => {
    const found = layout.relations?.find((one) => one.id === id) ?? scene?.constraints?.find((one) => one.id === id);
    return found ? relation_text(found, layout, sentences, units) : id;
  };
  const known = (id: string) => layout.relations?.some((one) => one.id === id) || scene?.constraints?.some((one) => one.id === id);
  // What a hand has broken is crossed in the list of relations; nobody has to be told of it twice.
  const given_up = layout.relaxed?.filter((one) => !by_hand || !layout.relations?.some((relation) => relation.id === one.relation));
  return (
    <>
      {conflicts.length > 0 && (
        <section class="trouble" data-testid="conflicts">
          <h3>{texts.about.conflicts}</h3>
          {conflicts.map((conflict) => (
            <div>
              <p>{with_names(conflict.sentence, names)}</p>
              <Outs ids={(conflict.relations ?? []).filter(known)} text_of={text_of} />
            </div>
          ))}
        </section>
      )}
      <Remedies layout={layout} />
      {([["relaxed", given_up], ["gave_way", layout.gaveWay]] as const).map(([key, list]) => list && list.length > 0 && (
        <section class={key === "relaxed" && conflicts.length === 0 ? "trouble" : ""} data-testid={key}>
          <h3>{texts.about[key]}</h3>
          <ul class="plain">
            {list.map((one) => (
              <li>
                {known(one.relation) ? text_of(one.relation) : with_names(one.why ?? one.relation, names)}
                {one.by !== undefined && one.by > 0 && <small> · {texts.about.by(one.unit === "m" ? length_text(one.by, units) : `${Math.round(one.by * 100) / 100} ${one.unit ?? ""}`)}</small>}
              </li>
            ))}
          </ul>
        </section>
      ))}
    </>
  );
}

function Checks({layout}: {layout: Layout}) {
  const names = useMemo(() => names_of(layout), [layout]);
  const report = use((state) => state.rooms.now?.report);
  if (!report) return <p class="quiet">{texts.about.checking}</p>;
  const checks = (report["checks"] ?? []) as Check[];
  const failed = checks.filter((check) => !check.passed);
  const bad = failed.filter((check) => check.required);
  const remarks = failed.filter((check) => !check.required);
  const row = (check: Check) => (
    <li class={check.required ? "bad" : "quiet"}>
      <button type="button" class="bare" onClick={() => set({selected: check.subject, relation: null})}>{with_names(check.message, names)}</button>
    </li>
  );
  return (
    <>
      <p class={bad.length === 0 ? "good" : "bad"} data-testid="checks">
        <Icon name={bad.length === 0 ? "tick" : "cross"} />{bad.length === 0 ? texts.about.checks_passed(checks.length - failed.length) : texts.about.checks_failed}
      </p>
      {bad.length > 0 && <ul class="plain">{bad.map(row)}</ul>}
      {remarks.length > 0 && <details><summary>{texts.about.remarks(remarks.length)}</summary><ul class="plain">{remarks.map(row)}</ul></details>}
    </>
  );
}

/** The answer first: is it as it was asked for? */
function Verdict({layout}: {layout: Layout}) {
  const report = use((state) => state.rooms.now?.report);
  const by_hand = use((state) => state.rooms.now?.by_hand ?? false);
  const {about} = texts;
  if (!report) return null;
  const good = report["passed"] === true && (by_hand || layout.status === "solved");
  const text = by_hand ? about.changed : good ? about.as_asked : about.not_as_asked;
  return <p class={`verdict ${good ? "good" : "bad"}`} data-testid="verdict"><Icon name={good ? "tick" : "cross"} />{text}</p>;
}

export function About() {
  const layout = use(shown);
  const notes = use((state) => state.rooms.now?.notes) ?? [];
  if (!layout) return null;
  return (
    <>
      <Verdict layout={layout} />
      <section><h3>{texts.about.words}</h3><Words layout={layout} /></section>
      <Conflicts layout={layout} />
      <section><Relations layout={layout} /></section>
      <section><h3>{texts.about.checks}</h3><Checks layout={layout} /></section>
      {notes.length > 0 && (
        <details>
          <summary>{texts.about.notes(notes.length)}</summary>
          <ul class="plain">{notes.map((note) => <li>{note.message}</li>)}</ul>
        </details>
      )}
    </>
  );
}
