# ---- The scene: meshes from the block at the end of the file, objects in collections, lights, camera. --------------------------------
import array
import base64
import struct
import sys
import zlib

import bpy


def read_meshes():
    """The block as a list of (positions, normals, uvs, indices), flat arrays; metres."""
    data = zlib.decompress(base64.b64decode("".join(MESHES.split())))
    meshes, place = [], 0

    def take(code, count, step=1.0):
        nonlocal place
        values = array.array(code)
        size = count * values.itemsize
        values.frombytes(data[place:place + size])
        place += size
        if sys.byteorder == "big":
            values.byteswap()
        return values if step == 1.0 else array.array("f", (v * step for v in values))

    while place < len(data):
        vertices, indices = struct.unpack_from("<II", data, place)
        place += 8
        meshes.append((take("i", 3 * vertices, 1e-5), take("h", 3 * vertices, 1 / 32767), take("i", 2 * vertices, 1e-4),
                       take("i", indices)))
    return meshes


def join(parts, meshes):
    """The parts of one object as one: positions, normals, uvs, indices, and the material slot of each triangle."""
    positions, normals, uvs, indices, slots = array.array("f"), array.array("f"), array.array("f"), array.array("i"), array.array("i")
    for slot, (_, number) in enumerate(parts):
        p, n, t, i = meshes[number]
        first = len(positions) // 3
        positions.extend(p)
        normals.extend(n)
        uvs.extend(t)
        indices.extend(v + first for v in i)
        slots.extend([slot] * (len(i) // 3))
    return positions, normals, uvs, indices, slots


def make_mesh(name, parts, meshes, materials):
    positions, normals, uvs, indices, slots = join(parts, meshes)
    triangles = len(indices) // 3
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(positions) // 3)
    mesh.vertices.foreach_set("co", positions)
    mesh.loops.add(len(indices))
    mesh.loops.foreach_set("vertex_index", indices)
    mesh.polygons.add(triangles)
    mesh.polygons.foreach_set("loop_start", array.array("i", range(0, len(indices), 3)))
    if bpy.app.version < (4, 0, 0):
        mesh.polygons.foreach_set("loop_total", array.array("i", [3] * triangles))
    mesh.polygons.foreach_set("material_index", slots)
    mesh.polygons.foreach_set("use_smooth", array.array("b", [1] * triangles))
    layer = mesh.uv_layers.new(name="metres")
    by_corner = array.array("f")
    for v in indices:
        by_corner.extend(uvs[2 * v:2 * v + 2])
    layer.data.foreach_set("uv", by_corner)
    for material, _ in parts:
        mesh.materials.append(materials[material])
    mesh.update(calc_edges=True)
    if hasattr(mesh, "use_auto_smooth"):  # up to 4.0 own normals count only with it
        mesh.use_auto_smooth = True
    mesh.normals_split_custom_set_from_vertices([normals[i:i + 3] for i in range(0, len(normals), 3)])
    return mesh


def collection(name):
    found = bpy.data.collections.get(name)
    if not found:
        found = bpy.data.collections.new(name)
        bpy.context.scene.collection.children.link(found)
    return found


def left_out(stay):
    """Ids of the parts of the room that are not in the picture: the ceiling, walls that are cut away and what belongs to them."""
    if CAMERA.get("inside"):  # the camera stands in the door: its leaf would be before the lens
        return {row["id"] for row in SHELL if row["kind"] == "opening" and row["id"] == CAMERA.get("stands_in")}
    return {row["id"] for row in SHELL if row["kind"] == "ceiling" or (row["wall"] != "" and row["wall"] not in stay)}


def place(row, data, group):
    """An object of Blender at its place in the room."""
    thing = bpy.data.objects.new(row["id"], data)
    thing.location = row["at"]
    thing.rotation_euler = (0, 0, math.radians(row["turn"]))
    group.objects.link(thing)
    return thing


def add_lights(row, thing, group):
    for number, light in enumerate(row["lights"], 1):
        data = bpy.data.lights.new(f"{row['id']} light {number}", "POINT")
        data.energy, data.color, data.shadow_soft_size = light["watts"] * LIGHT["lamps"], linear(light["color"]), light["radius"]
        lamp = bpy.data.objects.new(data.name, data)
        lamp.location, lamp.parent = light["at"], thing
        group.objects.link(lamp)


def say_what_it_is(row, thing):
    """What the meshes do not tell, as custom properties: an open leaf is no obstacle, what sticks out of a box is not its size."""
    thing["kind"], thing["category"], thing["name in words"] = row["kind"], row["category"], row["name"]
    opening = next((o for o in OPENINGS if o["id"] == row["id"]), None) if row["kind"] == "opening" else None
    if opening:
        thing["category"], thing["swing"] = opening["type"], opening["swing"]
        thing["size"] = (opening["w"], opening["h"], opening["sill"])
    if row["kind"] == "floor":  # of an L the mesh's box says no corners
        thing["polygon"] = [length for corner in ROOM["polygon"] for length in corner]
    if row["kind"] == "object":  # what holds it is so only where it was put
        thing["size"], thing["supportedBy"], thing["placed at"] = row["size"], row["stands_on"], row["at"]


def build_rows(rows, out, meshes, materials):
    shared = {}
    panes = {name: make_pane(name, row) for name, row in MATERIALS.items() if row["alpha"] < 1 and not row["image"]}
    for row in rows:
        group = collection("Left out" if row["id"] in out else row["collection"])
        key = tuple((material, number) for material, number in row["parts"])
        own = {**materials, **panes} if row["kind"] == "opening" else materials
        data = None
        if key:
            data = shared.get(key)
            if data is None:
                data = shared[key] = make_mesh(row["id"], row["parts"], meshes, own)
        thing = place(row, data, group)
        say_what_it_is(row, thing)
        thing.hide_render = row["id"] in out
        if row["kind"] == "ceiling":  # seen from inside, yet the light comes in as if it were not there
            thing.visible_shadow = thing.visible_diffuse = thing.visible_glossy = thing.visible_transmission = False
        if row["id"] not in out:
            add_lights(row, thing, group)


def build_base(stay):
    """The slab under the room, seen at the cut edges, with a mark where a door or window was in a wall that is cut away."""
    group = collection("Room")
    outline = outer_outline()
    count = len(outline)
    if not outline:
        return
    vertices = [(x, y, -BASE_GAP) for x, y in outline] + [(x, y, -BASE_DEPTH) for x, y in outline]
    faces = [tuple(range(count)), tuple(range(2 * count - 1, count - 1, -1))]
    faces += [(i, i + count, (i + 1) % count + count, (i + 1) % count) for i in range(count)]
    mesh = bpy.data.meshes.new("base")
    mesh.from_pydata(vertices, [], faces)
    mesh.materials.append(make_material("base", {**PLAIN, "color": BASE_COLOR}))
    base = bpy.data.objects.new("base", mesh)
    base["kind"] = "base"
    group.objects.link(base)
    for opening in OPENINGS:
        wall = next((w for w in WALLS if w["id"] == opening["wall"]), None)
        if wall is None or wall["id"] in stay:  # it is a real opening there
            continue
        (ax, ay), (bx, by) = wall["start"], wall["end"]
        length = math.hypot(bx - ax, by - ay)
        along, out = ((bx - ax) / length, (by - ay) / length), tuple(-c for c in inward_normal(wall))
        corners = [(ax + along[0] * s + out[0] * t, ay + along[1] * s + out[1] * t, 0.001) for s, t in
                   ((opening["offset"], 0.0), (opening["offset"], wall["thickness"]),
                    (opening["offset"] + opening["w"], wall["thickness"]), (opening["offset"] + opening["w"], 0.0))]
        name = f"mark of {opening['id']}"
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(corners, [], [(0, 1, 2, 3)])
        mesh.materials.append(make_material(name, {**PLAIN, "color": MARK_COLORS.get(opening["type"], MARK_COLORS["door"])}))
        mark = bpy.data.objects.new(name, mesh)
        mark["kind"] = "mark"
        group.objects.link(mark)


def build_ghosts(stay, out):
    """What hangs on a wall that is cut away hangs on a faint pane in its place, so that it is seen to hang and not to float."""
    for wall in WALLS:
        if wall["id"] in stay:
            continue
        (ax, ay), (bx, by) = wall["start"], wall["end"]
        length = math.hypot(bx - ax, by - ay)
        ux, uy = (bx - ax) / length, (by - ay) / length
        for row in OBJECTS:
            if row["hangs_on"] != wall["id"] or row["id"] in out:
                continue
            middle = (row["at"][0] - ax) * ux + (row["at"][1] - ay) * uy
            reach = row["size"][0] / 2 + GHOST_MARGIN
            ends = max(0.0, middle - reach), min(length, middle + reach)
            top = min(row["at"][2] + row["size"][2] + GHOST_MARGIN, ROOM["height"])
            corners = [(ax + ux * ends[k], ay + uy * ends[k], z) for k, z in ((0, 0.0), (1, 0.0), (1, top), (0, top))]
            mesh = bpy.data.meshes.new(f"wall behind {row['id']}")
            mesh.from_pydata(corners, [], [(0, 1, 2, 3)])
            mesh.materials.append(make_ghost())
            ghost = bpy.data.objects.new(mesh.name, mesh)
            ghost["kind"] = "mark"
            ghost.visible_shadow = ghost.visible_diffuse = ghost.visible_glossy = False
            collection("Room").objects.link(ghost)


GHOST_MARGIN = 0.06  # metres that the pane is wider and higher than what hangs on it
PLAIN = {"roughness": 0.7, "metallic": 0.0, "alpha": 1.0, "emission": 0.0, "texture": "", "second": (0, 0, 0), "scale": 1.0, "image": ""}
BASE_COLOR = (0.52, 0.37, 0.29)
MARK_COLORS = {"door": (0.86, 0.78, 0.66), "open": (0.86, 0.78, 0.66), "window": (0.66, 0.80, 0.90)}


def build_camera(stay):
    position, measure = frame(stay)
    data = bpy.data.cameras.new("Camera")
    data.sensor_fit = "HORIZONTAL"
    if CAMERA["orthographic"]:
        data.type, data.ortho_scale = "ORTHO", measure
    else:
        data.angle = 2 * measure
    data.clip_start, data.clip_end = 0.1, 500.0
    camera = bpy.data.objects.new("Camera", data)
    camera.location = position
    camera.rotation_euler = (math.radians(90 - CAMERA["elevation"]), 0, math.radians(CAMERA["azimuth"]))
    collection("Light and camera").objects.link(camera)
    bpy.context.scene.camera = camera


def build_beams(stay):
    """Sun that falls in through the windows of the walls that stay, as patches on the floor: before each window a lamp of its size whose
    rays are nearly parallel, so that nothing else is lit by it."""
    group = collection("Light and camera")
    turn, down = math.radians(LIGHT["beam_turn"]), math.radians(LIGHT["beam_down"])
    for opening in OPENINGS:
        wall = next((w for w in WALLS if w["id"] == opening["wall"]), None)
        if wall is None or wall["id"] not in stay or opening["type"] != "window":
            continue
        (ax, ay), (bx, by) = wall["start"], wall["end"]
        share = (opening["offset"] + opening["w"] / 2) / math.hypot(bx - ax, by - ay)
        nx, ny = inward_normal(wall)
        hx, hy = nx * math.cos(turn) - ny * math.sin(turn), nx * math.sin(turn) + ny * math.cos(turn)
        away = 0.6  # m from the window, up along the rays
        data = bpy.data.lights.new(f"sun in {opening['id']}", "AREA")
        data.shape, data.size, data.size_y = "RECTANGLE", opening["w"], opening["h"]
        data.spread, data.color = math.radians(4.0), linear(LIGHT["beam_color"])
        data.energy = LIGHT["beams"] * opening["w"] * opening["h"]
        beam = bpy.data.objects.new(data.name, data)
        beam.location = (ax + (bx - ax) * share - hx * math.cos(down) * away, ay + (by - ay) * share - hy * math.cos(down) * away,
                         opening["sill"] + opening["h"] / 2 + math.sin(down) * away)
        beam.rotation_euler = (math.pi / 2 - down, 0, math.atan2(hy, hx) - math.pi / 2)
        beam.visible_camera = False
        group.objects.link(beam)


def build_light():
    """A soft sun from the camera's left, the sky all round, and a plain colour behind the room."""
    group = collection("Light and camera")
    data = bpy.data.lights.new("Sun", "SUN")
    data.energy, data.angle, data.color = LIGHT["sun"], math.radians(LIGHT["sun_angle"]), linear(LIGHT["sun_color"])
    sun = bpy.data.objects.new("Sun", data)
    # Seen from above no wall is cut away: a high sun keeps their shadows off the floor.
    elevation = LIGHT["sun_elevation_top"] if CAMERA["view"] == "top" else LIGHT["sun_elevation"]
    sun.rotation_euler = (math.radians(90 - elevation), 0, math.radians(CAMERA["azimuth"] + LIGHT["sun_azimuth"]))
    sun.location = (0, 0, 10)
    group.objects.link(sun)
    world = bpy.data.worlds.new("World")
    bpy.context.scene.world = world
    if not world.node_tree:
        world.use_nodes = True
    tree = world.node_tree
    tree.nodes.clear()
    sky, behind = tree.nodes.new("ShaderNodeBackground"), tree.nodes.new("ShaderNodeBackground")
    sky.inputs["Color"].default_value, sky.inputs["Strength"].default_value = rgba(LIGHT["sky_color"]), LIGHT["sky"]
    behind.inputs["Color"].default_value, behind.inputs["Strength"].default_value = rgba(LIGHT["background"]), 1.0
    ray, choose = tree.nodes.new("ShaderNodeLightPath"), tree.nodes.new("ShaderNodeMixShader")
    output = tree.nodes.new("ShaderNodeOutputWorld")
    tree.links.new(ray.outputs["Is Camera Ray"], choose.inputs[0])
    tree.links.new(sky.outputs[0], choose.inputs[1])
    tree.links.new(behind.outputs[0], choose.inputs[2])
    tree.links.new(choose.outputs[0], output.inputs["Surface"])
