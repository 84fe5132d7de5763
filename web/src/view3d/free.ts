// What a part of the scene holds on the graphics card is given back.
import {type BufferGeometry, LineSegments, Mesh, type Object3D} from "three";

export function free(root: Object3D): void {
  root.traverse((node) => {
    if (!(node instanceof Mesh || node instanceof LineSegments)) return;
    (node.geometry as BufferGeometry).dispose();
    for (const material of [node.material].flat()) {
      for (const value of Object.values(material)) if ((value as {isTexture?: boolean} | null)?.isTexture) (value as {dispose(): void}).dispose();
      material.dispose();
    }
  });
}
