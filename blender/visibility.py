# ---- What the camera sees of each object: one ray a pixel, no graphics card. ---------------------------------------------------------
import json
import math
import struct
import zlib

from mathutils import Vector
from mathutils.bvhtree import BVHTree


def in_room(row, meshes):
    """An object's triangles in the room's frame."""
    turn = math.radians(row["turn"])
    c, s = math.cos(turn), math.sin(turn)
    ox, oy, oz = row["at"]
    positions, _, _, indices, _ = join(row["parts"], meshes)
    vertices = [(ox + c * positions[i] - s * positions[i + 1], oy + s * positions[i] + c * positions[i + 1], oz + positions[i + 2])
                for i in range(0, len(positions), 3)]
    return vertices, [tuple(indices[i:i + 3]) for i in range(0, len(indices), 3)]


class View:
    """The camera's pixels as rays, at a resolution of its own."""

    def __init__(self, stay, width, height):
        self.width, self.height = width, height
        self.right, self.up, self.toward = (Vector(axis) for axis in view_axes())
        position, self.measure = frame(stay)
        self.eye = Vector(position)

    def ray(self, column, row):
        x, y = (column + 0.5) / self.width - 0.5, (0.5 - (row + 0.5) / self.height) * self.height / self.width
        if CAMERA["orthographic"]:
            return self.eye + self.right * (x * self.measure) + self.up * (y * self.measure), -self.toward
        spread = 2 * math.tan(self.measure)
        return self.eye, (self.right * (x * spread) + self.up * (y * spread) - self.toward).normalized()

    def rectangle(self, vertices):
        """The pixels that a thing can cover: first column, last column, first row, last row."""
        columns, rows = [], []
        for vertex in vertices:
            ray = Vector(vertex) - self.eye
            x, y, far = ray.dot(self.right), ray.dot(self.up), -ray.dot(self.toward)
            size = self.measure if CAMERA["orthographic"] else 2 * math.tan(self.measure) * far
            columns.append((x / size + 0.5) * self.width)
            rows.append((0.5 - y / size * self.width / self.height) * self.height)
        clip = lambda v, top: max(0, min(top, int(v)))
        return (clip(min(columns) - 1, self.width - 1), clip(max(columns) + 1, self.width - 1),
                clip(min(rows) - 1, self.height - 1), clip(max(rows) + 1, self.height - 1))


def cast_all(view, things):
    """For each pixel the number of the thing that is seen, or -1."""
    vertices, triangles, owners = [], [], []
    for number, (_, (points, faces)) in enumerate(things):
        first = len(vertices)
        vertices += points
        triangles += [(a + first, b + first, c + first) for a, b, c in faces]
        owners += [number] * len(faces)
    tree = BVHTree.FromPolygons(vertices, triangles, all_triangles=True)
    seen, hits = [], []
    for row in range(view.height):
        for column in range(view.width):
            start, way = view.ray(column, row)
            point, _, face, _ = tree.ray_cast(start, way)
            seen.append(-1 if face is None else owners[face])
            hits.append(point)
    return seen, hits


def pixels_alone(view, points, faces):
    """The pixels that a thing covers where nothing else stands in the way, with the point that is hit."""
    tree = BVHTree.FromPolygons(points, faces, all_triangles=True)
    left, right, top, bottom = view.rectangle(points)
    covered = {}
    for row in range(top, bottom + 1):
        for column in range(left, right + 1):
            point = tree.ray_cast(*view.ray(column, row))[0]
            if point is not None:
                covered[row * view.width + column] = point
    return covered


def under_furniture(point):
    """True where a floor point lies in the footprint of something."""
    for row in OBJECTS:
        turn = math.radians(row["turn"])
        dx, dy = point[0] - row["at"][0], point[1] - row["at"][1]
        x, y = math.cos(turn) * dx + math.sin(turn) * dy, -math.sin(turn) * dx + math.cos(turn) * dy
        if abs(x) <= row["size"][0] / 2 and abs(y) <= row["size"][1] / 2 and row["at"][2] < 2.0:
            return True
    return False


def things_seen(out, meshes):
    """Everything in the picture, with its triangles."""
    return [(row, in_room(row, meshes)) for row in SHELL + OBJECTS if row["parts"] and row["id"] not in out]


def with_what_they_carry(ids):
    """The ids with those of everything that stands on them: nothing is left in the air."""
    ids = set(ids)
    while True:
        carried = {row["id"] for row in OBJECTS if row["stands_on"] in ids} - ids
        if not carried:
            return ids
        ids |= carried


def hangers_in_the_way(stay, out, meshes, width=240, height=135):
    """Ids of things on walls that are cut away and that nobody asked for, or that hide much of the floor or of an object that was
    asked for, with what they carry. The others stay where they hang."""
    hangers = [row for row in OBJECTS if row["hangs_on"] and row["hangs_on"] not in stay]
    if not hangers:
        return set()
    away = {row["id"] for row in hangers if not row["asked"]}
    view = View(stay, width, height)
    ids = with_what_they_carry(row["id"] for row in hangers)
    things = [thing for thing in things_seen(out, meshes) if thing[0]["id"] not in ids]
    seen, _ = cast_all(view, things)
    pixels = {number: seen.count(number) for number in set(seen)}
    for row in hangers:
        if row["id"] in away:
            continue
        hidden = [seen[pixel] for pixel in pixels_alone(view, *in_room(row, meshes))]
        for number in set(hidden) - {-1}:
            most = 0.1 if things[number][0]["kind"] == "floor" else 0.35
            counts = things[number][0]["kind"] == "floor" or (things[number][0]["kind"] == "object" and things[number][0]["asked"])
            if counts and hidden.count(number) > most * pixels[number]:
                away.add(row["id"])
    return with_what_they_carry(away)


def measure_visibility(stay, out, meshes, width=480, height=270):
    """Shares of each object and of the free floor that the camera sees, and what the walls hide (it should be nothing)."""
    view = View(stay, width, height)
    things = things_seen(out, meshes)
    seen, _ = cast_all(view, things)
    # A door's open leaf hides what is behind it, and is no wall: what it hides is in "behind".
    walls = {number for number, (row, _) in enumerate(things) if row["kind"] == "wall"}
    report = {"width": width, "height": height, "objects": {}, "behindWalls": 0, "leftOut": []}
    for number, (row, (points, faces)) in enumerate(things):
        if row["kind"] not in ("object", "floor"):
            continue
        covered = pixels_alone(view, points, faces)
        visible = sum(1 for pixel in covered if seen[pixel] == number)
        hidden = [point for pixel, point in covered.items() if seen[pixel] in walls]
        # What lies under a skirting board is not hidden, nor is the edge at which a thing meets its wall.
        rim = 0.05 if row["kind"] == "floor" else 0.01
        hidden = [point for point in hidden if well_inside(point[:2], ROOM["polygon"], rim)]
        report["behindWalls"] += len(hidden)
        if row["kind"] == "floor":
            free = [pixel for pixel, point in covered.items() if not under_furniture(point)]
            report["floor"] = {"free": len(free), "seen": sum(1 for pixel in free if seen[pixel] == number)}
        else:
            hiders = sorted({things[seen[p]][0]["id"] for p in covered if seen[p] not in (number, -1)})
            report["objects"][row["id"]] = {"pixels": visible, "alone": len(covered),
                                            "visible": round(visible / len(covered), 4) if covered else 0.0, "behind": hiders}
    report["leftOut"] = [row["id"] for row in OBJECTS if row["id"] in out]
    return report


def floor_center():
    xs, ys = zip(*ROOM["polygon"])
    return ((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2)


def blocked(point, gap=0.25):
    """True where somebody who stands at the point would stand in a piece of furniture, or right before one that is high."""
    for row in OBJECTS:
        turn = math.radians(row["turn"])
        dx, dy = point[0] - row["at"][0], point[1] - row["at"][1]
        x, y = math.cos(turn) * dx + math.sin(turn) * dy, -math.sin(turn) * dx + math.cos(turn) * dy
        low, high = row["at"][2], row["at"][2] + row["size"][2]
        room = gap if high > 1.1 else -0.05
        if abs(x) <= row["size"][0] / 2 + room and abs(y) <= row["size"][1] / 2 + room and low < EYE_HEIGHT + 0.2 and high > 0.9:
            return True
    return False


def standing_places():
    """Where the camera of an inside view may stand: in the corners and along the walls, a step away from them."""
    polygon, places = ROOM["polygon"], []
    for (ax, ay), (bx, by) in zip(polygon, polygon[1:] + polygon[:1]):
        length = math.hypot(bx - ax, by - ay)
        normal = (-(by - ay) / length, (bx - ax) / length)
        for share in (0.06, 0.3, 0.5, 0.7, 0.94):
            for step in (0.3, 0.55, 0.9):
                places.append((ax + share * (bx - ax) + normal[0] * step, ay + share * (by - ay) + normal[1] * step))
    return [place for place in places if well_inside(place, polygon, 0.25)]


def stand_in_the_room(meshes):
    """Puts the eye view's camera where most of the furniture is seen, all of it if possible, from as far as possible."""
    vertices, triangles = [], []
    for row in SHELL + OBJECTS:
        if row["parts"] and row["kind"] != "ceiling":
            points, faces = in_room(row, meshes)
            first = len(vertices)
            vertices += points
            triangles += [(a + first, b + first, c + first) for a, b, c in faces]
    tree = BVHTree.FromPolygons(vertices, triangles, all_triangles=True)
    height = min(EYE_HEIGHT, ROOM["height"] - 0.3)
    targets = [Vector((row["at"][0], row["at"][1], row["at"][2] + row["size"][2] + 0.02)) for row in OBJECTS if row["at"][2] < 2.0]
    center = floor_center()
    if targets:
        center = [sum(t[i] for t in targets) / len(targets) for i in (0, 1)]
    half = math.radians(CAMERA["lens_angle"]) / 2

    def worth(place):
        eye, points = Vector((*place, height)), 0.0
        heading = math.atan2(center[1] - place[1], center[0] - place[0])
        for target in targets:
            way = target - eye
            off = abs((math.atan2(way.y, way.x) - heading + math.pi) % (2 * math.pi) - math.pi)
            hit = tree.ray_cast(eye, way.normalized(), way.length - 0.05)[0]
            points += (off < 0.9 * half) * (1.0 if hit is None else 0.3)
        clear = tree.ray_cast(eye, Vector((math.cos(heading), math.sin(heading), -0.1)).normalized(), 8.0)[3]
        return points + 0.25 * math.dist(place, center) + 0.2 * min(clear if clear is not None else 8.0, 3.0)

    places = standing_places()
    place = max([p for p in places if not blocked(p)] or places or [center], key=worth)
    stand_at((*place, height), (*center, 0.75))


def stand_in_the_door(meshes):
    """Puts the camera into the doorway, looking across the room; where there is no door, as for the eye view."""
    doors = sorted((o for o in OPENINGS if o["type"] in ("door", "open")), key=lambda o: o["type"])
    walls = {wall["id"]: wall for wall in WALLS}
    if not doors or doors[0]["wall"] not in walls:
        return stand_in_the_room(meshes)
    door, wall = doors[0], walls[doors[0]["wall"]]
    (ax, ay), (bx, by) = wall["start"], wall["end"]
    length, normal, middle = math.hypot(bx - ax, by - ay), inward_normal(wall), door["offset"] + door["w"] / 2
    x, y = ax + (bx - ax) / length * middle, ay + (by - ay) / length * middle
    height = min(EYE_HEIGHT, door["h"] - 0.25)
    center = floor_center()
    ahead = (x + 3.0 * normal[0], y + 3.0 * normal[1])
    CAMERA["stands_in"] = door["id"]
    stand_at((x + 0.06 * normal[0], y + 0.06 * normal[1], height),
             (0.5 * center[0] + 0.5 * ahead[0], 0.5 * center[1] + 0.5 * ahead[1], 0.8))
    return None


def mask_color(number):
    """Colours that differ clearly from one number to the next; 0 is the background's black."""
    return (number * 97 % 251 + 4, number * 57 % 241 + 14, number * 163 % 239 + 16) if number else (0, 0, 0)


def write_png(path, width, height, pixels):
    """A PNG of RGB pixels, byte for byte as given (Blender's own writer would change the colours)."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    lines = b"".join(b"\0" + bytes(pixels[3 * width * y:3 * width * (y + 1)]) for y in range(height))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
                   + chunk(b"IDAT", zlib.compress(lines, 6)) + chunk(b"IEND", b""))


def write_mask(stay, out, meshes, picture_path, index_path):
    """Each thing in a colour of its own, at the picture's size, and a JSON file that says whose colour is whose."""
    view = View(stay, CAMERA["width"], CAMERA["height"])
    things = things_seen(out, meshes)
    seen, _ = cast_all(view, things)
    colors = [bytes(mask_color(number)) for number in range(len(things) + 1)]
    write_png(picture_path, view.width, view.height, b"".join(colors[number + 1] for number in seen))
    index = [{"id": row["id"], "kind": row["kind"], "category": row["category"], "color": list(mask_color(number))}
             for number, (row, _) in enumerate(things, 1)]
    with open(index_path, "w", encoding="utf-8") as file:
        json.dump({"things": index, "visibility": measure_visibility(stay, out, meshes)}, file, indent=1)
        file.write("\n")
