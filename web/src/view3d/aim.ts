// From the window to the room and back: what a pointer points at, and where on the canvas a point of the room is seen.
import {type PerspectiveCamera, Plane, Raycaster, Vector2, Vector3} from "three";
import type {Point} from "../pure/geometry";

const three_of = ([x, y]: Point, height: number): Vector3 => new Vector3(x, height, -y);

export class Aim {
  private readonly ray_ = new Raycaster();

  constructor(private readonly camera_: PerspectiveCamera, private readonly canvas_: HTMLCanvasElement) {}

  /** The ray through a point of the window. */
  ray(x: number, y: number): Raycaster {
    const box = this.canvas_.getBoundingClientRect();
    this.ray_.setFromCamera(new Vector2(((x - box.left) / box.width) * 2 - 1, 1 - ((y - box.top) / box.height) * 2), this.camera_);
    return this.ray_;
  }

  /** Where it meets a height, in the room's metres. */
  at_height(x: number, y: number, height: number): Point | null {
    const hit = this.ray(x, y).ray.intersectPlane(new Plane(new Vector3(0, 1, 0), -height), new Vector3());
    return hit ? [hit.x, -hit.z] : null;
  }

  /** How high it passes over a point of the floor, seen from the side. */
  height_over(x: number, y: number, point: Point): number | null {
    const foot = three_of(point, 0);
    const towards = this.camera_.position.clone().sub(foot).setY(0).normalize();
    const hit = this.ray(x, y).ray.intersectPlane(new Plane().setFromNormalAndCoplanarPoint(towards, foot), new Vector3());
    return hit ? hit.y : null;
  }

  /** Pixels from the canvas's upper left corner; none behind the viewer. */
  on_canvas(point: Point, height: number): Point | null {
    const seen = three_of(point, height).project(this.camera_);
    if (seen.z > 1) return null;
    return [((seen.x + 1) / 2) * this.canvas_.clientWidth, ((1 - seen.y) / 2) * this.canvas_.clientHeight];
  }

  /** What a pixel is there, in metres. */
  metres_per_pixel(point: Point, height: number): number {
    const far = this.camera_.position.distanceTo(three_of(point, height));
    return (2 * far * Math.tan((this.camera_.fov * Math.PI) / 360)) / (this.canvas_.clientHeight || 1);
  }
}
