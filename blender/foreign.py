# Runs in the sandbox (docs/sandbox.md): a script of others, or a .blend of others, in the folder it starts in.
#   foreign.py script   runs script.py in an empty scene and saves room.blend; exit status 4: it is no Python, 5: it raised
#   foreign.py draw     the same, and draws scene.png as picture.json says (width, height, samples)
#   foreign.py read     opens room.blend and writes room.gltf: every thing that is drawn as a node with its box, no mesh
# The line `layoutbox: fault …` says what was wrong.
import json
import os
import re
import sys
import traceback

import bpy
from mathutils import Matrix, Vector

UP = Matrix(((1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (0, 0, 0, 1)))  # z up to y up
GEOMETRY = {"MESH", "CURVE", "SURFACE", "META", "FONT", "CURVES", "VOLUME"}
NO_PYTHON, RAISED = 4, 5
PART = re.compile(r"^(.*\w_\d+)[ ._-]\D.*$")  # "bed_1_mattress", not "bed_1" or "bed_1.001"


def leave(status, words=""):
    if words:
        print("layoutbox: fault " + " ".join(words.split())[:500], flush=True)
    sys.stdout.flush()
    os._exit(status)  # what the script left to run at the end is not waited for


def run_script(draws=False):
    with open("script.py", encoding="utf-8", errors="replace") as file:
        text = file.read()
    try:
        code = compile(text, "script.py", "exec")
    except (SyntaxError, ValueError) as error:
        leave(NO_PYTHON, f"{type(error).__name__}: {error}")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    try:
        exec(code, {"__name__": "__main__", "__file__": "script.py"})
    except SystemExit as error:
        if error.code not in (None, 0):
            leave(RAISED, f"SystemExit: {error.code}")
    except BaseException as error:
        lines = [row.lineno for row in traceback.extract_tb(error.__traceback__) if row.filename == "script.py"]
        leave(RAISED, f"{type(error).__name__}: {error}" + (f" (line {lines[-1]})" if lines else ""))
    if draws:
        draw()
    bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath("room.blend"), check_existing=False)
    leave(0)


def draw():
    with open("picture.json", encoding="utf-8") as file:
        wanted = json.load(file)
    scene = bpy.context.scene
    if scene.camera is None:
        scene.camera = next((thing for thing in scene.objects if thing.type == "CAMERA"), None)
    if scene.camera is None:
        leave(RAISED, "the scene has no camera")
    if not any(thing.type in GEOMETRY for thing in scene.objects):
        leave(RAISED, "the scene has nothing to see")
    scene.render.engine = "CYCLES"
    scene.cycles.samples = wanted["samples"]
    scene.cycles.use_denoising = bpy.app.version >= (4, 0, 0)
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = wanted["width"], wanted["height"], 100
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = os.path.abspath("scene.png")
    bpy.ops.render.render(write_still=True)


def rows(matrix):
    return [matrix[row][column] for column in range(4) for row in range(4)]


def numbers(values):
    """The numbers of a custom property, or None."""
    try:
        return [float(value) for value in values]
    except (TypeError, ValueError):
        return None


def three(values):
    """Three numbers of a custom property, or None."""
    found = numbers(values)
    return found if found and len(found) == 3 else None


def facts_of(thing):
    """What a .blend of ours says of a thing beyond its meshes; of what was moved or scaled by hand only what is still so."""
    words = {key: thing.get(key) for key in ("kind", "category", "swing", "supportedBy")}
    facts = {key: value for key, value in words.items() if isinstance(value, str) and value}
    size, placed = three(thing.get("size")), three(thing.get("placed at"))
    if size and facts.get("kind") == "object":
        facts["size"] = [length * abs(scale) for length, scale in zip(size, thing.matrix_world.to_scale())]
    elif size and max(abs(scale - 1) for scale in thing.matrix_world.to_scale()) < 1e-4:
        facts["size"] = size
    if facts.get("kind") == "floor" and (corners := numbers(thing.get("polygon"))):
        facts["polygon"] = [corners[i : i + 2] for i in range(0, len(corners), 2)]
    if not placed or (thing.matrix_world.translation - Vector(placed)).length > 1e-3:
        facts.pop("supportedBy", None)
    return facts


class Writer:
    def __init__(self, graph):
        self.graph = graph
        self.nodes, self.meshes, self.accessors = [], [], []

    def mesh(self, thing):
        corners = [UP @ Matrix.Translation(corner) for corner in thing.bound_box]
        points = [(m[0][3], m[1][3], m[2][3]) for m in corners]
        self.accessors.append({"min": [min(p[i] for p in points) for i in range(3)], "max": [max(p[i] for p in points) for i in range(3)]})
        self.meshes.append({"primitives": [{"attributes": {"POSITION": len(self.accessors) - 1}}]})
        return len(self.meshes) - 1

    def add(self, thing, original, above, drawn, children):
        node = {"name": original.name, "matrix": rows(UP @ above @ thing.matrix_world @ UP.inverted())}
        facts = facts_of(original)
        if facts:
            node["extras"] = facts
        # Of ours the walls that a picture leaves out are walls all the same.
        if thing.type in GEOMETRY and (original.name in drawn or "kind" in facts):
            node["mesh"] = self.mesh(thing)
        self.nodes.append(node)
        place = len(self.nodes) - 1
        inside = original.matrix_world.inverted_safe()
        below = [self.add(child.evaluated_get(self.graph), child, inside, drawn, children) for child in children(original)]
        if below:
            node["children"] = below
        return place

    def add_whole(self, name, parts, drawn, children):
        """Parts that only their names hold together; the first says how the whole is turned."""
        turn = parts[0].matrix_world.to_euler().to_matrix().to_4x4()
        node = {"name": name, "matrix": rows(UP @ turn @ UP.inverted())}
        self.nodes.append(node)
        place = len(self.nodes) - 1
        node["children"] = [self.add(part.evaluated_get(self.graph), part, turn.inverted(), drawn, children) for part in parts]
        return place


def evaluate_all(collection, things):
    """Blender knows where a thing is only if it shows it: also the window of a wall that is cut away for the picture."""
    collections = [collection]
    while collections:
        one = collections.pop()
        one.exclude = one.hide_viewport = one.collection.hide_viewport = False
        collections.extend(one.children)
    for thing in things:
        thing.hide_viewport = False
    bpy.context.view_layer.update()


def read_room():
    bpy.ops.wm.open_mainfile(filepath=os.path.abspath("room.blend"), load_ui=False, use_scripts=False)
    scene = bpy.context.scene
    drawn = {thing.name for thing in bpy.context.view_layer.objects if not thing.hide_render}
    evaluate_all(bpy.context.view_layer.layer_collection, scene.objects)
    graph = bpy.context.evaluated_depsgraph_get()
    of_scene = set(scene.objects)
    writer = Writer(graph)

    def children(one):
        return [child for child in one.children if child in of_scene]

    wholes = {}
    for thing in scene.objects:
        if thing.parent is None:
            match = PART.match(thing.name)
            wholes.setdefault(match.group(1) if match else thing.name, []).append(thing)
    roots = []
    for name, parts in wholes.items():
        if len(parts) > 1:
            roots.append(writer.add_whole(name, parts, drawn, children))
        else:
            roots.append(writer.add(parts[0].evaluated_get(graph), parts[0], Matrix.Identity(4), drawn, children))
    room = {"asset": {"version": "2.0", "generator": "layoutbox"}, "scene": 0, "scenes": [{"nodes": roots}], "nodes": writer.nodes,
            "meshes": writer.meshes, "accessors": writer.accessors}
    with open("room.gltf", "w", encoding="utf-8") as file:
        json.dump(room, file)
    leave(0)


try:
    {"script": run_script, "draw": lambda: run_script(True), "read": read_room}[sys.argv[-1]]()
except Exception as error:
    traceback.print_exc()
    leave(1, f"{type(error).__name__}: {error}")
