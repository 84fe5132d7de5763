// Outlines round what is chosen, pointed at or spoken of, and boxes where things would stand.
import {
  Box3, Box3Helper, BoxGeometry, Color, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, Vector3,
} from "three";
import type {LayoutObject} from "../gen/types";
import {free} from "./free";

export interface Marked { selected: string | null; hovered: string | null; about: readonly string[]; illegal: boolean; colours: {accent: string; wrong: string; about: string} }

export class Marks {
  readonly root = new Group();
  private readonly outlines_ = new Group();
  private readonly ghosts_ = new Group();
  private readonly lines_ = new Map<string, LineBasicMaterial>();

  constructor() {
    this.root.add(this.outlines_, this.ghosts_);
  }

  /** Kept for the next thing that is marked, with its shader. */
  private line_(colour: string, opacity: number): LineBasicMaterial {
    const key = `${colour} ${opacity}`;
    const line = this.lines_.get(key) ?? new LineBasicMaterial({color: new Color(colour), transparent: true, opacity});
    this.lines_.set(key, line);
    return line;
  }

  mark(objects: readonly LayoutObject[], marked: Marked): void {
    for (const edges of this.outlines_.children as LineSegments[]) edges.geometry.dispose();
    this.outlines_.clear();
    const add = (id: string, colour: string, opacity: number) => {
      const object = objects.find((one) => one.id === id);
      if (!object) return;
      const [w, d, h] = object.size;
      const edges = new LineSegments(new EdgesGeometry(new BoxGeometry(w + 0.02, h + 0.02, d + 0.02)), this.line_(colour, opacity));
      edges.position.set(object.pos[0], object.pos[2] + h / 2, -object.pos[1]);
      edges.rotation.y = (object.rotation * Math.PI) / 180;
      this.outlines_.add(edges);
    };
    for (const id of marked.about) add(id, marked.colours.about, 1);
    if (marked.hovered && marked.hovered !== marked.selected) add(marked.hovered, marked.colours.accent, 0.5);
    if (marked.selected) add(marked.selected, marked.illegal ? marked.colours.wrong : marked.colours.accent, 1);
  }

  ghost(objects: readonly LayoutObject[], colour: string): void {
    free(this.ghosts_);
    this.ghosts_.clear();
    for (const object of objects) {
      const [w, d, h] = object.size;
      const body = new Mesh(new BoxGeometry(w, h, d), new MeshBasicMaterial({color: new Color(colour), transparent: true, opacity: 0.28, depthWrite: false}));
      body.position.set(object.pos[0], object.pos[2] + h / 2, -object.pos[1]);
      body.rotation.y = (object.rotation * Math.PI) / 180;
      body.add(new Box3Helper(new Box3(new Vector3(-w / 2, -h / 2, -d / 2), new Vector3(w / 2, h / 2, d / 2)), new Color(colour)));
      this.ghosts_.add(body);
    }
  }
}
