// The room in 3D: one scene, drawn only when something changes.
import {
  DirectionalLight, HemisphereLight, Light, Mesh, NeutralToneMapping, type Object3D, PCFShadowMap, PerspectiveCamera, Scene, Vector3, WebGLRenderer,
} from "three";
import {OrbitControls} from "three/addons/controls/OrbitControls.js";
import {GLTFLoader} from "three/addons/loaders/GLTFLoader.js";
import type {Layout, LayoutObject} from "../gen/types";
import {room_bounds} from "../pure/geometry";
import {Aim} from "./aim";
import {free} from "./free";
import {type Marked, Marks} from "./marks";
import {Walker} from "./walker";
import {Walls} from "./walls";

const kShadow = 1024;
/** Light that the floor throws back: seen from within it is all that a ceiling has. */
const kFromBelow = 0xcbb89d;
const kFromBelowWithin = 0xf3efe8;

export class RoomView {
  readonly camera = new PerspectiveCamera(42, 1, 0.05, 200);
  readonly controls: OrbitControls;
  readonly aim: Aim;
  /** Told when what is seen has changed. */
  on_frame: (() => void) | null = null;
  walker: Walker | null = null;
  private readonly renderer_: WebGLRenderer;
  private readonly scene_ = new Scene();
  private readonly sky_ = new HemisphereLight(0xffffff, kFromBelow, 2.0);
  private readonly sun_ = new DirectionalLight(0xfff4e2, 2.1);
  private readonly marks_ = new Marks();
  private room_: Object3D | null = null;
  private nodes_ = new Map<string, Object3D>();
  private walls_: Walls | null = null;
  private layout_: Layout | null = null;
  private framed_ = "";
  private asked_ = 0;
  private last_ = 0;
  private fresh_ = false;
  private held_ = false;
  /** Rooms no longer shown, kept until the next is drawn: it uses the same shaders, which take longer to compile than all else. */
  private gone_: Object3D[] = [];

  constructor(readonly canvas: HTMLCanvasElement) {
    this.renderer_ = new WebGLRenderer({canvas, antialias: true, alpha: true, powerPreference: "low-power"});
    this.renderer_.debug.checkShaderErrors = false; // asking whether a shader is good waits for it
    this.renderer_.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer_.toneMapping = NeutralToneMapping;
    this.renderer_.toneMappingExposure = 1.05;
    this.renderer_.shadowMap.enabled = true;
    this.renderer_.shadowMap.type = PCFShadowMap;
    this.renderer_.shadowMap.autoUpdate = false;
    this.sun_.castShadow = true;
    this.sun_.shadow.mapSize.set(kShadow, kShadow);
    this.sun_.shadow.bias = -0.0006;
    this.sun_.shadow.normalBias = 0.02;
    this.scene_.add(this.sky_, this.sun_, this.sun_.target, this.marks_.root);
    this.aim = new Aim(this.camera, canvas);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.maxPolarAngle = Math.PI * 0.495;
    this.controls.addEventListener("change", () => this.draw());
  }

  get draw_calls(): number {
    return this.renderer_.info.render.calls;
  }

  size(width: number, height: number): void {
    if (width === 0 || height === 0) return;
    this.renderer_.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.layout_ && !this.walker) this.frame_(this.layout_, false);
    this.frame_now_(performance.now()); // at once: setting the size has wiped the canvas
  }

  /** Takes a GLB of a layout in place of what was shown. */
  async load(glb: ArrayBuffer, layout: Layout): Promise<void> {
    const {scene} = await new GLTFLoader().parseAsync(glb, "");
    if (this.room_) {
      this.scene_.remove(this.room_);
      this.gone_.push(this.room_);
    }
    this.nodes_ = new Map();
    const lights: Object3D[] = [];
    scene.traverse((node) => {
      if (node instanceof Light) lights.push(node);
      if (node instanceof Mesh) node.receiveShadow = true;
      if (node.userData["kind"] === "object") node.traverse((part) => { part.castShadow = part instanceof Mesh; });
    });
    for (const light of lights) light.removeFromParent();
    for (const node of scene.children) {
      const kind = node.userData["kind"] as string | undefined;
      const name = (node.userData["name"] as string | undefined) ?? "";
      this.nodes_.set(this.id_of_(node, layout, kind, name), node);
    }
    this.room_ = scene;
    this.scene_.add(scene);
    this.walls_ = new Walls(layout, this.nodes_);
    this.place(layout);
    const box = room_bounds(layout.room);
    const shape = JSON.stringify(box);
    if (this.framed_ !== shape) this.frame_(layout, true);
    this.framed_ = shape;
    this.light_(layout);
    this.fresh_ = true;
    this.release();
  }

  /** GLTFLoader strips some signs of names; ids are letters, digits, "_" and "-", so the name is the id. */
  private id_of_(node: Object3D, layout: Layout, kind: string | undefined, _name: string): string {
    if (kind !== "object" || layout.objects.some((object) => object.id === node.name)) return node.name;
    const clean = (id: string) => id.replace(/\s/g, "_").replace(/[[\].:/]/g, "");
    return layout.objects.find((object) => clean(object.id) === node.name)?.id ?? node.name;
  }

  /** Moves what is loaded to the places of a layout. */
  place(layout: Layout): void {
    this.layout_ = layout;
    for (const object of layout.objects) {
      const node = this.nodes_.get(object.id);
      if (!node) continue;
      node.position.set(object.pos[0], object.pos[2], -object.pos[1]);
      node.rotation.set(0, (object.rotation * Math.PI) / 180, 0);
      this.resize_(node, object);
    }
    this.renderer_.shadowMap.needsUpdate = true;
    this.draw();
  }

  /** While a thing is resized by hand its mesh is stretched; the next GLB brings the real shape. */
  private resize_(node: Object3D, object: LayoutObject): void {
    const made = node.userData["size"] as number[] | undefined;
    if (made?.length === 3) node.scale.set(object.size[0] / (made[0] || 1), object.size[2] / (made[2] || 1), object.size[1] / (made[1] || 1));
  }

  mark(marked: Marked): void {
    this.marks_.mark(this.layout_?.objects ?? [], marked);
    this.draw();
  }

  ghost(objects: readonly LayoutObject[], colour: string): void {
    this.marks_.ghost(objects, colour);
    this.draw();
  }

  /** The thing under a point of the window. */
  pick(x: number, y: number): string | null {
    if (!this.room_ || !this.layout_) return null;
    const roots = this.layout_.objects.flatMap((object) => this.nodes_.get(object.id) ?? []).filter((node) => node.visible);
    const hit = this.aim.ray(x, y).intersectObjects(roots, true)[0]?.object;
    for (let node: Object3D | null = hit ?? null; node; node = node.parent) {
      for (const [id, root] of this.nodes_) if (root === node) return id;
    }
    return null;
  }

  walk(on: boolean): void {
    this.walker?.end();
    this.walker = on && this.layout_ ? new Walker(this, this.layout_) : null;
    this.controls.enabled = !on;
    this.camera.fov = on ? 68 : 42;
    this.sky_.groundColor.set(on ? kFromBelowWithin : kFromBelow);
    this.camera.updateProjectionMatrix();
    if (!on && this.layout_) this.frame_(this.layout_, true);
    this.draw();
  }

  reset(): void {
    if (this.layout_) this.frame_(this.layout_, true);
    this.draw();
  }

  /** Nothing is drawn until another room is loaded, or `release`: meshes of the old one at places of the new one would only take time. */
  hold(): void {
    this.held_ = true;
  }

  release(): void {
    this.held_ = false;
    this.draw();
  }

  draw(): void {
    if (this.asked_ || this.held_) return;
    this.asked_ = requestAnimationFrame((now) => {
      this.asked_ = 0;
      if (!this.held_) this.frame_now_(now);
    });
  }

  private frame_now_(now: number): void {
    const seconds = Math.min(0.1, (now - this.last_) / 1000 || 0.016);
    this.last_ = now;
    const walking = this.walker?.advance(seconds) ?? false;
    const ceiling = this.nodes_.get("ceiling");
    if (ceiling) ceiling.visible = this.walker !== null;
    const fading = this.walls_?.update(this.camera.position, this.walker !== null) ?? false;
    this.renderer_.render(this.scene_, this.camera);
    this.canvas.dataset["calls"] = String(this.draw_calls);
    if (this.fresh_) {
      this.fresh_ = false;
      this.gone_.forEach(free);
      this.gone_ = [];
      this.canvas.dataset["room"] = String(Number(this.canvas.dataset["room"] ?? 0) + 1);
      this.canvas.dataset["at"] = String(performance.now());
    }
    this.on_frame?.();
    if (fading || walking) this.draw();
  }

  private frame_(layout: Layout, turn: boolean): void {
    const box = room_bounds(layout.room);
    const [w, d, h] = [box.x1 - box.x0, box.y1 - box.y0, layout.room.height];
    const centre = new Vector3((box.x0 + box.x1) / 2, h * 0.3, -(box.y0 + box.y1) / 2);
    const way = turn ? new Vector3(0.5, 0.78, 0.95).normalize() : this.camera.position.clone().sub(this.controls.target).normalize();
    const distance = this.distance_(centre, way, [w / 2, h * 0.85, d / 2]);
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).addScaledVector(way, distance);
    this.controls.maxDistance = distance * 4;
    this.controls.minDistance = 0.4;
    this.camera.far = distance * 8;
    this.camera.updateProjectionMatrix();
    this.controls.update();
  }

  /** How far away the room's corners, `half` from the centre's foot, all lie in the picture. */
  private distance_(centre: Vector3, way: Vector3, [w, h, d]: [number, number, number]): number {
    const side = new Vector3(0, 1, 0).cross(way).normalize();
    const up = way.clone().cross(side);
    const tall = Math.tan((this.camera.fov * Math.PI) / 360);
    const wide = tall * this.camera.aspect;
    let distance = 0;
    for (const x of [-w, w]) for (const y of [-centre.y, h - centre.y]) for (const z of [-d, d]) {
      const corner = new Vector3(x, y, z);
      const across = Math.max(Math.abs(corner.dot(side)) / wide, Math.abs(corner.dot(up)) / tall);
      distance = Math.max(distance, corner.dot(way) + across);
    }
    return distance * 1.06;
  }

  private light_(layout: Layout): void {
    const box = room_bounds(layout.room);
    const reach = Math.hypot(box.x1 - box.x0, box.y1 - box.y0) / 2 + 1;
    const centre = new Vector3((box.x0 + box.x1) / 2, 0, -(box.y0 + box.y1) / 2);
    this.sun_.position.copy(centre).add(new Vector3(reach * 0.5, reach * 1.6 + 3, reach * 0.7));
    this.sun_.target.position.copy(centre);
    Object.assign(this.sun_.shadow.camera, {left: -reach, right: reach, top: reach, bottom: -reach, near: 0.1, far: reach * 5 + 8});
    this.sun_.shadow.camera.updateProjectionMatrix();
    this.renderer_.shadowMap.needsUpdate = true;
  }

  dispose(): void {
    cancelAnimationFrame(this.asked_);
    this.walker?.end();
    this.controls.dispose();
    this.gone_.forEach(free);
    free(this.scene_);
    this.renderer_.dispose();
  }
}
