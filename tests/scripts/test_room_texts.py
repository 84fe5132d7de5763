"""The texts that the parser is trained and the planner is measured with: trees are trees, and descriptions hold what their scenes say."""

import json
import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).parent.parent.parent
NAMES = set(re.findall(r'"([\w$]+)"', (ROOT / "src/layoutbox/plan/syntax/names.cc").read_text()))


def run(script, *arguments):
    return subprocess.run([sys.executable, ROOT / "train" / script, *arguments], capture_output=True, check=True, text=True).stdout


def crossing(heads):
    spans = [(min(i, head - 1), max(i, head - 1)) for i, head in enumerate(heads) if head]
    return any(a < c < b < d for a, b in spans for c, d in spans)


class RoomTexts(unittest.TestCase):
    def test_every_tree_is_one(self):
        for block in run("room_sentences.py", "600", "7").strip().split("\n\n"):
            rows = [line.split("\t") for line in block.split("\n")]
            heads = [int(row[2]) for row in rows]
            self.assertTrue(heads.count(0) == 1 and max(heads) <= len(rows), block)
            self.assertLessEqual({name for row in rows for name in (row[1], row[3])}, NAMES, block)
            self.assertFalse(crossing(heads), block)
            for at in range(len(rows)):
                steps = 0
                while at >= 0 and steps <= len(rows):
                    at, steps = heads[at] - 1, steps + 1
                self.assertLess(at, 0, block)

    def test_descriptions_name_what_their_scenes_hold(self):
        lines = run("fresh_rooms.py", "70", "7").splitlines()
        self.assertEqual(len({json.loads(line)["style"] for line in lines}), 7)
        for line in lines:
            description = json.loads(line)
            text = description["prompt"].lower()
            for name, count in description["objects"].items():
                self.assertTrue(count > 0 and (name in text or name[:-3] + "ves" in text), description)
            for relation in description["relations"]:
                self.assertIn(relation["subject"], description["objects"], description)

    def test_the_same_seed_gives_the_same_text(self):
        first = run("fresh_rooms.py", "20", "3")
        self.assertEqual(first, run("fresh_rooms.py", "20", "3"))
        self.assertNotEqual(first, run("fresh_rooms.py", "20", "4"))


if __name__ == "__main__":
    unittest.main()
