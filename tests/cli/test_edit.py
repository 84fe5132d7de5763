"""A layout changed by words: what is asked for happens, all else stays, and what cannot be is said."""

import json

from harness import DONE, NOT_AS_ASKED, WRONG_INPUT, CliTestCase

ROOM = (
    "A bedroom (5 x 4 x 2.7 m). A blue bed is centred on the back wall, with a nightstand on each side of it. "
    "A table lamp stands on each nightstand. A desk stands against the left wall and a chair in front of it. A wardrobe stands "
    "against the right wall. A rug lies in the middle of the room. The door is in the front wall. There is a window in the left wall."
)


class EditCase(CliTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run = cls.run_layoutbox("generate", ROOM, "--no-render", "--companions", "off", "-o", cls.class_folder / "room")
        if run.status != DONE:
            raise AssertionError(str(run))
        cls.layout_file = cls.class_folder / "room/layout.json"
        cls.before = json.loads(cls.layout_file.read_text(encoding="utf-8"))

    def edit(self, text, *arguments, layout=None):
        return self.run_layoutbox("edit", layout or self.layout_file, text, "-o", self.path("new.json"), *arguments)

    def edited(self, text, layout=None):
        """The objects by id after an edit that succeeds and passes the verifier, and what changed."""
        run = self.edit(text, "--json", layout=layout)
        self.assert_done(run)
        self.assert_done(self.run_layoutbox("verify", self.path("new.json")))
        after = self.read_json("new.json")
        return {item["id"]: item for item in after["objects"]}, run.json()

    def object(self, name):
        return next(item for item in self.before["objects"] if item["id"] == name)

    def changed(self, answer):
        return {change["id"]: change["what"] for change in answer["changes"]}


class Edits(EditCase):
    def test_move_and_remove(self):
        after, answer = self.edited("move the wardrobe against the front wall and remove the rug")
        self.assertNotIn("rug_1", after)
        self.assertEqual(self.changed(answer)["rug_1"], ["removed"])
        self.assertEqual(self.changed(answer)["wardrobe_1"][0], "moved")
        self.assertEqual(after["bed_1"], self.object("bed_1"))
        self.assertEqual(after["desk_1"], self.object("desk_1"))
        relations = self.read_json("new.json")["relations"]
        self.assertTrue(any(r["type"] == "againstWall" and r["targets"] == ["wardrobe_1"] and r["held"] for r in relations))

    def test_contradicted_wishes_are_dropped_and_named(self):
        after, answer = self.edited("move the wardrobe against the front wall")
        self.assertEqual([r["type"] for r in answer["dropped"]], ["againstWall"])
        self.assertLess(after["wardrobe_1"]["pos"][1], 0.5)
        kept = [r for r in self.read_json("new.json")["relations"] if r["targets"] == ["wardrobe_1"] and r["type"] == "againstWall"]
        self.assertEqual(len(kept), 1)

    def test_add_leaves_everything_where_it_is(self):
        after, answer = self.edited("add a potted plant in a corner and a bowl on the desk")
        self.assertEqual(len(after), len(self.before["objects"]) + 2)
        self.assertEqual([item["supportedBy"] for item in after.values() if item["category"] == "bowl"], ["desk_1"])
        self.assertEqual(sum(1 for what in self.changed(answer).values() if what != ["added"]), 0, answer)

    def test_what_stands_on_it_goes_too(self):
        after, answer = self.edited("remove the left nightstand")
        self.assertEqual(len(after), len(self.before["objects"]) - 2)
        removed = {change["id"]: change["asked"] for change in answer["changes"]}
        self.assertEqual(sorted(removed.values()), [False, True])

    def test_shift_exactly(self):
        after, _ = self.edited("move the rug 30 cm to the left")
        self.assertAlmostEqual(after["rug_1"]["pos"][0], self.object("rug_1")["pos"][0] - 0.3, places=3)
        self.assertEqual(after["rug_1"]["pos"][1], self.object("rug_1")["pos"][1])

    def test_turn(self):
        after, _ = self.edited("turn the chair around")
        chair = next(name for name in after if "chair" in name)
        self.assertEqual((after[chair]["rotation"] - self.object(chair)["rotation"]) % 360, 180)

    def test_loose_ways_end_where_there_is_room(self):
        after, _ = self.edited("move the desk a bit away from the door")
        self.assertGreater(after["desk_1"]["pos"][1], self.object("desk_1")["pos"][1])

    def test_turn_askew_at_a_wall(self):
        first, _ = self.edited("add a potted plant in a corner")
        plant = next(item["id"] for item in first.values() if "plant" in item["category"])
        self.path("new.json").rename(self.path("plant.json"))
        after, _ = self.edited("turn the plant by 45 degrees", layout=self.path("plant.json"))
        self.assertEqual((after[plant]["rotation"] - first[plant]["rotation"]) % 360, 45)

    def test_swap(self):
        after, _ = self.edited("swap the desk and the wardrobe")
        self.assertLess(abs(after["desk_1"]["pos"][1] - self.object("wardrobe_1")["pos"][1]), 0.6)
        self.assertGreater(after["desk_1"]["pos"][0], 3.5)
        self.assertLess(after["wardrobe_1"]["pos"][0], 1.5)

    def test_replace_keeps_place_and_wishes(self):
        after, answer = self.edited("replace the desk with a console table")
        new = next(item for item in after.values() if "console" in item["category"])
        self.assertNotIn("desk_1", after)
        self.assertLess(new["pos"][0], 0.8)
        self.assertTrue(any(r["targets"] == [new["id"]] for r in self.read_json("new.json")["relations"]), answer)

    def test_resize_and_recolor(self):
        after, answer = self.edited("make the desk 20 cm narrower and the bed green")
        self.assertAlmostEqual(after["desk_1"]["size"][0], self.object("desk_1")["size"][0] - 0.2, places=3)
        self.assertEqual(after["bed_1"]["attributes"], ["green"])
        self.assertEqual(self.changed(answer)["bed_1"], ["recolored"])

    def test_edits_follow_one_another(self):
        _, _ = self.edited("remove the rug")
        first = self.path("first.json")
        self.path("new.json").rename(first)
        after, _ = self.edited("add a rug at the foot of the bed", layout=first)
        self.assertIn("rug_1", after)
        self.assertIn("remove the rug", self.read_json("new.json")["prompt"])

    def test_into_a_folder(self):
        run = self.run_layoutbox("edit", self.layout_file, "remove the rug", "-o", self.path("room"), "--no-render")
        self.assert_done(run)
        names = {path.name for path in self.path("room").iterdir()}
        self.assertEqual(names, {"scene.json", "layout.json", "floorplan.svg", "scene.glb", "blender.py", "report.json", "run.json"})
        # The scene that is written leads to such a room again.
        self.assert_done(self.run_layoutbox("solve", self.path("room/scene.json"), "-o", self.path("again.json")))

    def test_the_same_text_gives_the_same_bytes(self):
        text = "move the wardrobe into a corner and add a plant next to the desk"
        self.assert_done(self.edit(text))
        first = self.read_json("new.json")
        self.assert_done(self.edit(text))
        second = self.read_json("new.json")
        for layout in (first, second):
            layout["stats"].pop("seconds")
        self.assertEqual(first, second)

    def test_nothing_to_change(self):
        run = self.edit("keep the bed where it is")
        self.assert_done(run)
        self.assertIn("nothing changed", run.out)


class TheRoom(EditCase):
    """The room itself, its doors and windows: what is not spoken of stays where it is."""

    def openings(self):
        return {opening["id"]: opening for opening in self.read_json("new.json")["room"]["openings"]}

    def test_wider(self):
        after, answer = self.edited("make the room 50 cm wider")
        self.assertEqual(self.read_json("new.json")["room"]["polygon"][2], [5.5, 4])
        self.assertEqual(self.changed(answer)["room"], ["resized"])
        for name in ("desk_1", "chair_1"):  # at the wall that stays
            self.assertEqual(after[name], self.object(name))
        self.assertAlmostEqual(after["wardrobe_1"]["pos"][0], self.object("wardrobe_1")["pos"][0] + 0.5, places=3)
        self.assertAlmostEqual(after["wardrobe_1"]["pos"][1], self.object("wardrobe_1")["pos"][1], places=3)
        self.assertEqual(self.openings()["window1"], self.before["room"]["openings"][1])

    def test_size_and_height(self):
        self.edited("make the bedroom 4.5 by 4.2 m and raise the ceiling by 10 cm")
        room = self.read_json("new.json")["room"]
        self.assertEqual((room["polygon"][2], room["height"]), ([4.5, 4.2], 2.8))

    def test_a_door_is_moved(self):
        after, answer = self.edited("move the door to the right wall")
        self.assertEqual(self.openings()["door1"]["wall"], "wall2")
        self.assertEqual(set(self.changed(answer)), {"door1"})
        self.assertEqual(after["bed_1"], self.object("bed_1"))

    def test_a_window_comes_in(self):
        _, answer = self.edited("add a window in the middle of the front wall")
        window = self.openings()["window2"]
        self.assertEqual((window["wall"], window["offset"]), ("wall1", 1.9))
        self.assertEqual(self.changed(answer), {"window2": ["added"]})

    def test_shifted_and_resized(self):
        self.edited("move the window 40 cm to the left and make the window 20 cm wider")
        window, before = self.openings()["window1"], self.before["room"]["openings"][1]
        self.assertAlmostEqual(window["w"], before["w"] + 0.2)
        self.assertAlmostEqual(window["offset"], before["offset"] + 0.4 - 0.1)  # the left wall runs to the front

    def test_goes_out_with_what_stands_on_its_sill(self):
        text = "A room (4 x 4 x 2.7 m) with a table. A potted plant stands on the windowsill. There is a window in the left wall."
        self.assert_done(self.run_layoutbox("generate", text, "--no-render", "-o", self.path("room")))
        after, _ = self.edited("remove the window", layout=self.path("room/layout.json"))
        self.assertEqual(list(after), ["table_1"])

    def test_impossible(self):
        for text, words in (
            ("make the room 60 m wide", "60.00 m wide"),
            ("make the room 1 m high", "1.00 m high"),
            ("move the door 10 m to the left", "cannot go so far"),
            ("add a window 6 m wide on the back wall", "no room for window2"),
            ("move the window up by 2 m", "2.7 m high"),
            ("remove the third window", "third window"),
            ("rotate the door", "not understood"),
        ):
            with self.subTest(text):
                run = self.edit(text)
                self.assert_status(run, WRONG_INPUT)
                self.assertIn(words, run.err)
                self.assertFalse(self.path("new.json").exists())


class WhatCannotBe(EditCase):
    def test_not_understood(self):
        for text, words in (
            ("sing a song", "sing a song"),
            ("move the desk to the moon", "moon"),
            ("remove the piano", "piano"),
            ("remove the nightstand", "nightstand_1, nightstand_2"),
            ("make it red", '"it"'),
            (" ", "nothing in the text"),
        ):
            with self.subTest(text):
                run = self.edit(text)
                self.assert_status(run, WRONG_INPUT)
                self.assertIn(words, run.err)
                self.assertFalse(self.path("new.json").exists())

    def test_impossible(self):
        self.path("new.json").write_text("before", encoding="utf-8")
        for text in ("make the wardrobe 4.5 m wide and 3.9 m deep", "move the wardrobe 10 m to the left", "make the bed 30 m wide"):
            with self.subTest(text):
                run = self.edit(text)
                self.assertIn(run.status, (NOT_AS_ASKED, WRONG_INPUT), str(run))
                self.assertGreater(len(run.err), 20)
                self.assertEqual(self.path("new.json").read_text(encoding="utf-8"), "before")
