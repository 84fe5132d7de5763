// Walls that stand between the viewer and the room fade, with the doors and windows in them; what hangs on them fades by half.
import {type Material, Mesh, type Object3D, type Vector3} from "three";
import type {Layout} from "../gen/types";

const kFaded = 0.06;
const kHungFaded = 0.4;
const kStep = 0.18;

interface Part { material: Material; opacity: number; clear: boolean; depth: boolean; hung: boolean }
interface Side { x: number; y: number; nx: number; ny: number; parts: Part[]; now: number; goal: number }

function own_materials(root: Object3D, hung: boolean): Part[] {
  const found: Part[] = [];
  root.traverse((node) => {
    if (!(node instanceof Mesh)) return;
    const many = Array.isArray(node.material) ? node.material : [node.material];
    const own = many.map((material: Material) => material.clone());
    node.material = Array.isArray(node.material) ? own : own[0];
    for (const material of own) found.push({material, opacity: material.opacity, clear: material.transparent, depth: material.depthWrite, hung});
  });
  return found;
}

export class Walls {
  private sides_: Side[] = [];
  private first_ = true;

  constructor(layout: Layout, nodes: ReadonlyMap<string, Object3D>) {
    for (const wall of layout.room.walls ?? []) {
      const dx = wall.end[0] - wall.start[0];
      const dy = wall.end[1] - wall.start[1];
      const length = Math.hypot(dx, dy) || 1;
      const openings = (layout.room.openings ?? []).filter((opening) => opening.wall === wall.id);
      const hung = layout.objects.filter((object) => object.supportedBy === wall.id).map((object) => object.id);
      const parts = [wall.id, ...openings.map((opening) => opening.id), ...hung].flatMap((id) => {
        const node = nodes.get(id);
        return node ? own_materials(node, hung.includes(id)) : [];
      });
      this.sides_.push({
        x: wall.start[0], y: wall.start[1], nx: dy / length, ny: -dx / length, parts, now: 1, goal: 1,
      });
    }
  }

  /** Looks from `eye` (three's axes); true while something still fades. */
  update(eye: Vector3, solid: boolean): boolean {
    let more = false;
    for (const side of this.sides_) {
      const outside = (eye.x - side.x) * side.nx + (-eye.z - side.y) * side.ny;
      side.goal = !solid && outside > 0 ? kFaded : 1;
      if (side.now === side.goal) continue;
      const stepped = side.goal > side.now ? Math.min(side.goal, side.now + kStep) : Math.max(side.goal, side.now - kStep);
      const next = this.first_ ? side.goal : stepped;
      side.now = next;
      more ||= next !== side.goal;
      for (const {material, opacity, clear, depth, hung} of side.parts) {
        material.transparent = clear || next < 1;
        material.opacity = opacity * (hung ? Math.max(next, kHungFaded) : next);
        material.depthWrite = depth && (hung || next > 0.5);
      }
    }
    this.first_ = false;
    return more;
  }
}
