// The pane of the 3D view: keeps it in step with the state, turns pointers into picks and drags.
import {useEffect, useMemo, useRef, useState} from "preact/hooks";
import {api} from "../api";
import {Icon} from "../icons";
import type {Layout} from "../gen/types";
import {references} from "../pure/relations";
import {type Where, follow} from "../pointer";
import {names_of, shape_key} from "../pure/scenes";
import {size_text} from "../pure/units";
import {Hand} from "../state/hand";
import {show_error} from "../state/actions";
import {doc, get, set, use} from "../state/store";
import {texts} from "../texts";
import {Handles3D} from "./handles3d";
import {RoomView} from "./room_view";
import {type Go, go_of_key} from "./walker";

function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim() || "#0f766e";
}

/** A press on a thing drags it over the floor; elsewhere the orbit has it. */
function press(view: RoomView, event: PointerEvent): void {
  if (view.walker || event.button > 0 || !event.isPrimary) return;
  const id = view.pick(event.clientX, event.clientY);
  const now = doc();
  const object = now?.layout.objects.find((one) => one.id === id);
  const touch_first = event.pointerType === "touch" && get().selected !== id;
  const held = object !== undefined && !now?.locked.includes(object.id) && !touch_first;
  const where: Where = ({clientX, clientY}) => view.aim.at_height(clientX, clientY, object?.pos[2] ?? 0);
  const from = where(event);
  const hand = now && held && from ? new Hand(now.layout, object.id) : null;
  if (hand) view.controls.enabled = false;
  follow(event, view.canvas, where, (at) => {
    if (hand && object && from) hand.move({pos: [object.pos[0] + at[0] - from[0], object.pos[1] + at[1] - from[1]]});
  }, (how) => {
    view.controls.enabled = !view.walker;
    if (how === "click") set({selected: id, relation: null, refused: null});
    if (how === "drop") void hand?.drop();
    else hand?.cancel();
  });
}

function Tip({layout, at}: {layout: Layout; at: {x: number; y: number; id: string} | null}) {
  const units = use((state) => state.units);
  const names = useMemo(() => names_of(layout), [layout]);
  const object = layout.objects.find((one) => one.id === at?.id);
  if (!at || !object) return null;
  return (
    <div class="tip" style={{left: `${at.x}px`, top: `${at.y}px`}} data-testid="tip">
      <b>{names.get(object.id)}</b> {size_text(object.size, units)}
    </div>
  );
}

function WalkPad({view}: {view: () => RoomView | null}) {
  const pad = (go: Go, label: string, sign: string) => (
    <button
      type="button" class={`pad ${go}`} aria-label={label}
      onPointerDown={() => view()?.walker?.go(go, true)} onPointerUp={() => view()?.walker?.go(go, false)}
      onPointerLeave={() => view()?.walker?.go(go, false)}
    >
      {sign}
    </button>
  );
  const {walk} = texts.views;
  return <div class="pads">{pad("left", walk.left, "↶")}{pad("forward", walk.forward, "↑")}{pad("back", walk.back, "↓")}{pad("right", walk.right, "↷")}</div>;
}

export function View3D({layout, live}: {layout: Layout; live: boolean}) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const pane = useRef<HTMLDivElement>(null);
  const view = useRef<RoomView | null>(null);
  const [state, put] = useState<"loading" | "ready" | "failed" | "none">("loading");
  const [tip, show_tip] = useState<{x: number; y: number; id: string} | null>(null);
  const {selected, hovered, relation, preview, ghost, walking, theme} = use((now) => now);
  const key = useMemo(() => shape_key(preview ? get().rooms.now?.layout ?? layout : layout), [layout, preview === null]);

  useEffect(() => {
    try {
      view.current = new RoomView(canvas.current as HTMLCanvasElement);
    } catch {
      put("none");
      return undefined;
    }
    const watch = new ResizeObserver(() => {
      const box = pane.current?.getBoundingClientRect();
      if (box) view.current?.size(box.width, box.height);
    });
    watch.observe(pane.current as HTMLDivElement);
    return () => {
      watch.disconnect();
      view.current?.dispose();
      view.current = null;
    };
  }, []);

  useEffect(() => {
    const ended = new AbortController();
    view.current?.hold();
    void (async () => {
      try {
        const blob = await api.export({layout, format: "glb"}, ended.signal);
        const glb = await blob.arrayBuffer();
        if (ended.signal.aborted) return;
        await view.current?.load(glb, layout);
        put((now) => (now === "none" ? now : "ready"));
      } catch (error) {
        if (ended.signal.aborted) return;
        view.current?.release();
        put((now) => (now === "none" ? now : "failed"));
        show_error(error);
      }
    })();
    return () => ended.abort();
  }, [key]);

  useEffect(() => view.current?.place(layout), [layout]);

  useEffect(() => {
    const found = live && relation ? layout.relations?.find((one) => one.id === relation) : undefined;
    view.current?.mark({
      selected: live ? selected : null, hovered: live ? hovered : null, illegal: preview?.legal === false,
      about: found ? [...found.targets, ...references(found)] : [],
      colours: {accent: colour("--accent"), wrong: colour("--wrong"), about: colour("--about")},
    });
  }, [layout, selected, hovered, relation, preview, theme, state]);

  useEffect(() => {
    if (!live) return;
    const before = new Map(layout.objects.map((object) => [object.id, JSON.stringify([object.pos, object.rotation, object.size])]));
    const changed = ghost?.layout.objects.filter((object) => before.get(object.id) !== JSON.stringify([object.pos, object.rotation, object.size])) ?? [];
    view.current?.ghost(changed, colour("--accent"));
  }, [ghost, layout]);

  useEffect(() => {
    if (!live || state !== "ready") return undefined;
    view.current?.walk(walking);
    if (!walking) return undefined;
    canvas.current?.focus();
    const key_of = (on: boolean) => (event: KeyboardEvent) => {
      const go = go_of_key(event.key);
      const typing = event.target instanceof HTMLInputElement || event.target instanceof HTMLTextAreaElement;
      if (event.key === "Escape") set({walking: false});
      if (!go || typing || event.ctrlKey || event.metaKey) return;
      view.current?.walker?.go(go, on);
      event.preventDefault();
    };
    const [down, up] = [key_of(true), key_of(false)];
    addEventListener("keydown", down);
    addEventListener("keyup", up);
    return () => {
      removeEventListener("keydown", down);
      removeEventListener("keyup", up);
    };
  }, [walking, state]);

  const on_move = (event: PointerEvent) => {
    if (event.buttons || !view.current || walking) return show_tip(null);
    const id = view.current.pick(event.clientX, event.clientY);
    const box = pane.current!.getBoundingClientRect();
    show_tip(id ? {x: event.clientX - box.left, y: event.clientY - box.top, id} : null);
    if (live && id !== get().hovered) set({hovered: id});
    canvas.current!.style.cursor = id ? "grab" : "";
  };
  return (
    <div ref={pane} class="three" data-testid={live ? "view3d" : "view3d-other"} data-state={state}>
      <canvas
        ref={canvas} tabIndex={0} role="img" aria-label={texts.views.three}
        onPointerDown={(event) => live && view.current && press(view.current, event)} onPointerMove={on_move}
        onPointerLeave={() => { show_tip(null); if (live && get().hovered) set({hovered: null}); }}
      />
      {live && state === "ready" && !walking && !ghost && <Handles3D layout={layout} view={() => view.current} />}
      <Tip layout={layout} at={tip} />
      {live && walking && <WalkPad view={() => view.current} />}
      {state === "loading" && <p class="over">{texts.views.loading}</p>}
      {state === "none" && <p class="over">{texts.errors.no_webgl}</p>}
      {state === "ready" && !walking && (
        <button type="button" class="tool corner" title={texts.views.reset} aria-label={texts.views.reset} onClick={() => view.current?.reset()}><Icon name="orbit" /></button>
      )}
    </div>
  );
}
