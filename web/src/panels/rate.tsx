// Rooms rated by people: a picture after the other, one to ten, and why. Files stay in the browser; a table comes out.
import {useEffect, useLayoutEffect, useMemo, useRef, useState} from "preact/hooks";
import {Icon} from "../icons";
import {type Rating, type RoomFiles, mixed, ratings_csv, rooms_of} from "../pure/ratings";
import {save} from "../save";
import {set} from "../state/store";
import {texts} from "../texts";

const kScores = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10] as const;
const kKept = "layoutbox.ratings";

function kept(): Record<string, Rating> {
  try {
    return JSON.parse(sessionStorage.getItem(kKept) ?? "{}") as Record<string, Rating>;
  } catch {
    return {};
  }
}

function Picture({file, label}: {file: File; label: string}) {
  const url = useMemo(() => URL.createObjectURL(file), [file]);
  useEffect(() => () => URL.revokeObjectURL(url), [url]);
  return <img src={url} alt={label} />;
}

function usePrompt(room: RoomFiles<File> | undefined): string {
  const [prompt, put] = useState("");
  useEffect(() => {
    let current = true;
    put("");
    void room?.layout?.text().then((text) => {
      const told = (JSON.parse(text) as {prompt?: string}).prompt ?? "";
      if (current) put(told);
    }).catch(() => undefined);
    return () => {
      current = false;
    };
  }, [room]);
  return prompt;
}

function Choose({on}: {on: (rooms: RoomFiles<File>[]) => void}) {
  const {rate} = texts;
  const [none, tell] = useState(false);
  const take = (input: HTMLInputElement) => {
    const files = [...(input.files ?? [])].map((file) => ({path: file.webkitRelativePath || file.name, file}));
    const rooms = mixed(rooms_of(files));
    tell(rooms.length === 0);
    if (rooms.length > 0) on(rooms);
  };
  return (
    <>
      <p class="quiet">{rate.explain}</p>
      <p class="outs">
        <label class="button file">
          <Icon name="file" />{rate.folder}
          <input type="file" class="unseen" data-testid="rate-folder" multiple {...{webkitdirectory: true}} onChange={(event) => take(event.currentTarget)} />
        </label>
        <label class="button file">
          <Icon name="file" />{rate.pictures}
          <input type="file" class="unseen" data-testid="rate-pictures" multiple accept="image/*" onChange={(event) => take(event.currentTarget)} />
        </label>
      </p>
      {none && <p class="bad" role="alert">{rate.none}</p>}
    </>
  );
}

function One({room, rating, put}: {room: RoomFiles<File>; rating: Rating | undefined; put: (rating: Rating) => void}) {
  const {rate} = texts;
  const prompt = usePrompt(room);
  const now: Rating = {...(rating ?? {id: room.id, score: 0, kind: "", reason: ""}), prompt: prompt || rating?.prompt || ""};
  return (
    <>
      {now.prompt && <blockquote data-testid="rate-prompt">{now.prompt}</blockquote>}
      <div class="pictures">{room.pictures.map((file) => <Picture key={file.name} file={file} label={rate.alt(file.name)} />)}</div>
      <fieldset class="scores">
        <legend>{rate.question}</legend>
        {kScores.map((score) => (
          <button key={score} type="button" class="small" aria-pressed={now.score === score} data-testid={`score-${score}`} onClick={() => put({...now, score})}>{score}</button>
        ))}
        <small>{rate.scale}</small>
      </fieldset>
      <div class="fields">
        <label class="field"><span>{rate.kind}</span>
          <select value={now.kind} data-testid="rate-kind" onChange={(event) => put({...now, kind: event.currentTarget.value})}>
            {Object.entries(rate.kinds).map(([kind, text]) => <option value={kind}>{text}</option>)}
          </select>
        </label>
        <label class="field"><span>{rate.reason}</span>
          <input value={now.reason} maxLength={500} data-testid="rate-reason" onInput={(event) => put({...now, reason: event.currentTarget.value})} />
        </label>
      </div>
    </>
  );
}

export function Rate() {
  const {rate} = texts;
  const [rooms, open] = useState<RoomFiles<File>[]>([]);
  const [at, go] = useState(0);
  const [ratings, put_all] = useState(kept);
  const room = rooms[at];
  const main = useRef<HTMLElement>(null);
  const done = rooms.filter((one) => (ratings[one.id]?.score ?? 0) > 0);
  const put = (rating: Rating) => put_all((now) => {
    const next = {...now, [rating.id]: rating};
    try {
      sessionStorage.setItem(kKept, JSON.stringify(next));
    } catch { /* a browser that keeps nothing */ }
    return next;
  });
  // With the picture, not after it: a key is meant for the room that is seen.
  useLayoutEffect(() => {
    const on_key = (event: KeyboardEvent) => {
      if (!room || event.ctrlKey || event.metaKey || event.altKey || event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement) return;
      const score = event.key === "0" ? 10 : Number(event.key);
      if (score >= 1 && score <= 10) put({...(ratings[room.id] ?? {id: room.id, kind: "", reason: "", prompt: ""}), score});
      else if (event.key === "ArrowRight") go(Math.min(rooms.length - 1, at + 1));
      else if (event.key === "ArrowLeft") go(Math.max(0, at - 1));
    };
    addEventListener("keydown", on_key);
    return () => removeEventListener("keydown", on_key);
  });
  // A button that is switched off would keep the focus, and the keys with it.
  useLayoutEffect(() => main.current?.focus({preventScroll: true}), [at, room]);
  const take = () => save(new Blob([ratings_csv(done.map((one) => ratings[one.id] as Rating))], {type: "text/csv"}), "ratings.csv");
  return (
    <main ref={main} id="room" class="rate" data-testid="rate" tabIndex={-1}>
      <header>
        <h1>{rate.heading}</h1>
        <button type="button" class="tool" aria-label={rate.close} data-testid="rate-close" onClick={() => set({rating: false})}><Icon name="close" /></button>
      </header>
      {!room ? <Choose on={open} /> : (
        <>
          <One key={room.id} room={room} rating={ratings[room.id]} put={put} />
          <footer>
            <button type="button" class="small" disabled={at === 0} onClick={() => go(at - 1)}>{rate.back}</button>
            <span data-testid="rate-count">{rate.count(at + 1, rooms.length, done.length)}</span>
            <button type="button" class="main" disabled={at + 1 === rooms.length} data-testid="rate-next" onClick={() => go(at + 1)}>{rate.next}</button>
            <button type="button" class="small" disabled={done.length === 0} data-testid="rate-save" onClick={take}>{rate.save}</button>
          </footer>
        </>
      )}
    </main>
  );
}
