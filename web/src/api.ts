// The service's calls, as in openapi.json. A refusal is thrown as `Refused` with the service's own error object.
import type {
  Article, CatalogAnswer, DragRequest, Dragged, EditRequest, Edited, Error as ErrorBody, ExportRequest, GenerateRequest, HealthAnswer, Job,
  KeepRoomRequest, KeptRoom, Layout, RelationsAnswer, Report, Room, RoomsAnswer, SolveAnswer, SolveRequest, StartJobRequest,
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

async function ask(method: string, path: string, body?: unknown, signal?: AbortSignal): Promise<Response> {
  const headers: Record<string, string> = {};
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

const json = async <T>(method: string, path: string, body?: unknown, signal?: AbortSignal): Promise<T> =>
  (await ask(method, path, body, signal)).json() as Promise<T>;

export const api = {
  generate: (body: GenerateRequest, signal?: AbortSignal) => json<Room>("POST", "/api/generate", body, signal),
  solve: (body: SolveRequest, signal?: AbortSignal) => json<SolveAnswer>("POST", "/api/solve", body, signal),
  edit: (body: EditRequest, signal?: AbortSignal) => json<Edited>("POST", "/api/edit", body, signal),
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
  /** Server-sent events read by fetch, so that a token can be sent; ends with the job. */
  async follow(id: string, on_job: (job: Job) => void, signal: AbortSignal): Promise<void> {
    const answer = await ask("GET", `/api/jobs/${id}/events`, undefined, signal);
    const reader = answer.body?.pipeThrough(new TextDecoderStream()).getReader();
    let rest = "";
    while (reader) {
      const {value, done} = await reader.read();
      if (done) return;
      const events = (rest + value).split(/\r?\n\r?\n/);
      rest = events.pop() ?? "";
      for (const event of events) {
        const data = event.split(/\r?\n/).filter((line) => line.startsWith("data:")).map((line) => line.slice(5).trim());
        if (data.length > 0) on_job(JSON.parse(data.join("\n")) as Job);
      }
    }
  },
};
