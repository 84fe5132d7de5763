# ---- The overlay: names, free room before things, and what does not hold, drawn over the picture that is already there. ---------------
import os

import bpy

OVERLAY_COLORS = {"name": (0.10, 0.12, 0.15), "plate": (1.0, 1.0, 1.0), "failed": (0.84, 0.10, 0.10), "clear": (0.05, 0.42, 0.68)}


def project(view, point):
    """Where a point of the room is in the picture: pixels from its left and from its bottom."""
    ray = Vector(point) - view.eye
    size = view.measure if CAMERA["orthographic"] else 2 * math.tan(view.measure) * -ray.dot(view.toward)
    return (ray.dot(view.right) / size + 0.5) * view.width, ray.dot(view.up) / size * view.width + 0.5 * view.height


def middles_seen(view, things, seen):
    """The middle of what is seen of each object, in pixels from the left and the bottom; hidden ones have the middle of their box."""
    sums = {}
    for pixel, number in enumerate(seen):
        if number >= 0:
            entry = sums.setdefault(things[number][0]["id"], [0, 0, 0])
            entry[0], entry[1], entry[2] = entry[0] + pixel % view.width, entry[1] + pixel // view.width, entry[2] + 1
    middles = {}
    for row in OBJECTS:
        x, y, count = sums.get(row["id"], (0, 0, 0))
        corners = box_corners(row)
        middle = project(view, [sum(c[i] for c in corners) / 8 for i in range(3)])
        middles[row["id"]] = (x / count, view.height - y / count) if count else middle
    return middles


def free_way(row, side):
    """The line on the floor from a side of a thing to what stands before it (furniture or a wall): its two ends."""
    ahead = {"front": (0, -1), "back": (0, 1), "left": (-1, 0), "right": (1, 0)}[side]
    turn = math.radians(row["turn"])
    c, s = math.cos(turn), math.sin(turn)
    way = (c * ahead[0] - s * ahead[1], s * ahead[0] + c * ahead[1])
    half = row["size"][1] / 2 if ahead[1] else row["size"][0] / 2
    start = (row["at"][0] + way[0] * half, row["at"][1] + way[1] * half)
    step, reach = 0.01, 0.0
    while reach < 6.0:
        x, y = start[0] + way[0] * (reach + step), start[1] + way[1] * (reach + step)
        if not well_inside((x, y), ROOM["polygon"], 0.0):
            break
        if any(stands_at(other, x, y) for other in OBJECTS if other is not row):
            break
        reach += step
    return start, (start[0] + way[0] * reach, start[1] + way[1] * reach), reach


def stands_at(row, x, y):
    """True where a thing that one cannot step over or under covers a point of the floor."""
    low, high = row["at"][2], row["at"][2] + row["size"][2]
    if high < 0.04 or low > 1.8:
        return False
    turn = math.radians(row["turn"])
    dx, dy = x - row["at"][0], y - row["at"][1]
    return (abs(math.cos(turn) * dx + math.sin(turn) * dy) < row["size"][0] / 2 and
            abs(-math.sin(turn) * dx + math.cos(turn) * dy) < row["size"][1] / 2)


class Sheet:
    """A scene of its own that looks straight down on a sheet whose unit is a pixel of the picture."""

    def __init__(self, width, height):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.scene = bpy.context.scene
        self.width, self.height, self.unit = width, height, max(10.0, height / 48)
        self.paints, self.taken, self.level = {}, [], 0.0
        data = bpy.data.cameras.new("Camera")
        data.type, data.sensor_fit, data.ortho_scale = "ORTHO", "HORIZONTAL", width
        camera = bpy.data.objects.new("Camera", data)
        camera.location = (width / 2, height / 2, 100)
        self.scene.collection.objects.link(camera)
        self.scene.camera = camera

    def paint(self, name):
        if name not in self.paints:
            material = bpy.data.materials.new(name)
            nodes = Nodes(material).tree
            nodes.nodes.clear()
            light, out = nodes.nodes.new("ShaderNodeEmission"), nodes.nodes.new("ShaderNodeOutputMaterial")
            light.inputs["Color"].default_value = rgba(OVERLAY_COLORS[name])
            nodes.links.new(light.outputs[0], out.inputs["Surface"])
            self.paints[name] = material
        return self.paints[name]

    def polygon(self, corners, paint, level):
        mesh = bpy.data.meshes.new(paint)
        mesh.from_pydata([(x, y, level) for x, y in corners], [], [tuple(range(len(corners)))])
        mesh.materials.append(self.paint(paint))
        self.scene.collection.objects.link(bpy.data.objects.new(paint, mesh))

    def line(self, a, b, paint, thick=0.12, level=1.0):
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = math.hypot(dx, dy)
        if length > 0.5:
            nx, ny = -dy / length * thick * self.unit / 2, dx / length * thick * self.unit / 2
            self.polygon([(a[0] + nx, a[1] + ny), (b[0] + nx, b[1] + ny), (b[0] - nx, b[1] - ny), (a[0] - nx, a[1] - ny)], paint, level)

    def text(self, words, size, paint):
        data = bpy.data.curves.new("words", "FONT")
        data.body, data.size = words, size
        data.align_x, data.align_y = "CENTER", "CENTER"
        data.materials.append(self.paint(paint))
        thing = bpy.data.objects.new(words, data)
        self.scene.collection.objects.link(thing)
        bpy.context.view_layer.update()
        return thing

    def label(self, words, at, paint="name", size=1.0):
        """Words on a plate near a point, where no other plate is, with a line to the point."""
        text = self.text(words, size * self.unit, paint)
        wide, high = text.dimensions[0] / 2 + 0.3 * self.unit, 0.72 * size * self.unit
        x, y = at
        for number in range(60):
            angle, far = number * 2.4, 0.45 * self.unit * math.sqrt(number)
            x = min(max(at[0] + 1.6 * far * math.cos(angle), wide), self.width - wide)
            y = min(max(at[1] + far * math.sin(angle), high), self.height - high)
            if not any(abs(x - tx) < wide + tw and abs(y - ty) < high + th for tx, ty, tw, th in self.taken):
                break
        self.taken.append((x, y, wide, high))
        self.level += 0.05
        self.line(at, (x, y), paint, 0.08)
        for grow, color, level in ((0.08 * self.unit, paint, 2.0), (0.0, "plate", 2.02)):
            self.polygon([(x - wide - grow, y - high - grow), (x + wide + grow, y - high - grow), (x + wide + grow, y + high + grow),
                          (x - wide - grow, y + high + grow)], color, level + self.level)
        text.location = (x, y, 2.04 + self.level)

    def render(self, path):
        scene = self.scene
        scene.render.engine = "CYCLES"
        scene.cycles.device, scene.cycles.samples, scene.cycles.use_denoising = "CPU", 12, False
        scene.render.film_transparent = True
        scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = self.width, self.height, 100
        scene.render.image_settings.file_format, scene.render.image_settings.color_mode = "PNG", "RGBA"
        set_first(scene.view_settings, "view_transform", ("Standard",))
        scene.render.filepath = path
        bpy.ops.render.render(write_still=True)


def lay_over(picture, sheet, path):
    """The sheet over the picture, by its transparency."""
    import numpy

    layers = []
    for name in (picture, sheet):
        image = bpy.data.images.load(name)
        values = numpy.empty(len(image.pixels), numpy.float32)
        image.pixels.foreach_get(values)
        layers.append(values.reshape(image.size[1], image.size[0], 4))
    below, above = layers
    alpha = above[:, :, 3:]
    mixed = below[:, :, :3] * (1 - alpha) + above[:, :, :3] * alpha
    height, width = mixed.shape[:2]
    write_png(path, width, height, (numpy.clip(mixed[::-1], 0, 1) * 255 + 0.5).astype(numpy.uint8).tobytes())


def write_overlay(stay, out, meshes, picture, path):
    """The picture with words. Builds a scene of its own: nothing of the room's is there afterwards."""
    view = View(stay, CAMERA["width"], CAMERA["height"])
    small = View(stay, 480, max(1, round(480 * view.height / view.width)))
    things = things_seen(out, meshes)
    scale = view.width / small.width
    middles = {name: (x * scale, y * scale) for name, (x, y) in middles_seen(small, things, cast_all(small, things)[0]).items()}
    sheet = Sheet(view.width, view.height)
    for row in FAILED:
        points = [middles[name] for name in row["targets"] if name in middles]
        for a, b in zip(points, points[1:]):
            sheet.line(a, b, "failed", 0.22, 1.5)
        if points:
            at = [sum(p[i] for p in points) / len(points) for i in (0, 1)]
            sheet.label(row["words"], at, "failed", 1.0)
    for row in OBJECTS:
        if row["id"] not in out:
            sheet.label(row["id"].replace("_", " "), middles[row["id"]])
    for row in OBJECTS:
        sides = [side for side in row["uses"] if side in ("front", "back", "left", "right")]
        if not sides or row["stands_on"] != "floor" or row["id"] in out:
            continue
        start, end, reach = free_way(row, sides[0])
        a, b = project(view, (*start, 0.02)), project(view, (*end, 0.02))
        paint = "failed" if reach < 0.4 else "clear"
        if reach > 0.05:
            sheet.line(a, b, paint, 0.14)
            sheet.label(f"{reach:.2f} m", ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), paint, 0.75)
    layer = path + ".layer.png"
    sheet.render(layer)
    lay_over(picture, layer, path)
    os.remove(layer)
