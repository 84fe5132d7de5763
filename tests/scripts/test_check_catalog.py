"""scripts/check_catalog.py: the catalogue is without faults, and each kind of fault is found."""

from __future__ import annotations

import copy
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SCRIPT = ROOT / "scripts" / "check_catalog.py"

ENTRIES = [
    {
        "id": "table",
        "name": "table",
        "synonyms": ["board"],
        "size": {"w": [1.0, 1.2, 1.6], "d": 0.8, "h": 0.75},
        "topCarries": True,
        "spaces": [{"name": "below", "min": ["-w/2", "-d/2", "0"], "max": ["w/2", "d/2", "h-0.05"], "carries": False}],
        "rooms": ["kitchen"],
        "shape": {"family": "table"},
        "source": "measured",
    },
    {
        "id": "cup",
        "name": "cup",
        "size": {"w": 0.08, "d": 0.08, "h": 0.1},
        "mount": "surface",
        "standsOn": ["table"],
        "shape": {"family": "cup"},
        "source": "measured",
    },
]
SHAPES = {
    "families": {"table": {"words": {"top": {"values": ["rect", "round"], "meaning": "outline"}}}, "cup": {}},
    "words": {"material": {"meaning": "what it is made of"}},
}
ROOMS = [{"id": "kitchen", "name": "kitchen", "size": {"w": 3, "d": 3, "h": 2.6}, "usual": [["table", 1]]}]


# Words that stood for something else once, and the kind that they name.
MEANT = {
    "voting booth": "voting_booth",
    "fitting booth": "fitting_booth",
    "phone booth": "office_phone_booth",
    "judge's bench": "judge_bench",
    "witness box": "witness_stand",
    "gavel": "gavel",
    "ballot box": "ballot_box",
    "flag": "flag_on_pole",
    "wet floor sign": "wet_floor_sign",
    "shopping cart": "shopping_cart",
    "change machine": "change_machine",
    "locomotive": "toy_train",
    "dj mixer": "dj_mixer",
    "test tube rack": "test_tube_rack",
    "fire blanket": "fire_blanket",
    "soldering station": "soldering_station",
    "dress form": "dress_form",
    "pincushion": "pincushion",
    "clothes line": "clothes_line",
    "mandir": "mandir",
    "hydroponic shelf": "hydroponic_shelf",
    "food printer": "food_printer",
    "water recycler": "water_recycler",
    "pizza oven": "pizza_oven",
    "pepper mill": "pepper_mill",
    "phonograph": "phonograph",
    "cipher wheel": "cipher_wheel",
    "tyre rack": "tire_rack",
    "tourniquet": "tourniquet",
}


def run(folder: Path) -> tuple[int, str]:
    done = subprocess.run([sys.executable, SCRIPT, folder], capture_output=True, text=True)
    return done.returncode, done.stdout


def check(entries: list[dict], rooms: list[dict]) -> tuple[int, str]:
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "things.json").write_text(json.dumps({"entries": entries}), encoding="utf-8")
        Path(folder, "rooms.json").write_text(json.dumps({"rooms": rooms}), encoding="utf-8")
        Path(folder, "shapes.json").write_text(json.dumps(SHAPES), encoding="utf-8")
        Path(folder, "words.json").write_text(json.dumps({"about": "other data"}), encoding="utf-8")
        return run(Path(folder))


class CheckCatalog(unittest.TestCase):
    def test_the_catalogue_has_no_faults(self) -> None:
        status, text = run(ROOT / "catalog")
        self.assertEqual((status, text.splitlines()[:-1]), (0, []))
        self.assertGreaterEqual(int(text.split()[0]), 500)

    def test_good_entries_pass(self) -> None:
        self.assertEqual(check(ENTRIES, ROOMS), (0, "2 entries, 0 faults\n"))

    def test_an_empty_folder_fails(self) -> None:
        self.assertEqual(check([], []), (1, "0 entries, 0 faults\n"))

    def fault(self, change, expected: str) -> None:
        entries, rooms = copy.deepcopy(ENTRIES), copy.deepcopy(ROOMS)
        change(entries, rooms)
        status, text = check(entries, rooms)
        self.assertEqual(status, 1, text)
        self.assertIn(expected, text)

    def test_words_of_shapes(self) -> None:
        self.fault(lambda e, r: e[0]["shape"].update(words={"material": "oak", "tops": "round"}), "have no word 'tops'")
        self.fault(lambda e, r: e[0]["shape"].update(words={"top": "star"}), "none of rect, round")

    def test_sizes(self) -> None:
        self.fault(lambda e, r: e[0]["size"].update(w=[1.2, 1.0, 1.6]), "least ≤ usual ≤ greatest")
        self.fault(lambda e, r: e[0].update(variants=[{"words": ["wide"], "size": {"w": 30}}]), "variant 'wide' w")
        self.fault(lambda e, r: e[0].update(thin=True), "thin, but up to 0.75 m high")
        self.fault(lambda e, r: e[1]["size"].update(w=2, d=2), "larger than the largest table")

    def test_words(self) -> None:
        self.fault(lambda e, r: e[1].update(synonyms=["Board"]), "not in lower case")
        self.fault(lambda e, r: e[1].update(synonyms=["board"]), "cup: 'board' already names table")
        self.fault(lambda e, r: e.append(copy.deepcopy(e[1])), "cup: 'cup' is there twice")

    def test_names_of_nothing(self) -> None:
        self.fault(lambda e, r: e[1].update(standsOn=["shelf"]), "standsOn: there is no entry 'shelf'")
        self.fault(lambda e, r: e[1].pop("standsOn"), "standsOn is empty")
        self.fault(lambda e, r: e[0].update(rooms=["attic"]), "rooms: there is no room 'attic'")
        self.fault(lambda e, r: e[0].update(kindOf="furniture"), "kindOf: there is no entry 'furniture'")
        self.fault(lambda e, r: (e[0].update(kindOf="cup"), e[1].update(kindOf="table")), "goes round in a circle")
        self.fault(lambda e, r: e[0]["shape"].update(family="spaceship"), "shape family 'spaceship' is unknown")
        self.fault(lambda e, r: r[0].update(usual=[["oven", 1]]), "'oven'")
        self.fault(lambda e, r: e[0].update(colour="red"), "unknown member 'colour'")

    def test_supports(self) -> None:
        self.fault(lambda e, r: e[0].pop("topCarries"), "table carries nothing")

    def test_rooms_are_not_overfull(self) -> None:
        self.fault(lambda e, r: r[0].update(usual=[["table", 6]]), "covers 64% of the floor")

    def test_spaces(self) -> None:
        self.fault(lambda e, r: e[0]["spaces"][0].update(max=["w/2", "d/2", "h+0.1"]), "must lie within")
        self.fault(lambda e, r: e[0]["spaces"][0].update(min=["w/2", "-d/2", "0"]), "must lie within")
        self.fault(lambda e, r: e[0]["spaces"][0].update(max=["w*d", "d/2", "h"]), "not linear")
        self.fault(lambda e, r: e[0]["spaces"][0].update(max=["w/", "d/2", "h"]), "is not a formula")
        self.fault(lambda e, r: e[0]["spaces"][0].update(repeat=2), "needs {i} in its name")

    def test_words_mean_what_people_mean_by_them(self) -> None:
        owner = {}
        for path in (ROOT / "catalog").glob("*.json"):
            data = json.loads(path.read_text(encoding="utf-8"))
            for entry in data.get("entries", []):
                owner |= {word.lower(): entry["id"] for word in (entry["name"], *entry.get("synonyms", []))}
        self.assertEqual({word: owner.get(word) for word in MEANT}, MEANT)


if __name__ == "__main__":
    unittest.main()
