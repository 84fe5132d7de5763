"""Forty scenes with one planted conflict each, as a model might hand them over."""

WALLS = ["wall1", "wall2", "wall3", "wall4"]


def thing(name, w=None, d=None, h=0.8):
    item = {"id": name, "category": name.rstrip("_0123456789")}
    if w:
        item["dims"] = {"w": w, "d": d, "h": h}
    return item


def relation(kind, target, reference=None, **more):
    out = {"id": f"{kind}_{target}", "type": kind, "targets": target.split(), **more}
    if reference:
        out["relativeTo"] = reference.split()
    return out


def scene(w, d, furniture, constraints):
    return {
        "metadata": {"roomType": "bedroom"},
        "room": {"dims": {"w": w, "d": d, "h": 2.6}, "openings": []},
        "furniture": furniture,
        "constraints": constraints,
    }


def conflicts():
    """(name, scene) of each."""
    # The paper's own: a bed flush left and a wardrobe flush right on one wall, together wider than the room.
    yield (
        "paper",
        scene(
            3,
            3.6,
            [thing("bed_1", 1.8, 2), thing("wardrobe_1", 1.6, 0.6, 2)],
            [
                relation("againstWall", "bed_1", "wall3"),
                relation("againstWall", "wardrobe_1", "wall3"),
                relation("sideAgainstWall", "bed_1", "wall4"),
                relation("sideAgainstWall", "wardrobe_1", "wall2"),
            ],
        ),
    )
    # Too wide together at one wall.
    pairs = [("bed_1", "wardrobe_1"), ("sofa_1", "bookshelf_1"), ("desk_1", "dresser_1"), ("bed_1", "desk_1"), ("sofa_1", "sideboard_1")]
    for first, second in pairs:
        for number, wall in enumerate(("wall3", "wall4")):
            side = 3.0 + 0.2 * number
            yield (
                f"wide {first} {second} {wall}",
                scene(
                    side if wall == "wall3" else 4,
                    side if wall == "wall4" else 4,
                    [thing(first, 1.7, 0.9), thing(second, 1.8, 0.5, 1.2)],
                    [relation("againstWall", first, wall), relation("againstWall", second, wall)],
                ),
            )
    # At two walls at once.
    for name, one, other in (
        ("bed_1", "wall3", "wall1"),
        ("desk_1", "wall2", "wall4"),
        ("sofa_1", "wall1", "wall3"),
        ("wardrobe_1", "wall4", "wall2"),
    ):
        yield (
            f"two walls {name}",
            scene(4, 4, [thing(name)], [relation("againstWall", name, one), {**relation("againstWall", name, other), "id": "second"}]),
        )
    # On two sides of one thing.
    sides = [("leftOf", "rightOf"), ("rightOf", "leftOf"), ("inFrontOf", "behind"), ("behind", "inFrontOf")]
    for one, other in sides:
        for host in ("bed_1", "desk_1"):
            yield (
                f"{one} and {other} of {host}",
                scene(4.5, 4.5, [thing(host), thing("plant_1")], [relation(one, "plant_1", host), relation(other, "plant_1", host)]),
            )
    # Near and far.
    for name in ("armchair_1", "plant_1", "stool_1"):
        yield (
            f"near and far {name}",
            scene(
                5,
                4,
                [thing("bed_1"), thing(name)],
                [relation("nextTo", name, "bed_1"), relation("distance", name, "bed_1", min=2.0, max=3.0)],
            ),
        )
    # In the middle and in a corner or at a wall.
    for name in ("coffee_table_1", "bed_1", "desk_1"):
        yield (f"middle and corner {name}", scene(5, 4, [thing(name)], [relation("centerOfRoom", name), relation("corner", name)]))
        yield (
            f"middle and wall {name}",
            scene(5, 5, [thing(name)], [relation("centerOfRoom", name), relation("againstWall", name, "wall3")]),
        )
    # A thing too large for the room.
    for name, w in (("sofa_1", 2.6), ("bed_1", 2.4), ("wardrobe_1", 2.5)):
        yield (f"too large {name}", scene(2.3, 2.2, [thing(name, w, 0.9 if name != "bed_1" else 2.3)], []))
    # Too many at one wall.
    for count in (3, 4):
        names = [f"desk_{i + 1}" for i in range(count)]
        yield (
            f"{count} desks",
            scene(1.2 * count, 5, [thing(name, 1.4, 0.6) for name in names], [relation("againstWall", name, "wall3") for name in names]),
        )
    yield (
        "two in the middle",
        scene(5, 5, [thing("bed_1"), thing("desk_1")], [relation("centerOfRoom", "bed_1"), relation("centerOfRoom", "desk_1")]),
    )
    yield (
        "touching both ends",
        scene(
            6,
            3,
            [thing("bed_1"), thing("desk_1")],
            [relation("touching", "desk_1", "bed_1"), relation("distance", "desk_1", "bed_1", min=1.5, max=4)],
        ),
    )
    yield (
        "opposite and beside",
        scene(
            5,
            5,
            [thing("sofa_1"), thing("armchair_1")],
            [relation("opposite", "armchair_1", "sofa_1"), relation("touching", "armchair_1", "sofa_1")],
        ),
    )
    yield (
        "two corners",
        scene(4, 4, [thing("plant_1"), thing("desk_1")], [relation("corner", "plant_1"), relation("centerOfRoom", "plant_1")]),
    )
