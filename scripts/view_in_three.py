#!/usr/bin/env python3
"""Draws a scene.glb by three.js in a headless Chromium, from where the usual picture is taken: a second opinion on what we export.

usage: scripts/view_in_three.py SCENE.glb PICTURE.png [--three FOLDER] [--size 960x540]

FOLDER is the npm package `three` (scripts/setup.sh --tests fetches it), by default
build/deps/three/node_modules/three. Needs chromium on the PATH.
"""

import argparse
import http.server
import os
import shutil
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
THREE = Path(os.environ.get("LAYOUTBOX_THREE", ROOT / "build/deps/three/node_modules/three"))

PAGE = """<!doctype html><meta charset="utf-8"><style>body { margin: 0 }</style>
<script type="importmap">{"imports": {"three": "/three/build/three.module.js"}}</script>
<script type="module">
import * as THREE from 'three';
import {GLTFLoader} from '/three/examples/jsm/loaders/GLTFLoader.js';
const renderer = new THREE.WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
const [innerWidth, innerHeight] = SIZE;
renderer.setSize(innerWidth, innerHeight);
renderer.toneMapping = THREE.LinearToneMapping;
document.body.appendChild(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0.86, 0.88, 0.91);
scene.add(new THREE.HemisphereLight(0xffffff, 0xd8c8b8, 1.6));
const sun = new THREE.DirectionalLight(0xfff2e0, 1.8);
scene.add(sun);
new GLTFLoader().load('/scene.glb', (gltf) => {
  const ceiling = gltf.scene.getObjectByName('ceiling');
  if (ceiling) ceiling.visible = false;
  let nodes = 0, triangles = 0;
  gltf.scene.traverse((node) => {
    nodes += 1;
    if (node.isLight) node.intensity *= 0.3;
    if (node.isMesh) triangles += (node.geometry.index ? node.geometry.index.count : node.geometry.attributes.position.count) / 3;
  });
  scene.add(gltf.scene);
  const box = new THREE.Box3().setFromObject(gltf.scene), middle = box.getCenter(new THREE.Vector3());
  const azimuth = Math.PI / 4, elevation = 65 * Math.PI / 180;
  const to = new THREE.Vector3(Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), Math.cos(azimuth) * Math.cos(elevation));
  const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 200);
  camera.position.copy(middle).addScaledVector(to, 50);
  camera.lookAt(middle);
  camera.updateMatrixWorld();
  let x = 0, y = 0;
  for (let i = 0; i < 8; ++i) {
    const corner = new THREE.Vector3(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z);
    corner.applyMatrix4(camera.matrixWorldInverse);
    x = Math.max(x, Math.abs(corner.x)); y = Math.max(y, Math.abs(corner.y));
  }
  const half = 1.04 * Math.max(y, x * innerHeight / innerWidth), wide = half * innerWidth / innerHeight;
  Object.assign(camera, {left: -wide, right: wide, top: half, bottom: -half});
  camera.updateProjectionMatrix();
  sun.position.copy(middle).add(new THREE.Vector3(-3, 12, 9));
  sun.target.position.copy(middle); scene.add(sun.target);
  renderer.render(scene, camera);
  document.title = `nodes ${nodes} triangles ${triangles}`;
}, undefined, (error) => { document.title = 'failed ' + error; });
</script>"""


def server_for(glb, three, size):
    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self):  # noqa: N802 (the name is http.server's)
            if self.path == "/":
                self.reply(PAGE.replace("SIZE", f"[{size[0]}, {size[1]}]").encode(), "text/html")
            elif self.path == "/scene.glb":
                self.reply(glb.read_bytes(), "model/gltf-binary")
            elif self.path.startswith("/three/") and ".." not in self.path and (three / self.path[7:]).is_file():
                self.reply((three / self.path[7:]).read_bytes(), "text/javascript")
            else:
                self.send_error(404)

        def reply(self, data, kind):
            self.send_response(200)
            self.send_header("Content-Type", kind)
            self.send_header("Content-Length", str(len(data)))
            self.end_headers()
            self.wfile.write(data)

        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server


def missing(three=THREE):
    """What is not here, in words, or None."""
    if not shutil.which("chromium"):
        return "no chromium on the PATH"
    if not (three / "build/three.module.js").is_file():
        return f"no three.js in {three} (scripts/setup.sh --tests)"
    return None


def draw(glb, picture, three=THREE, size=(960, 540), timeout=120):
    """Writes the picture and gives (nodes, triangles) as three.js counts them."""
    server = server_for(Path(glb), Path(three), size)
    with tempfile.TemporaryDirectory() as home:
        options = [
            "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
            "--hide-scrollbars", "--no-first-run", "--virtual-time-budget=20000", f"--user-data-dir={home}",
            f"--window-size={size[0]},{size[1] + 160}",
        ]  # fmt: skip
        address = f"http://127.0.0.1:{server.server_port}/"
        environment = {**os.environ, "HOME": home}

        def run(*words):
            command = ["chromium", *options, *words, address]
            return subprocess.run(command, capture_output=True, text=True, timeout=timeout, check=False, env=environment)

        # The window has a frame that the page does not know of: the canvas is the screenshot's top left part.
        run(f"--screenshot={picture}")
        title = "no title"
        for _ in range(3):  # on a busy machine the page may be asked before it has drawn
            page = run("--dump-dom").stdout
            title = page.split("<title>")[1].split("</title>")[0] if "<title>" in page else title
            if title.startswith(("nodes ", "failed ")):
                break
    server.shutdown()
    server.server_close()
    if not title.startswith("nodes ") or not Path(picture).is_file():
        raise RuntimeError(f"three.js did not draw {glb}: {title}")
    words = title.split()
    return int(words[1]), int(float(words[3]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("glb", type=Path)
    parser.add_argument("picture", type=Path)
    parser.add_argument("--three", type=Path, default=THREE)
    parser.add_argument("--size", default="960x540")
    arguments = parser.parse_args()
    lacks = missing(arguments.three)
    if lacks:
        sys.exit(lacks)
    nodes, triangles = draw(arguments.glb, arguments.picture.resolve(), arguments.three, tuple(int(n) for n in arguments.size.split("x")))
    print(f"{arguments.picture}: {nodes} nodes, {triangles} triangles")


if __name__ == "__main__":
    main()
