// A walk through the room at eye level: drag to look, keys or buttons to go.
import type {PerspectiveCamera} from "three";
import type {Layout} from "../gen/types";
import {type Point, contains, footprint, room_bounds, turned} from "../pure/geometry";
import {on_wall} from "../pure/corners";

const kEye = 1.6;
const kSpeed = 1.4;
const kTurn = 1.3;
const kBody = 0.2;
/** What is lower is stepped over. */
const kStepOver = 0.3;

export type Go = "forward" | "back" | "left" | "right";

const kKeys: Record<string, Go> = {
  ArrowUp: "forward", w: "forward", ArrowDown: "back", s: "back", ArrowLeft: "left", a: "left", ArrowRight: "right", d: "right",
};

export const go_of_key = (key: string): Go | undefined => kKeys[key] ?? kKeys[key.toLowerCase()];

/** What is walked in: a view whose camera goes. */
export interface Walked {
  readonly canvas: HTMLCanvasElement;
  readonly camera: PerspectiveCamera;
  draw(): void;
}

export class Walker {
  private at_: Point;
  private readonly solid_: Point[][];
  private yaw_ = 0;
  private pitch_ = -0.12;
  private readonly going_ = new Set<Go>();
  private drag_: {x: number; y: number} | null = null;
  private readonly ended_ = new AbortController();

  constructor(private readonly view_: Walked, private readonly layout_: Layout) {
    const box = room_bounds(layout_.room);
    const centre: Point = [(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2];
    this.solid_ = layout_.objects.filter((one) => one.pos[2] < kEye && one.pos[2] + one.size[2] > kStepOver).map(footprint);
    this.at_ = this.start_(centre);
    this.yaw_ = Math.atan2(centre[1] - this.at_[1], centre[0] - this.at_[0]);
    const {canvas} = view_;
    const {signal} = this.ended_;
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.drag_ = {x: event.clientX, y: event.clientY};
    }, {signal});
    canvas.addEventListener("pointermove", (event) => this.look_(event), {signal});
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { this.drag_ = null; }, {signal});
    this.apply_();
  }

  private start_(centre: Point): Point {
    const door = this.layout_.room.openings?.find((opening) => opening.type !== "window");
    const wall = this.layout_.room.walls?.find((one) => one.id === door?.wall);
    const inside = (far: number): Point[] => (door && wall ? [on_wall(wall, door.offset + door.w / 2, -far)] : []);
    const around = [0.5, 1, 1.5].flatMap((far) => [0, 90, 180, 270].map((turn): Point => {
      const [dx, dy] = turned([far, 0], turn);
      return [centre[0] + dx, centre[1] + dy];
    }));
    return [...inside((door?.w ?? 0) + kBody), ...inside(kBody * 2), centre, ...around].find((point) => this.free_(point)) ?? centre;
  }

  go(way: Go, on: boolean): void {
    if (on) this.going_.add(way);
    else this.going_.delete(way);
    this.view_.draw();
  }

  /** True while somebody walks. */
  advance(seconds: number): boolean {
    const turn = (this.going_.has("left") ? 1 : 0) - (this.going_.has("right") ? 1 : 0);
    const step = (this.going_.has("forward") ? 1 : 0) - (this.going_.has("back") ? 1 : 0);
    this.yaw_ += turn * kTurn * seconds;
    const [dx, dy] = [Math.cos(this.yaw_) * step * kSpeed * seconds, Math.sin(this.yaw_) * step * kSpeed * seconds];
    const ways: Point[] = [[this.at_[0] + dx, this.at_[1] + dy], [this.at_[0] + dx, this.at_[1]], [this.at_[0], this.at_[1] + dy]];
    const free = ways.find((point) => this.free_(point));
    if (step !== 0 && free) this.at_ = free;
    this.apply_();
    return this.going_.size > 0;
  }

  end(): void {
    this.ended_.abort();
  }

  private free_([x, y]: Point): boolean {
    const around: Point[] = [[x - kBody, y], [x + kBody, y], [x, y - kBody], [x, y + kBody]];
    const inside = around.every((point) => contains(this.layout_.room.polygon, point));
    return inside && !this.solid_.some((outline) => contains(outline, [x, y]));
  }

  private look_(event: PointerEvent): void {
    if (!this.drag_) return;
    this.yaw_ += (event.clientX - this.drag_.x) * 0.005;
    this.pitch_ = Math.max(-1.3, Math.min(1.3, this.pitch_ + (event.clientY - this.drag_.y) * 0.005));
    this.drag_ = {x: event.clientX, y: event.clientY};
    this.view_.draw();
  }

  private apply_(): void {
    const {camera} = this.view_;
    camera.position.set(this.at_[0], Math.min(kEye, this.layout_.room.height - 0.1), -this.at_[1]);
    const flat = Math.cos(this.pitch_);
    camera.lookAt(
      camera.position.x + Math.cos(this.yaw_) * flat, camera.position.y + Math.sin(this.pitch_), camera.position.z - Math.sin(this.yaw_) * flat,
    );
  }
}
