// A thing in the hand: shown at once where the hand is, while the service says what gives way.
import {Refused, api} from "../api";
import type {DragRequest, Dragged, Layout, LayoutObject} from "../gen/types";
import {on_grid, upright} from "../pure/geometry";
import {with_load} from "../pure/scenes";
import {put_opening} from "../pure/shell_moves";
import {texts} from "../texts";
import {Latest} from "./latest";
import {change_layout, doc, get, put_report, set} from "./store";

export interface Pose { pos?: [number, number]; rotation?: number; size?: [number, number, number] }

const kSnapReach = 0.15;
/** Milliseconds after which steps by keys are done. */
const kRest = 450;

/** The thing put at a pose, what it carries with it; nothing else moves. */
function posed(layout: Layout, id: string, pose: Pose): Layout {
  const object = layout.objects.find((one) => one.id === id);
  if (!object) return pose.pos ? put_opening(layout, id, pose.pos) : layout;
  const dx = (pose.pos?.[0] ?? object.pos[0]) - object.pos[0];
  const dy = (pose.pos?.[1] ?? object.pos[1]) - object.pos[1];
  const load = with_load(layout, id);
  return {
    ...layout,
    objects: layout.objects.map((one) => {
      if (!load.has(one.id)) return one;
      const pos: LayoutObject["pos"] = [one.pos[0] + dx, one.pos[1] + dy, one.pos[2]];
      return one.id === id ? {...one, pos, rotation: pose.rotation ?? one.rotation, size: pose.size ?? one.size} : {...one, pos};
    }),
  };
}

export class Hand {
  private pose_: Pose = {};
  private answer_: {ask: DragRequest; answer: Dragged} | null = null;
  private readonly asks_: Latest<DragRequest, Dragged>;

  /** `snaps` false: exact steps by keys and fields, whatever the switch says. */
  constructor(private readonly base_: Layout, readonly id: string, private readonly snaps_ = true) {
    this.asks_ = new Latest<DragRequest, Dragged>(
      (ask) => api.drag(ask),
      (answer, ask) => {
        this.answer_ = {ask, answer};
        this.show_();
      },
      (error) => set({error: {message: error instanceof Refused ? error.message : texts.errors.unexpected}}),
    );
  }

  get object(): LayoutObject | undefined {
    return this.base_.objects.find((object) => object.id === this.id);
  }

  move(change: Pose): void {
    const pose: Pose = {...this.pose_, ...change};
    if (pose.pos) pose.pos = [on_grid(pose.pos[0]), on_grid(pose.pos[1])];
    if (pose.rotation !== undefined) pose.rotation = upright(pose.rotation);
    this.pose_ = pose;
    this.show_();
    this.asks_.push({layout: this.base_, id: this.id, ...pose, locked: doc()?.locked ?? [], snap: this.snaps_ && get().snap && pose.pos !== undefined});
  }

  /** Lets go: taken when everything can stand so, else all is as before and the reason is shown. */
  async drop(): Promise<boolean> {
    await this.asks_.settled();
    const last = this.answer_;
    if (!last) {
      set({preview: null});
      return false;
    }
    if (!last.answer.legal) {
      set({preview: null, refused: {id: this.id, text: last.answer.reasons.map((reason) => reason.text).join("; ") || texts.hand.refused}});
      return false;
    }
    change_layout(last.answer.layout);
    void check(last.answer.layout);
    return true;
  }

  cancel(): void {
    set({preview: null});
  }

  /** What the last answer snapped to a wall stays there until the hand is out of reach. */
  private sticky_(): Pose {
    const last = this.answer_;
    const hand = this.pose_.pos;
    const asked = last?.ask.pos;
    if (!last?.answer.legal || !hand || !asked || !last.ask.snap) return this.pose_;
    const got: LayoutObject | undefined = last.answer.layout.objects.find((object) => object.id === this.id);
    if (!got) return this.pose_;
    const pos: [number, number] = [...hand];
    let held = false;
    for (const axis of [0, 1] as const) {
      const snapped = Math.abs(got.pos[axis] - (asked[axis] as number)) > 0.001;
      if (snapped && Math.abs(hand[axis] - got.pos[axis]) < kSnapReach) {
        pos[axis] = got.pos[axis];
        held = true;
      }
    }
    return held ? {...this.pose_, pos, rotation: got.rotation} : this.pose_;
  }

  private show_(): void {
    const last = this.answer_;
    const answered = last && JSON.stringify([last.ask.pos, last.ask.rotation, last.ask.size]) ===
      JSON.stringify([this.pose_.pos, this.pose_.rotation, this.pose_.size]);
    const legal = last?.answer.legal ?? true;
    const under = last?.answer.legal ? last.answer.layout : this.base_;
    const layout = answered && legal ? under : posed(under, this.id, this.sticky_());
    set({
      preview: {id: this.id, layout, legal, moved: last?.answer.moved ?? [], reasons: last?.answer.reasons ?? []},
      refused: null, ...(this.object ? {selected: this.id} : {}),
    });
  }
}

/** The checks of what is on the screen, when nothing else is to do. */
export async function check(layout: Layout): Promise<void> {
  try {
    put_report(layout, await api.verify(layout));
  } catch { /* the room stays usable without its report */ }
}

let nudging: {hand: Hand; timer: number} | null = null;

/** Small steps by keys: steps that follow each other quickly are one step of undo. */
function step_by_step(id: string, pose: (shown: Layout) => Pose | null): void {
  const now = doc();
  if (!now || now.locked.includes(id)) return;
  if (nudging && nudging.hand.id !== id) void settle();
  const hand = nudging?.hand ?? new Hand(now.layout, id, false);
  const change = pose((get().preview?.id === id && get().preview?.layout) || now.layout);
  if (!change) return;
  if (nudging) clearTimeout(nudging.timer);
  nudging = {hand, timer: window.setTimeout(() => void settle(), kRest)};
  hand.move(change);
}

export function nudge(id: string, change: (object: LayoutObject) => Pose): void {
  step_by_step(id, (layout) => {
    const object = layout.objects.find((one) => one.id === id);
    return object ? change(object) : null;
  });
}

export const nudge_opening = (id: string, middle: [number, number]): void => step_by_step(id, () => ({pos: middle}));

async function settle(): Promise<void> {
  const now = nudging;
  nudging = null;
  if (now) {
    clearTimeout(now.timer);
    await now.hand.drop();
  }
}
