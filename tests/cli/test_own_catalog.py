"""The user's catalogue, room and scene files."""

from harness import NOT_AS_ASKED, WRONG_INPUT, CliTestCase

CSV = """id,category,width,depth,height
BED-7,bed,1.63,2.07,0.9
DESK-1,desk,1.31,0.64,0.74
LAMP-3,floor lamp,0.31,0.31,1.55
"""


class OwnCatalog(CliTestCase):
    def generate(self, *arguments, status=0):
        run = self.run_layoutbox("generate", *arguments, "--no-render", "-o", self.path("out"))
        self.assert_status(run, status)
        return run

    def sizes(self):
        return {item["category"]: item["size"] for item in self.read_json("out/layout.json")["objects"]}

    def test_exact_sizes(self):
        self.generate("A bedroom with a bed and a desk.", "--catalog", self.write_text("own.csv", CSV))
        self.assertIn([1.63, 2.07, 0.9], self.sizes().values())
        self.assertIn([1.31, 0.64, 0.74], self.sizes().values())

    def test_ours_fills_in(self):
        self.generate("A bedroom with a bed and a wardrobe.", "--companions", "off", "--catalog", self.write_text("own.csv", CSV))
        self.assertEqual(len(self.sizes()), 2)

    def test_only_the_users(self):
        run = self.generate("A bedroom with a bed and a wardrobe.", "--catalog", self.write_text("own.csv", CSV), "--catalog-only", "-v")
        self.assertEqual(list(self.sizes().values()), [[1.63, 2.07, 0.9]])
        self.assertIn("wardrobe", run.err)

    def test_kind_of_room_and_catalogue_without_a_prompt(self):
        self.generate("--type", "bedroom", "--room", "4x3.5x2.6", "--catalog", self.write_text("own.csv", CSV), "--catalog-only")
        self.assertIn([1.63, 2.07, 0.9], self.sizes().values())
        self.assertEqual(self.read_json("out/layout.json")["room"]["polygon"], [[0, 0], [4, 0], [4, 3.5], [0, 3.5]])

    def test_json_with_missing_sizes(self):
        own = self.write_json("own.json", [{"id": "B1", "category": "bed", "width": 1.71}])
        run = self.generate("A bedroom with a bed.", "--catalog", own, "-v")
        self.assertEqual(next(iter(self.sizes().values()))[0], 1.71)
        self.assertIn("B1", run.err)

    def test_broken_line_is_named(self):
        broken = self.write_text("broken.csv", CSV + 'X-1,"bed,1,2\n')
        run = self.generate("A bedroom with a bed.", "--catalog", broken, status=WRONG_INPUT)
        self.assertIn("broken.csv", run.err)
        self.assertIn("5", run.err)

    def test_word_for_a_number_is_named(self):
        broken = self.write_text("broken.csv", CSV + "X-1,bed,wide,2,1\n")
        run = self.generate("A bedroom with a bed.", "--catalog", broken, status=WRONG_INPUT)
        self.assertIn("wide", run.err)

    def test_id_twice(self):
        broken = self.write_text("broken.csv", CSV + "BED-7,bed,1.5,2,1\n")
        self.assertIn("BED-7", self.generate("A bedroom with a bed.", "--catalog", broken, status=WRONG_INPUT).err)

    def test_no_such_file(self):
        self.generate("A bedroom with a bed.", "--catalog", self.path("none.csv"), status=3)

    def test_only_needs_a_catalogue(self):
        self.generate("A bedroom with a bed.", "--catalog-only", status=WRONG_INPUT)


class OwnRoom(CliTestCase):
    SHELL = {
        "polygon": [[0, 0], [5, 0], [5, 3], [3, 3], [3, 5], [0, 5]],
        "dims": {"h": 2.7},
        "walls": [
            {"id": "south", "start": [0, 0], "end": [5, 0]},
            {"id": "east", "start": [5, 0], "end": [5, 3]},
            {"id": "inner", "start": [5, 3], "end": [3, 3]},
            {"id": "nook", "start": [3, 3], "end": [3, 5]},
            {"id": "north", "start": [3, 5], "end": [0, 5]},
            {"id": "west", "start": [0, 5], "end": [0, 0]},
        ],
        "openings": [{"id": "door", "type": "door", "wallId": "south", "offset": 3.8, "w": 0.9, "h": 2.0, "sill": 0}],
    }

    def test_room_file(self):
        shell = self.write_json("room.json", self.SHELL)
        run = self.run_layoutbox(
            "generate", "A living room with a sofa and a coffee table.", "--room-file", shell, "--no-render", "-o", self.path("out")
        )
        self.assert_done(run)
        room = self.read_json("out/layout.json")["room"]
        self.assertEqual(room["polygon"], self.SHELL["polygon"])
        self.assertEqual([(door["id"], door["offset"]) for door in room["openings"]], [("door", 3.8)])

    def test_room_and_room_file_exclude_one_another(self):
        shell = self.write_json("room.json", self.SHELL)
        run = self.run_layoutbox("generate", "A bedroom with a bed.", "--room", "4x3", "--room-file", shell, "-o", self.path("out"))
        self.assert_status(run, WRONG_INPUT)

    def test_feet(self):
        run = self.run_layoutbox(
            "generate", "A bedroom with a bed.", "--room", "12x10x8", "--units", "ft", "--no-render", "-o", self.path("out")
        )
        self.assert_done(run)
        self.assertEqual(self.read_json("out/layout.json")["room"]["polygon"][2], [3.658, 3.048])

    def test_scene_file_instead_of_a_prompt(self):
        self.assert_done(self.run_layoutbox("plan", "A bedroom with a bed.", "-o", self.path("scene.json")))
        run = self.run_layoutbox("generate", "--scene", self.path("scene.json"), "--no-render", "-o", self.path("out"))
        self.assert_done(run)

    def test_too_small_a_room_says_what_does_not_fit(self):
        prompt = "A bedroom with a king-size bed."
        run = self.run_layoutbox("generate", prompt, "--room", "1.5x1.5x2.5", "--no-render", "-o", self.path("out"))
        self.assert_status(run, NOT_AS_ASKED)
        self.assertIn("bed", run.err)
        self.assertIn("does not fit into the room, which measures 1.50 × 1.50", run.err)
