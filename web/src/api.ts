// The service's calls, as in openapi.json. A refusal is thrown as `Refused` with the service's own error object.
import type {
  Article, CatalogAnswer, DragRequest, Dragged, EditRequest, Edited, Error as ErrorBody, ExportRequest, GenerateRequest, HealthAnswer, Job,
  KeepRoomRequest, KeptRoom, Layout, RelationsAnswer, RemediesAnswer, RemediesRequest, Report, Room, RoomsAnswer, SolveAnswer, SolveRequest, StartJobRequest,
} from "./gen/types";
import {texts} from "./texts";

export class Refused extends Error {
  constructor(readonly body: ErrorBody, readonly status: number) {
    super(body.message);
  }
}

const kToken = "layoutbox.token";

/** A token in the address (#token=…) is kept for this tab and taken out of the address. */
export function take_token(): void {
  const found = /[#&]token=([^&]+)/.exec(location.hash);
  if (!found) return;
  sessionStorage.setItem(kToken, decodeURIComponent(found[1] as string));
  history.replaceState(null, "", location.pathname);
}

async function ask(method: string, path: string, body?: unknown, signal?: AbortSignal, accept?: string): Promise<Response> {
  const headers: Record<string, string> = accept ? {Accept: accept} : {};
  if (body !== undefined) headers["Content-Type"] = "application/json";
  const token = sessionStorage.getItem(kToken);
  if (token) headers["Authorization"] = `Bearer ${token}`;
  let answer: Response;
  try {
    answer = await fetch(path, {method, headers, ...(body === undefined ? {} : {body: JSON.stringify(body)}), ...(signal ? {signal} : {})});
  } catch (error) {
    if (signal?.aborted) throw error;
    throw new Refused({code: "unreachable", message: texts.errors.unreachable}, 0);
  }
  if (answer.ok) return answer;
  const told = await answer.json().catch(() => null);
  throw new Refused(told?.message ? told : {code: String(answer.status), message: texts.errors.status(answer.status)}, answer.status);
}

/** Server-sent events of an answer, read by fetch so that a token and a body can be sent. */
async function* events_of(answer: Response): AsyncGenerator<{name: string; data: string}> {
  const reader = answer.body?.pipeThrough(new TextDecoderStream()).getReader();
  let rest = "";
  while (reader) {
    const {value, done} = await reader.read();
    if (done) return;
    const events = (rest + value).split(/\r?\n\r?\n/);
    rest = events.pop() ?? "";
    for (const event of events) {
      const lines = event.split(/\r?\n/);
      const values = (field: string) => lines.filter((line) => line.startsWith(`${field}:`)).map((line) => line.slice(field.length + 2));
      const data = values("data");
      if (data.length > 0) yield {name: values("event")[0] ?? "message", data: data.join("\n")};
    }
  }
}

/** Told as a stage begins, and how much of it is done: 0 to 1. */
export type OnStage = (stage: string, share?: number) => void;

/** A call that tells of its stages while it works, and that the service ends where the signal does. */
async function staged<T>(path: string, body: unknown, signal: AbortSignal | undefined, on_stage: OnStage): Promise<T> {
  const answer = await ask("POST", path, body, signal, "text/event-stream");
  let stage = "solve";
  for await (const {name, data} of events_of(answer)) {
    if (name === "stage") on_stage(stage = data);
    if (name === "progress") on_stage(stage, Number(data));
    if (name === "answer") return JSON.parse(data) as T;
    if (name === "refusal") throw new Refused(JSON.parse(data) as ErrorBody, 422);
  }
  throw new Refused({code: "unreachable", message: texts.errors.unreachable}, 0);
}

const json = async <T>(method: string, path: string, body?: unknown, signal?: AbortSignal): Promise<T> =>
  (await ask(method, path, body, signal)).json() as Promise<T>;

export const api = {
  generate: (body: GenerateRequest, signal: AbortSignal, on_stage: OnStage) => staged<Room>("/api/generate", body, signal, on_stage),
  solve: (body: SolveRequest, signal: AbortSignal, on_stage: OnStage) => staged<SolveAnswer>("/api/solve", body, signal, on_stage),
  /** Changes to a scene that would do, for a room that gave something up. */
  remedies: (body: RemediesRequest, signal: AbortSignal) =>
    staged<RemediesAnswer>("/api/remedies", body, signal, () => undefined).then((answer) => answer.ways),
  edit: (body: EditRequest, signal: AbortSignal, on_stage: OnStage) => staged<Edited>("/api/edit", body, signal, on_stage),
  drag: (body: DragRequest, signal?: AbortSignal) => json<Dragged>("POST", "/api/drag", body, signal),
  verify: (layout: Layout) => json<Report>("POST", "/api/verify", {layout}),
  export: async (body: ExportRequest, signal?: AbortSignal) => (await ask("POST", "/api/export", body, signal)).blob(),
  catalog: (search: string, limit: number): Promise<Article[]> =>
    json<CatalogAnswer>("GET", `/api/catalog?${new URLSearchParams({search, limit: String(limit)})}`).then((answer) => answer.articles),
  relations: () => json<RelationsAnswer>("GET", "/api/relations").then((answer) => answer.relations),
  health: () => json<HealthAnswer>("GET", "/api/health"),
  rooms: () => json<RoomsAnswer>("GET", "/api/rooms").then((answer) => answer.rooms),
  room: (id: string) => json<KeptRoom>("GET", `/api/rooms/${id}`),
  keep: (body: KeepRoomRequest) => json<KeptRoom>("POST", "/api/rooms", body),
  forget: async (id: string) => void (await ask("DELETE", `/api/rooms/${id}`)),
  start: (body: StartJobRequest) => json<Job>("POST", "/api/jobs", body),
  job: (id: string) => json<Job>("GET", `/api/jobs/${id}`),
  cancel: (id: string) => json<Job>("DELETE", `/api/jobs/${id}`),
  file: async (id: string, name: string) => (await ask("GET", `/api/jobs/${id}/files/${name}`)).blob(),
  /** Ends with the job. */
  async follow(id: string, on_job: (job: Job) => void, signal: AbortSignal): Promise<void> {
    const answer = await ask("GET", `/api/jobs/${id}/events`, undefined, signal);
    for await (const {data} of events_of(answer)) on_job(JSON.parse(data) as Job);
  },
};
