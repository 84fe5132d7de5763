# ---- Geometry: the camera's axes, which walls stay, what the picture frames. Plain Python, nothing of Blender. ----------------------
import math

BASE_DEPTH = 0.12  # metres of the slab that is seen under the floor at the cut edges
BASE_GAP = 0.002   # the slab's top lies this much under the floor, so that no two faces share a plane


# What a view changes of CAMERA. "inside": the camera stands in the room (at CAMERA["eye"]); all walls and the ceiling are in the picture.
VIEW_CAMERAS = {"iso": {}, "top": {"azimuth": 0.0, "elevation": 90.0, "orthographic": True},
                "front": {"azimuth": 0.0, "elevation": 24.0, "orthographic": False, "lens_angle": 38.0},
                "eye": {"inside": True, "orthographic": False, "lens_angle": 76.0},
                "door": {"inside": True, "orthographic": False, "lens_angle": 80.0}}
EYE_HEIGHT = 1.6
USUAL_CAMERA = dict(CAMERA)


def picture_of(view):
    return OUTPUT["picture"] if view == "iso" else OUTPUT["picture"].replace(".png", f"-{view}.png")


def use_view(view, turn=0.0):
    """Makes CAMERA that of a view; `turn` degrees further round the room."""
    CAMERA.clear()
    CAMERA.update({**USUAL_CAMERA, "view": view, **VIEW_CAMERAS[view]})
    CAMERA["azimuth"] += turn


def stand_at(point, target):
    """Puts the camera of an inside view at a point, looking at another."""
    way = [t - p for t, p in zip(target, point)]
    length = math.sqrt(dot(way, way)) or 1.0
    CAMERA["eye"] = tuple(point)
    CAMERA["azimuth"] = math.degrees(math.atan2(-way[0], way[1]))
    CAMERA["elevation"] = math.degrees(math.asin(-way[2] / length))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def view_axes():
    """Unit vectors right, up and toward (from the room to the camera) of the picture, in the room's frame."""
    azimuth, elevation = math.radians(CAMERA["azimuth"]), math.radians(CAMERA["elevation"])
    toward = (math.cos(elevation) * math.sin(azimuth), -math.cos(elevation) * math.cos(azimuth), math.sin(elevation))
    right = (math.cos(azimuth), math.sin(azimuth), 0.0)
    up = (-math.sin(elevation) * math.sin(azimuth), math.sin(elevation) * math.cos(azimuth), math.cos(elevation))
    return right, up, toward


def inward_normal(wall):
    """The wall's normal in the plan that points into the room: to the left of start → end."""
    dx, dy = wall["end"][0] - wall["start"][0], wall["end"][1] - wall["start"][1]
    length = math.hypot(dx, dy) or 1.0
    return (-dy / length, dx / length)


def well_inside(point, polygon, margin=0.02):
    """True where the point lies in the polygon and at least `margin` from its edges."""
    x, y = point
    inside = False
    for (ax, ay), (bx, by) in zip(polygon, polygon[1:] + polygon[:1]):
        dx, dy = bx - ax, by - ay
        t = max(0.0, min(1.0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)))
        if math.hypot(ax + t * dx - x, ay + t * dy - y) < margin:
            return False
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * dx:
            inside = not inside
    return inside


def hides_the_room(wall):
    """True where the wall, seen from the camera, stands before some of the floor (rooms with inner corners)."""
    toward = view_axes()[2]
    across = math.hypot(toward[0], toward[1])
    if across < 1e-6:
        return False
    reach = ROOM["height"] * across / toward[2] if toward[2] > 1e-6 else 100.0
    away = (-toward[0] / across, -toward[1] / across)
    normal = inward_normal(wall)
    length = math.hypot(wall["end"][0] - wall["start"][0], wall["end"][1] - wall["start"][1])
    steps_along, steps_back = max(2, int(length / 0.1)), max(2, int(reach / 0.05))
    for i in range(steps_along + 1):
        t = i / steps_along
        for depth in (0.0, wall["thickness"]):
            x = wall["start"][0] + t * (wall["end"][0] - wall["start"][0]) - normal[0] * depth
            y = wall["start"][1] + t * (wall["end"][1] - wall["start"][1]) - normal[1] * depth
            for k in range(1, steps_back + 1):
                s = reach * k / steps_back
                if well_inside((x + away[0] * s, y + away[1] * s), ROOM["polygon"]):
                    return True
    return False


def walls_that_stay():
    """Ids of the walls whose inner face the camera sees and that hide nothing of the room. The others are cut away."""
    if CAMERA.get("inside") or CAMERA.get("all_walls"):
        return {wall["id"] for wall in WALLS}
    toward = view_axes()[2]
    return {wall["id"] for wall in WALLS if dot(inward_normal(wall), toward) > -1e-6 and not hides_the_room(wall)}


def outer_outline():
    """The room's outline along the outer faces of its walls, counter-clockwise, corners mitred."""
    corners = []
    for before, wall in zip(WALLS[-1:] + WALLS[:-1], WALLS):
        (nx, ny), (mx, my) = inward_normal(before), inward_normal(wall)
        t, u = before["thickness"], wall["thickness"]
        x, y = wall["start"]
        cross = nx * my - ny * mx
        if abs(cross) < 1e-3:  # two walls on one line
            corners.append((x - mx * u, y - my * u))
        else:  # where the two outer faces meet
            corners.append((x + (-t * my + u * ny) / cross, y + (-u * nx + t * mx) / cross))
    return corners


def box_corners(row):
    """The eight corners of an object's box in the room's frame."""
    w, d, h = row["size"]
    turn = math.radians(row["turn"])
    c, s = math.cos(turn), math.sin(turn)
    x, y, z = row["at"]
    return [(x + c * a - s * b, y + s * a + c * b, z + e)
            for a in (-w / 2, w / 2) for b in (-d / 2, d / 2) for e in (0, h)]


def framed_points(stay):
    """Everything the picture must hold: the slab, the walls that stay, every object."""
    outline = outer_outline()
    points = [(x, y, -BASE_DEPTH) for x, y in outline] + [(x, y, 0.0) for x, y in outline]
    for i, wall in enumerate(WALLS):
        if wall["id"] in stay:
            for x, y in (outline[i], outline[(i + 1) % len(outline)], wall["start"], wall["end"]):
                points.append((x, y, ROOM["height"]))
    for row in OBJECTS:
        points += box_corners(row)
    return points


def frame(stay):
    """Camera position, and the picture's width in metres (orthographic) or the lens's half angle (perspective)."""
    right, up, toward = view_axes()
    if CAMERA.get("inside"):
        return CAMERA["eye"], math.radians(CAMERA["lens_angle"]) / 2
    points = framed_points(stay)
    aspect = CAMERA["width"] / CAMERA["height"]
    xs, ys, zs = ([dot(p, axis) for p in points] for axis in (right, up, toward))
    front = max(zs)
    about = CAMERA.get("about")  # a point that stays in the middle (turntable); otherwise what is in the picture is centred
    cx, cy = (dot(about, right), dot(about, up)) if about else ((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2)
    grow = 1 / (1 - 2 * CAMERA["margin"])
    if CAMERA["orthographic"]:
        across, along = max(max(xs) - cx, cx - min(xs)), max(max(ys) - cy, cy - min(ys))
        width = max(2 * across * grow, 2 * along * aspect * grow, CAMERA.get("least_width", 0.0))
        distance, measure = front + 5.0, width
    else:
        measure = math.radians(CAMERA["lens_angle"]) / 2
        tan_x = math.tan(measure) / grow
        tan_y = tan_x / aspect
        distance = max(max(z + abs(x - cx) / tan_x, z + abs(y - cy) / tan_y) for x, y, z in zip(xs, ys, zs))
    position = tuple(cx * r + cy * u + distance * t for r, u, t in zip(right, up, toward))
    return position, measure
