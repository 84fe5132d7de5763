// The picture from Blender: a job with progress, which can be cancelled and survives a reload.
import {useEffect, useRef, useState} from "preact/hooks";
import {Refused, api} from "../api";
import type {Job, Layout, StartJobRequest} from "../gen/types";
import {save} from "../save";
import {show_error} from "../state/actions";
import {texts} from "../texts";

const kJob = "layoutbox.job";
const kAgain = 1000;
type Quality = NonNullable<StartJobRequest["quality"]>;
type View = NonNullable<StartJobRequest["views"]>[number];

const ended = (job: Job): boolean => job.state !== "waiting" && job.state !== "running";

export function Picture({layout}: {layout: Layout}) {
  const [quality, put_quality] = useState<Quality>("draft");
  const [view, put_view] = useState<View>("iso");
  const [job, put_job] = useState<Job | null>(null);
  const [pictures, put_pictures] = useState<{name: string; blob: Blob; url: string}[]>([]);
  const watching = useRef<AbortController | null>(null);

  const fetch_pictures = async (done: Job) => {
    const names = done.files.filter((name) => name.endsWith(".png"));
    const blobs = await Promise.all(names.map((name) => api.file(done.id, name)));
    put_pictures(blobs.map((blob, i) => ({name: names[i] as string, blob, url: URL.createObjectURL(blob)})));
  };
  /** Follows a job to its end; a connection that breaks is taken up again. */
  const watch = async (id: string) => {
    watching.current?.abort();
    const mine = new AbortController();
    watching.current = mine;
    let last: Job | null = null;
    while (!mine.signal.aborted) {
      try {
        await api.follow(id, (now) => { last = now; put_job(now); }, mine.signal);
        last ??= await api.job(id);
        if (ended(last)) break;
      } catch (error) {
        if (mine.signal.aborted) return;
        if (error instanceof Refused && error.status === 404) {
          sessionStorage.removeItem(kJob);
          return put_job(null);
        }
      }
      await new Promise((resolve) => setTimeout(resolve, kAgain));
    }
    if (last && (last as Job).state === "done") await fetch_pictures(last).catch(show_error);
  };
  useEffect(() => {
    const id = sessionStorage.getItem(kJob);
    if (id) void watch(id);
    return () => watching.current?.abort();
  }, []);
  const start = async () => {
    put_pictures([]);
    try {
      const begun = await api.start({kind: "render", layout, quality, views: [view]});
      sessionStorage.setItem(kJob, begun.id);
      put_job(begun);
      void watch(begun.id);
    } catch (error) {
      show_error(error);
    }
  };
  // That it ended is told by its events: the answer here may say that it runs, and come after them.
  const cancel = () => job && api.cancel(job.id).catch(show_error);
  const {files} = texts;
  const works = job !== null && !ended(job);
  return (
    <section data-testid="picture">
      <h3>{files.picture}</h3>
      <div class="fields">
        <label class="field">
          <span>{files.quality}</span>
          <select value={quality} disabled={works} data-testid="picture-quality" onChange={(event) => put_quality(event.currentTarget.value as Quality)}>
            {Object.entries(files.qualities).map(([value, name]) => <option value={value}>{name}</option>)}
          </select>
        </label>
        <label class="field">
          <span>{files.view}</span>
          <select value={view} disabled={works} data-testid="picture-view" onChange={(event) => put_view(event.currentTarget.value as View)}>
            {Object.entries(files.views).map(([value, name]) => <option value={value}>{name}</option>)}
          </select>
        </label>
      </div>
      {works && job ? (
        <div class="job">
          <progress value={job.progress} max={1} aria-label={files.picture} data-testid="picture-progress" />
          <span>{job.state === "waiting" ? files.waiting : files.progress(Math.round(job.progress * 100), job.stage ?? "")}</span>
          <button type="button" class="small" data-testid="picture-cancel" onClick={() => void cancel()}>{files.cancel}</button>
        </div>
      ) : <button type="button" class="small" data-testid="picture-start" onClick={() => void start()}>{files.draw}</button>}
      {job?.state === "cancelled" && <p class="quiet">{files.cancelled}</p>}
      {job?.state === "failed" && <p class="bad">{job.error?.message ?? files.failed}</p>}
      {pictures.map((picture) => (
        <figure>
          <img src={picture.url} alt={files.picture_alt} data-testid="picture-image" />
          <button type="button" class="link" onClick={() => save(picture.blob, picture.name)}>{files.save_picture}</button>
        </figure>
      ))}
    </section>
  );
}
