// The box for a room's description: on the first page with examples, later in the head.
import {useEffect, useRef, useState} from "preact/hooks";
import {Icon} from "./icons";
import {furnish, stop} from "./state/actions";
import {open_file} from "./state/session";
import {set, use} from "./state/store";
import {texts} from "./texts";

const kLongest = 20000;

/** `empty` starts a new text, whatever the room on the screen was asked for with. */
export function Prompt({large = false, empty = false}: {large?: boolean; empty?: boolean}) {
  const current = use((state) => (empty ? "" : state.rooms.now?.prompt ?? ""));
  const busy = use((state) => state.busy);
  const [text, put] = useState(current);
  const box = useRef<HTMLTextAreaElement>(null);
  useEffect(() => put(current), [current]);
  useEffect(() => {
    const area = box.current;
    if (!area) return undefined;
    const frame = requestAnimationFrame(() => {
      area.style.height = "auto";
      area.style.height = `${Math.min(area.scrollHeight + 2, large ? 220 : 66)}px`;
    });
    return () => cancelAnimationFrame(frame);
  }, [text, busy]);
  const go = (event?: Event) => {
    event?.preventDefault();
    if (text.trim()) void furnish(text.trim());
  };
  const on_key = (event: KeyboardEvent) => {
    if (event.key === "Enter" && !event.shiftKey && !event.isComposing) go(event);
  };
  return (
    <form class={large ? "prompt large" : "prompt"} onSubmit={go}>
      <textarea
        ref={box} rows={large ? 2 : 1} value={text} maxLength={kLongest} aria-label={texts.prompt.label} placeholder={texts.prompt.placeholder}
        data-testid="prompt" autofocus={large} onInput={(event) => put(event.currentTarget.value)} onKeyDown={on_key}
      />
      {busy
        ? <button type="button" class="main busy" data-testid="stop" onClick={stop} title={busy}>{texts.prompt.stop}</button>
        : <button type="submit" class="main" data-testid="furnish" disabled={!text.trim()}>{texts.prompt.go}</button>}
    </form>
  );
}

/** Who reads the words, where there is a choice. */
export function ReadBy() {
  const planner = use((state) => state.planner);
  const planners = use((state) => state.planners);
  if (planners.length < 2) return null;
  const {read_by, readers} = texts.prompt;
  return (
    <label class="read-by">
      {read_by}
      <select value={planner} data-testid="planner" onChange={(event) => set({planner: event.currentTarget.value as "offline" | "llm"})}>
        {planners.map((name) => <option value={name}>{readers[name] ?? name}</option>)}
      </select>
    </label>
  );
}

export function OpenFile({class: look = "link"}: {class?: string}) {
  return (
    <label class={`${look} file`}>
      <Icon name="file" />{texts.prompt.open_file}
      <input
        type="file" accept=".json,application/json" class="unseen" data-testid="open-file"
        onChange={(event) => {
          const file = event.currentTarget.files?.[0];
          event.currentTarget.value = "";
          if (file) void open_file(file);
        }}
      />
    </label>
  );
}

export function Start() {
  const busy = use((state) => state.busy);
  return (
    <main id="room" class="start" aria-busy={busy !== null}>
      <h1>{texts.prompt.hero}</h1>
      <p class="quiet">{texts.prompt.under}</p>
      <Prompt large />
      <h2>{texts.prompt.examples_label}</h2>
      <ul class="examples">
        {texts.prompt.examples.map((example, i) => (
          <li><button type="button" data-testid={`example-${i}`} onClick={() => void furnish(example)}>{example}</button></li>
        ))}
      </ul>
      <p class="ways">
        <button type="button" class="link" data-testid="open-form" onClick={() => set({form: true})}><Icon name="grid" />{texts.prompt.form}</button>
        <OpenFile />
        <ReadBy />
      </p>
    </main>
  );
}

