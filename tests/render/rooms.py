"""Furnished rooms as layout files, written by hand."""


def thing(category, size, pos, rotation=0, on="floor", mount=None):
    mounts = {"floor": "floor", "ceiling": "ceiling"}
    return {
        "category": category,
        "size": size,
        "pos": pos,
        "rotation": rotation,
        "supportedBy": on,
        "mount": mount or mounts.get(on, "wall" if on.startswith("wall") else "surface"),
    }


def room(polygon, height, things, openings=()):
    """A layout of these things; ids are category_1, category_2…"""
    walls = [
        {"id": f"wall{i + 1}", "start": a, "end": b, "thickness": 0.1}
        for i, (a, b) in enumerate(zip(polygon, polygon[1:] + polygon[:1], strict=True))
    ]
    counts = {}
    objects = []
    for row in things:
        counts[row["category"]] = counts.get(row["category"], 0) + 1
        name = row["category"].replace("_", " ")
        objects.append({"id": f"{row['category']}_{counts[row['category']]}", "name": name, "attributes": [], **row})
    return {
        "format": "layoutbox/layout@1",
        "prompt": "a room written by hand",
        "roomType": "bedroom",
        "status": "solved",
        "room": {"polygon": polygon, "height": height, "walls": walls, "openings": list(openings)},
        "objects": objects,
        "relations": [],
        "relaxed": [],
        "conflicts": [],
        "score": {"total": 1, "terms": {}},
        "stats": {"solver": "hand", "seed": 1, "seconds": 0, "proven": False},
    }


def box(width, depth):
    return [[0, 0], [width, 0], [width, depth], [0, depth]]


DOOR = {"id": "door1", "type": "door", "wall": "wall1", "offset": 0.3, "w": 0.8, "h": 2.0, "sill": 0, "swing": "in-left"}
WINDOW = {"id": "window1", "type": "window", "wall": "wall4", "offset": 1.0, "w": 1.2, "h": 1.2, "sill": 0.9, "swing": "none"}

BEDROOM = room(
    box(4, 3.2),
    3.0,
    [
        thing("bed", [1.6, 2.0, 0.9], [2, 2.18, 0]),
        thing("nightstand", [0.45, 0.4, 0.5], [0.9, 2.98, 0]),
        thing("table_lamp", [0.22, 0.22, 0.4], [0.9, 2.98, 0.5], on="nightstand_1"),
        thing("desk", [1.2, 0.6, 0.75], [3.68, 0.8, 0], 270),
        thing("chair", [0.45, 0.5, 0.9], [3.2, 0.8, 0], 90),
        thing("wardrobe", [1.0, 0.6, 2.0], [0.32, 0.6, 0], 90),
        thing("floor_lamp", [0.35, 0.35, 1.6], [0.3, 2.9, 0]),
        thing("rug", [1.2, 0.8, 0.01], [1.9, 0.6, 0]),
        thing("picture", [0.6, 0.03, 0.4], [2, 3.18, 1.6], on="wall3"),
        thing("curtain", [3.0, 0.1, 2.2], [2, 0.05, 0], 180, on="wall1"),
        thing("pendant_light", [0.35, 0.35, 0.7], [3.2, 2, 2.3], on="ceiling"),
    ],
    [DOOR, WINDOW],
)

# Shelves at a wall that is cut away: a deep one hides the room, a small one only what lies on it.
SHELVES = room(
    box(4, 3.2),
    2.6,
    [
        thing("desk", [1.6, 0.7, 0.75], [2.2, 1.0, 0], 180),
        thing("wall_shelf", [2.6, 0.9, 0.04], [2.4, 0.45, 1.6], 180, on="wall1"),
        thing("vase", [0.2, 0.2, 0.3], [2.4, 0.45, 1.64], on="wall_shelf_1"),
        thing("wall_shelf", [0.4, 0.15, 0.04], [0.4, 0.075, 1.2], 180, on="wall1"),
        thing("book", [0.36, 0.14, 0.05], [0.4, 0.075, 1.24], 180, on="wall_shelf_2"),
        thing("bookshelf", [0.8, 0.3, 1.8], [2, 3.05, 0]),
    ],
    [DOOR],
)

SMALLEST = room(box(1.5, 1.5), 2.4, [thing("chair", [0.45, 0.5, 0.9], [0.75, 0.75, 0])], [{**DOOR, "w": 0.7}])

LARGEST = room(
    box(20, 15),
    3.0,
    [thing("dining_table", [1.8, 0.9, 0.75], [3 + 3.5 * i, 3 + 4.5 * k, 0]) for i in range(5) for k in range(3)],
    [DOOR, WINDOW],
)

HIGH = room(box(3, 2.5), 6.0, [thing("bed", [1.4, 2.0, 0.9], [1.5, 1.45, 0])], [DOOR])

# An inner corner at the front left: its walls stand before the rest of the room.
L_SHAPED = room(
    [[0, 2], [2, 2], [2, 0], [5, 0], [5, 4], [0, 4]],
    2.6,
    [thing("sofa", [2.0, 0.9, 0.8], [3.5, 3.53, 0]), thing("bookshelf", [0.8, 0.3, 1.8], [0.17, 3, 0], 90)],
    [{**DOOR, "wall": "wall3", "offset": 0.5}],
)
