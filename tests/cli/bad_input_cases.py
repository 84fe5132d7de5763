"""The table of wrong inputs: what a user may do by mistake, the exit status it must have, and words that must be in the error.

Each case is (name, arguments, status, words). `{dir}` in an argument is a temporary folder, `{out}` an output folder in it; FILES are
written into that folder first. A word list is matched without regard to case; each word must stand in stderr.
"""

from __future__ import annotations

import json

WALLS = [
    {"id": "wall1", "start": [0, 0], "end": [4, 0]},
    {"id": "wall2", "start": [4, 0], "end": [4, 3]},
    {"id": "wall3", "start": [4, 3], "end": [0, 3]},
    {"id": "wall4", "start": [0, 3], "end": [0, 0]},
]


def scene(**changes: object) -> str:
    """A small good scene with some members replaced."""
    base: dict[str, object] = {
        "metadata": {"roomType": "bedroom", "units": "m"},
        "room": {"dims": {"w": 4, "d": 3, "h": 2.6}},
        "furniture": [{"id": "bed", "category": "bed"}, {"id": "desk", "category": "desk"}],
        "constraints": [{"id": "c1", "type": "againstWall", "targets": ["bed"], "relativeTo": "wall3"}],
    }
    base.update(changes)
    return json.dumps({key: value for key, value in base.items() if value is not None})


def room(**changes: object) -> dict[str, object]:
    return {"dims": {"w": 4, "d": 3, "h": 2.6}, **changes}


def furniture(**changes: object) -> list[dict[str, object]]:
    return [{"id": "bed", "category": "bed", **changes}]


def constraint(**changes: object) -> list[dict[str, object]]:
    return [{"id": "c1", "type": "againstWall", "targets": ["bed"], "relativeTo": "wall3", **changes}]


FILES: dict[str, str | bytes] = {
    "good.json": scene(),
    "not-json.json": "this is no JSON",
    "cut.json": scene()[:100],
    "empty.json": "",
    "blank.json": "  \n ",
    "array.json": "[1, 2, 3]",
    "number.json": "42",
    "null.json": "null",
    "nan.json": scene().replace("2.6", "NaN"),
    "infinity.json": scene().replace("2.6", "1e999"),
    "trailing-comma.json": scene()[:-1] + ",}",
    "binary.json": bytes(range(256)),
    "deep.json": "[" * 100_000,
    "bad-utf8.json": b'{"metadata": {"projectId": "\xff\xfe"}}',
    "unknown-key.json": scene(furnitur=[]),
    "unknown-key-object.json": scene(furniture=furniture(colour="red")),
    "furniture-not-list.json": scene(furniture="bed"),
    "furniture-number.json": scene(furniture=[7]),
    "dims-string.json": scene(room=room(dims={"w": "wide", "d": 3, "h": 2.6})),
    "negative-size.json": scene(furniture=furniture(dims={"w": -1, "d": 2, "h": 0.5})),
    "zero-size.json": scene(furniture=furniture(dims={"w": 0, "d": 2, "h": 0.5})),
    "enormous-object.json": scene(furniture=furniture(dims={"w": 1e9, "d": 2, "h": 0.5})),
    "room-zero.json": scene(room=room(dims={"w": 0, "d": 3, "h": 2.6})),
    "room-negative.json": scene(room=room(dims={"w": 4, "d": -3, "h": 2.6})),
    "room-10km.json": scene(room=room(dims={"w": 10000, "d": 10000, "h": 2.6})),
    "id-twice.json": scene(furniture=[{"id": "bed", "category": "bed"}, {"id": "bed", "category": "bed"}]),
    "id-empty.json": scene(furniture=[{"id": "", "category": "bed"}]),
    "no-category.json": scene(furniture=[{"id": "thing"}]),
    "relation-to-nobody.json": scene(constraints=constraint(targets=["bedd"])),
    "relation-unknown-reference.json": scene(constraints=constraint(type="nextTo", relativeTo="sofa")),
    "relation-unknown-type.json": scene(constraints=constraint(type="aganstWall")),
    "relation-no-targets.json": scene(constraints=constraint(targets=[])),
    "relation-no-reference.json": scene(constraints=constraint(type="nextTo", relativeTo=None)),
    "wall-gap.json": scene(room=room(walls=[*WALLS[:3], {"id": "wall4", "start": [0, 2], "end": [0, 0]}])),
    "walls-one.json": scene(room={"walls": WALLS[:1]}, constraints=None),
    "wall-id-twice.json": scene(room=room(walls=[*WALLS[:3], {**WALLS[3], "id": "wall1"}])),
    "polygon-crosses.json": scene(room={"dims": {"h": 2.6}, "polygon": [[0, 0], [4, 3], [4, 0], [0, 3]]}),
    "polygon-line.json": scene(room={"dims": {"h": 2.6}, "polygon": [[0, 0], [4, 0]]}),
    "opening-outside.json": scene(room=room(openings=[{"id": "door1", "wallId": "wall1", "offset": 3.5, "w": 0.9, "h": 2, "sill": 0}])),
    "opening-no-wall.json": scene(room=room(openings=[{"id": "door1", "wallId": "wall9", "offset": 1, "w": 0.9, "h": 2, "sill": 0}])),
    "opening-too-high.json": scene(
        room=room(openings=[{"id": "w1", "type": "window", "wallId": "wall1", "offset": 1, "w": 1, "h": 9, "sill": 1}])
    ),
    "units-unknown.json": scene(metadata={"units": "parsec"}),
    "color-wrong.json": scene(materials=[{"id": "red", "color": [1, 2]}]),
    "many-errors.json": scene(
        furniture=[{"id": "a", "category": "bed", "dims": {"w": -1, "d": 1, "h": 1}}, {"id": "a", "category": 5}], furnitur=1
    ),
    "scene-newer.json": scene(format="layoutbox/scene@99"),
    "layout-empty.json": '{"format": "layoutbox/layout@1"}',
    "layout-no-polygon.json": '{"format": "layoutbox/layout@1", "room": {"height": 2.5}, "objects": []}',
    "a-file": "not a folder",
}

GENERATE_OUT = ["--no-render", "-o", "{out}"]

CASES: list[tuple[str, list[str], int, list[str]]] = [
    # the command line itself
    ("no command", [], 2, ["subcommand"]),
    ("unknown command", ["genrate", "a room"], 2, ["genrate"]),
    ("unknown option", ["generate", "a bedroom", "--colour", "red", *GENERATE_OUT], 2, ["--colour"]),
    ("option without value", ["generate", "a bedroom", "-o"], 2, ["-o"]),
    ("no prompt", ["generate"], 2, ["prompt"]),
    ("seed is negative", ["generate", "a bedroom", "--seed", "-1", *GENERATE_OUT], 2, ["--seed", "whole number"]),
    ("seed is empty", ["generate", "a bedroom", "--seed", "", *GENERATE_OUT], 2, ["--seed", "whole number"]),
    ("seed is too large", ["generate", "a bedroom", "--seed", "99999999999999999999", *GENERATE_OUT], 2, ["--seed", "19 digits"]),
    ("units that are none", ["generate", "a bedroom", "--units", "furlong", *GENERATE_OUT], 2, ["furlong", "ft"]),
    ("seed is a word", ["generate", "a bedroom", "--seed", "many", *GENERATE_OUT], 2, ["--seed"]),
    ("effort zero", ["generate", "a bedroom", "--effort", "0", *GENERATE_OUT], 2, ["--effort"]),
    ("negative time limit", ["generate", "a bedroom", "--time-limit", "-5", *GENERATE_OUT], 2, ["--time-limit"]),
    ("unknown planner", ["generate", "a bedroom", "--planner", "oracle", *GENERATE_OUT], 2, ["oracle", "offline"]),
    ("unknown conflict choice", ["generate", "a bedroom", "--on-conflict", "pray", *GENERATE_OUT], 2, ["pray", "relax"]),
    ("repair without a model", ["generate", "a bedroom", "--on-conflict", "repair", *GENERATE_OUT], 2, ["repair", "relax"]),
    ("unknown quality", ["generate", "a bedroom", "--quality", "superb", *GENERATE_OUT], 2, ["superb", "preview"]),
    ("unknown view", ["generate", "a bedroom", "--views", "iso,inside", *GENERATE_OUT], 2, ["inside", "iso"]),
    ("size without x", ["generate", "a bedroom", "--size", "1920", *GENERATE_OUT], 2, ["1920"]),
    ("size of nothing", ["generate", "a bedroom", "--size", "0x0", *GENERATE_OUT], 2, ["0x0"]),
    ("room of zero", ["generate", "a bedroom", "--room", "0x3x3", *GENERATE_OUT], 2, ["room"]),
    ("room of ten kilometres", ["generate", "a bedroom", "--room", "10000x10000x3", *GENERATE_OUT], 2, ["room"]),
    ("room of words", ["generate", "a bedroom", "--room", "big", *GENERATE_OUT], 2, ["big"]),
    ("unknown units", ["generate", "a bedroom", "--room", "4x3x3", "--units", "cubits", *GENERATE_OUT], 2, ["cubits"]),
    # prompts
    ("empty prompt", ["generate", "", *GENERATE_OUT], 2, ["nothing in the prompt"]),
    ("blank prompt", ["generate", " \n\t ", *GENERATE_OUT], 2, ["nothing in the prompt"]),
    ("prompt of punctuation", ["generate", "?!… — …", *GENERATE_OUT], 2, []),
    ("prompt in another language", ["generate", "Een slaapkamer met een bed en twee stoelen.", *GENERATE_OUT], 2, ["english"]),
    ("prompt in another script", ["generate", "一间带床的卧室", *GENERATE_OUT], 2, ["english"]),
    ("prompt without a room or a thing", ["generate", "Happiness is better than sorrow.", *GENERATE_OUT], 2, []),
    ("room in the text of zero", ["generate", "A bedroom of 0 x 0 x 0 m with a bed.", *GENERATE_OUT], 2, ["room"]),
    ("room in the text of ten kilometres", ["generate", "A bedroom of 10 km by 10 km with a bed.", *GENERATE_OUT], 2, ["room"]),
    # places
    ("output is a file", ["generate", "a bedroom", "--no-render", "-o", "{dir}/a-file"], 3, ["a-file"]),
    ("output below a file", ["generate", "a bedroom", "--no-render", "-o", "{dir}/a-file/out"], 3, ["a-file"]),
    ("output in /proc", ["generate", "a bedroom", "--no-render", "-o", "/proc/layoutbox"], 3, ["/proc/layoutbox"]),
    ("scene file missing", ["solve", "{dir}/nowhere.json"], 3, ["nowhere.json"]),
    ("scene is a folder", ["solve", "{dir}"], 3, []),
    ("layout file missing", ["verify", "{dir}/nowhere.json"], 3, ["nowhere.json"]),
    ("export without a format", ["export", "{dir}/good.json", "-o", "{dir}/x"], 2, ["glb"]),
    ("export to an unknown format", ["export", "{dir}/good.json", "-o", "{dir}/x.docx"], 2, ["docx", "glb"]),
    ("export of a scene", ["export", "{dir}/good.json", "-o", "{dir}/x.glb"], 2, ["layout"]),
    ("render of a scene", ["render", "{dir}/good.json", "-o", "{out}"], 2, ["layout"]),
    ("verify of a scene", ["verify", "{dir}/good.json"], 2, ["layout"]),
    ("catalog of an unknown word", ["catalog", "xylophagous"], 2, ["xylophagous"]),
    # files
    ("earlier layout missing", ["solve", "{dir}/good.json", "--from", "{dir}/nowhere.json"], 3, ["nowhere.json"]),
    ("earlier layout is a scene", ["solve", "{dir}/good.json", "--from", "{dir}/good.json"], 2, ["good.json"]),
    ("who is locked is not there", ["solve", "{dir}/good.json", "--lock", "piano"], 2, ["piano"]),
    ("who is locked had no place", ["solve", "{dir}/good.json", "--lock", "bed"], 2, ["bed", "earlier layout"]),
    ("not JSON", ["solve", "{dir}/not-json.json"], 2, ["not-json.json", "json"]),
    ("JSON cut off", ["solve", "{dir}/cut.json"], 2, ["cut.json"]),
    ("empty file", ["solve", "{dir}/empty.json"], 2, ["empty.json"]),
    ("blank file", ["solve", "{dir}/blank.json"], 2, ["blank.json"]),
    ("array", ["solve", "{dir}/array.json"], 2, ["array.json"]),
    ("number", ["solve", "{dir}/number.json"], 2, ["number.json"]),
    ("null", ["solve", "{dir}/null.json"], 2, ["null.json"]),
    ("NaN", ["solve", "{dir}/nan.json"], 2, ["nan.json"]),
    ("infinity", ["solve", "{dir}/infinity.json"], 2, ["infinity.json"]),
    ("trailing comma", ["solve", "{dir}/trailing-comma.json"], 2, ["trailing-comma.json"]),
    ("binary", ["solve", "{dir}/binary.json"], 2, ["binary.json"]),
    ("100,000 brackets", ["solve", "{dir}/deep.json"], 2, ["deep.json"]),
    ("bad UTF-8", ["solve", "{dir}/bad-utf8.json"], 2, ["bad-utf8.json"]),
    ("unknown key", ["solve", "{dir}/unknown-key.json"], 2, ["furnitur", "furniture"]),
    ("unknown key of an object", ["solve", "{dir}/unknown-key-object.json"], 2, ["/furniture/0", "colour"]),
    ("furniture is no list", ["solve", "{dir}/furniture-not-list.json"], 2, ["/furniture"]),
    ("furniture is a number", ["solve", "{dir}/furniture-number.json"], 2, ["/furniture/0"]),
    ("width is a word", ["solve", "{dir}/dims-string.json"], 2, ["/room/dims/w"]),
    ("negative size", ["solve", "{dir}/negative-size.json"], 2, ["/furniture/0/dims/w"]),
    ("zero size", ["solve", "{dir}/zero-size.json"], 2, ["/furniture/0/dims/w"]),
    ("enormous object", ["solve", "{dir}/enormous-object.json"], 2, ["/furniture/0/dims/w"]),
    ("room of no width", ["solve", "{dir}/room-zero.json"], 2, ["/room/dims/w"]),
    ("room of negative depth", ["solve", "{dir}/room-negative.json"], 2, ["/room/dims/d"]),
    ("room of 10 km", ["solve", "{dir}/room-10km.json"], 2, ["/room/dims"]),
    ("id used twice", ["solve", "{dir}/id-twice.json"], 2, ["/furniture/1", "twice", "bed"]),
    ("empty id", ["solve", "{dir}/id-empty.json"], 2, ["/furniture/0/id"]),
    ("no category", ["solve", "{dir}/no-category.json"], 2, ["/furniture/0", "category"]),
    ("relation to nobody", ["solve", "{dir}/relation-to-nobody.json"], 2, ["/constraints/0/targets/0", "bedd", "bed"]),
    ("relation to no reference", ["solve", "{dir}/relation-unknown-reference.json"], 2, ["/constraints/0/relativeTo", "sofa"]),
    ("unknown relation", ["solve", "{dir}/relation-unknown-type.json"], 2, ["/constraints/0/type", "againstWall"]),
    ("relation without targets", ["solve", "{dir}/relation-no-targets.json"], 2, ["/constraints/0/targets"]),
    ("relation without its reference", ["solve", "{dir}/relation-no-reference.json"], 2, ["/constraints/0"]),
    ("wall that does not meet its neighbour", ["solve", "{dir}/wall-gap.json"], 2, ["/room/walls", "wall4"]),
    ("one wall", ["solve", "{dir}/walls-one.json"], 2, ["/room/walls"]),
    ("wall id used twice", ["solve", "{dir}/wall-id-twice.json"], 2, ["/room/walls/3", "twice", "wall1"]),
    ("polygon that crosses itself", ["solve", "{dir}/polygon-crosses.json"], 2, ["/room/polygon"]),
    ("polygon of two points", ["solve", "{dir}/polygon-line.json"], 2, ["/room/polygon"]),
    ("opening outside its wall", ["solve", "{dir}/opening-outside.json"], 2, ["/room/openings/0", "door1"]),
    ("opening in no wall", ["solve", "{dir}/opening-no-wall.json"], 2, ["/room/openings/0", "wall9"]),
    ("opening higher than the room", ["solve", "{dir}/opening-too-high.json"], 2, ["/room/openings/0"]),
    ("unknown units in a file", ["solve", "{dir}/units-unknown.json"], 2, ["/metadata/units", "parsec"]),
    ("colour of two numbers", ["solve", "{dir}/color-wrong.json"], 2, ["/materials/0/color"]),
    ("all errors at once", ["validate", "{dir}/many-errors.json"], 2, ["/furniture/0/dims/w", "/furniture/1/category", "furnitur"]),
    ("validate names the file", ["validate", "{dir}/many-errors.json"], 2, ["{dir}/many-errors.json#/furnitur"]),
    ("validate names the file of a layout", ["validate", "{dir}/layout-empty.json"], 2, ["{dir}/layout-empty.json"]),
    ("validate names stdin", ["validate", "-"], 2, ["stdin"]),
    ("a format of the future", ["solve", "{dir}/scene-newer.json"], 2, ["format"]),
    ("batch file missing", ["batch", "{dir}/nowhere.jsonl", *GENERATE_OUT], 3, ["nowhere.jsonl"]),
    ("batch without a line", ["batch", "{dir}/blank.json", *GENERATE_OUT], 2, ["no prompt"]),
    ("batch of no jobs", ["batch", "{dir}/good.json", "-j", "0", *GENERATE_OUT], 2, ["--jobs"]),
    ("batch without a folder", ["batch", "{dir}/good.json"], 2, ["--output"]),
    ("batch into a file", ["batch", "{dir}/good.json", "--no-render", "-o", "{dir}/a-file"], 3, ["a-file"]),
    ("batch with broken options", ["batch", "{dir}/good.json", "--room", "big", *GENERATE_OUT], 2, ["big"]),
    ("edit of a missing layout", ["edit", "{dir}/nowhere.json", "remove the bed", "-o", "{dir}/x.json"], 3, ["nowhere.json"]),
    ("edit of a scene", ["edit", "{dir}/good.json", "remove the bed", "-o", "{dir}/x.json"], 2, ["layout"]),
    ("edit without words", ["edit", "{dir}/good.json", "-o", "{dir}/x.json"], 2, ["text"]),
    ("configuration file missing", ["generate", "a bedroom", "--config", "{dir}/nowhere.toml", *GENERATE_OUT], 2, ["nowhere.toml"]),
    ("configuration file of a list", ["generate", "a bedroom", "--config", "{dir}/array.json", *GENERATE_OUT], 2, ["option"]),
    ("layout without a room", ["verify", "{dir}/layout-empty.json"], 2, ["room"]),
    ("layout without a polygon", ["verify", "{dir}/layout-no-polygon.json"], 2, ["polygon"]),
]
