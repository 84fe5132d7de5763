"""Many rooms from one file: each in a folder of its own, resumed where it was stopped, never half-written."""

import json
import signal
import time

from harness import DONE, INTERRUPTED, NOT_AS_ASKED, SOURCE, WRONG_INPUT, WRONG_SURROUNDINGS, CliTestCase

ROOMS = {
    "bed": "A bedroom with a bed and a wardrobe.",
    "study": "A study with a desk under the window and a bookshelf.",
    "dining": "A dining room with a table and four chairs around it.",
}
FILES = {"scene.json", "layout.json", "floorplan.svg", "scene.glb", "blender.py", "report.json", "run.json"}
CONFLICT = (
    "A bedroom (3 x 3 x 2.5 m). The bed is 2 m wide and stands against the back wall. "
    "The wardrobe is 2.4 m wide and stands against the back wall."
)


def lines_of(rooms):
    return "".join(json.dumps({"id": name, "prompt": prompt}) + "\n" for name, prompt in rooms.items())


class BatchCase(CliTestCase):
    def batch(self, text, *arguments, out="out", **options):
        prompts = self.write_text("prompts.jsonl", text)
        return self.run_layoutbox("batch", prompts, "--no-render", "-o", self.path(out), *arguments, **options)

    def summary(self, out="out"):
        return self.read_json(f"{out}/summary.json")

    def states(self, out="out"):
        return [item["state"] for item in self.summary(out)["items"]]

    def names(self, out="out"):
        """All that lies in the output folder, hidden things too."""
        return {path.name for path in self.path(out).iterdir()}

    def stamps(self, out="out"):
        return {path.parent.name: path.stat().st_mtime_ns for path in self.path(out).glob("*/run.json")}


class Rooms(BatchCase):
    def test_a_folder_for_every_line(self):
        run = self.batch(lines_of(ROOMS))
        self.assert_done(run)
        self.assertEqual(self.names(), {*ROOMS, "summary.json"})
        for name in ROOMS:
            self.assertEqual({path.name for path in self.path(f"out/{name}").iterdir()}, FILES)
            self.assertEqual(self.read_json(f"out/{name}/run.json")["prompt"], ROOMS[name])
        self.assertIn("3 rooms: 3 done", run.out)

    def test_the_same_as_generate_whatever_runs_beside(self):
        self.assert_done(self.batch(lines_of(ROOMS), "-j", "3"))
        self.assert_done(self.batch(lines_of(ROOMS), "-j", "1", out="one"))
        for name, prompt in ROOMS.items():
            self.assert_done(self.run_layoutbox("generate", prompt, "--no-render", "-o", self.path(f"alone {name}")))
            for file in ("scene.json", "scene.glb", "floorplan.svg"):
                alone = self.path(f"alone {name}/{file}").read_bytes()
                self.assertEqual(alone, self.path(f"out/{name}/{file}").read_bytes(), file)
                self.assertEqual(alone, self.path(f"one/{name}/{file}").read_bytes(), file)

    def test_options_of_a_line_beat_those_of_the_batch(self):
        text = json.dumps({"id": 7, "type": "office", "room": "5x4", "seed": 9}) + "\n" + lines_of({"other": ROOMS["bed"]})
        self.assert_done(self.batch(text, "--room", "6x5x3", "--seed", "2"))
        self.assertEqual(self.read_json("out/7/layout.json")["room"]["polygon"][2], [5, 4])
        self.assertEqual(self.read_json("out/7/run.json")["options"]["seed"], 9)
        self.assertEqual(self.read_json("out/other/layout.json")["room"]["polygon"][2], [6, 5])
        self.assertEqual(self.read_json("out/other/run.json")["options"]["seed"], 2)

    def test_plain_lines_a_table_and_stdin(self):
        self.assert_done(self.batch("A bedroom with a bed.\n\nAn office with a desk.\n"))
        self.assertEqual(self.names(), {"0001", "0002", "summary.json"})
        table = 'ID,Description,Difficulty\n0,"A bedroom with a bed, and a lamp.",easy\n1,An office with a desk.,hard\n'
        self.assert_done(self.batch(table, out="table"))
        self.assertEqual(self.names("table"), {"0", "1", "summary.json"})
        run = self.run_layoutbox("batch", "-", "--no-render", "-o", self.path("stdin"), stdin=lines_of({"a": ROOMS["bed"]}))
        self.assert_done(run)
        self.assertEqual(self.names("stdin"), {"a", "summary.json"})

    def test_a_json_list_in_one_line_or_many(self):
        rooms = [{"id": "a", "prompt": "A bedroom with a bed."}, "An office with a desk.", 7]
        for number, indent in enumerate((None, 2)):
            run = self.batch(json.dumps(rooms, indent=indent), out=f"list {number}")
            self.assertIn("3", run.err)
            self.assertEqual(self.names(f"list {number}"), {"a", "0002", "summary.json"})

    def test_json_is_the_summary(self):
        run = self.batch(lines_of({"a": ROOMS["bed"]}), "--json")
        self.assertEqual(run.json(), self.summary())
        self.assertEqual((run.json()["rooms"], run.json()["done"]), (1, 1))


class BadLines(BatchCase):
    def test_one_bad_line_stops_nothing(self):
        text = (
            '{"id": "broken", "prompt": \n'
            + '{"id": "empty", "prompt": " "}\n'
            + '{"id": "said wrong", "prompt": "A bedroom.", "colour": "red"}\n'
            + '{"id": "seed", "prompt": "A bedroom.", "seed": "many"}\n'
            + '{"id": "list", "prompt": ["A bedroom."]}\n'
            + '["A bedroom."]\n'
            + '{"id": "foreign", "prompt": "Ein Schlafzimmer mit Bett"}\n'
            + lines_of({"good": ROOMS["bed"]})
        )
        run = self.batch(text)
        self.assert_status(run, NOT_AS_ASKED)
        self.assertEqual(self.states(), ["failed"] * 7 + ["done"])
        for item in self.summary()["items"][:7]:
            self.assertTrue(item["error"]["message"], item)
            self.assertIn(f"(line {item['line']})", run.err)
        self.assertIn("7 failed", run.out)

    def test_ids_that_are_no_names_touch_nothing_outside(self):
        bad = ["../escape", "/tmp/escape", "a/b", "a\\b", "..", ".", ".hidden", "x" * 300, "nul\u0000", "tab\t", "summary.json"]
        text = "".join(json.dumps({"id": name, "prompt": ROOMS["bed"]}) + "\n" for name in bad) + lines_of({"Zimmer ä 1": ROOMS["bed"]})
        self.assert_status(self.batch(text), NOT_AS_ASKED)
        self.assertEqual(self.states(), ["failed"] * len(bad) + ["done"])
        self.assertEqual(self.names(), {"Zimmer ä 1", "summary.json"})
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"prompts.jsonl", "out"})

    def test_an_id_twice(self):
        run = self.batch(lines_of({"a": ROOMS["bed"]}) + lines_of({"a": ROOMS["study"]}))
        self.assert_status(run, NOT_AS_ASKED)
        self.assertEqual(self.states(), ["done", "failed"])
        self.assertIn("line 1", self.summary()["items"][1]["error"]["message"])
        self.assertEqual(self.read_json("out/a/run.json")["prompt"], ROOMS["bed"])

    def test_not_as_asked_is_counted_apart(self):
        self.assert_status(self.batch(lines_of({"a": CONFLICT, "b": ROOMS["bed"]})), NOT_AS_ASKED)
        self.assertEqual(self.states(), ["notAsAsked", "done"])

    def test_nothing_at_all(self):
        run = self.batch(" \n\n")
        self.assert_status(run, WRONG_INPUT)
        self.assertFalse(self.path("out").exists())

    def test_missing_blender_is_the_surroundings(self):
        prompts = self.write_text("p.jsonl", lines_of({"a": ROOMS["bed"]}))
        missing = {"LAYOUTBOX_BLENDER": "/nowhere/blender"}
        run = self.run_layoutbox("batch", prompts, "-o", self.path("out"), env=missing)
        self.assert_status(run, WRONG_SURROUNDINGS)
        self.assertTrue(self.path("out/a/layout.json").exists())


    def test_what_is_written_and_empty_is_not_passed_over(self):
        for key in ("seed", "effort", "room", "units", "type", "id"):
            with self.subTest(key):
                line = {"id": "a", "prompt": ROOMS["bed"], key: ""}
                run = self.batch(lines_of({"good": ROOMS["study"]}) + json.dumps(line) + "\n", out=f"out {key}")
                self.assert_status(run, NOT_AS_ASKED)
                self.assertEqual(self.states(f"out {key}"), ["done", "failed"])
                self.assertIn(f"(line 2): '{key}' is empty", run.err)

    def test_a_broken_table_names_file_and_line_once(self):
        for text in ('id,prompt\n1,"A bed\n', "id,prompt\n1,A bed,3\n"):
            table = self.write_text("c2.csv", text)
            batch = self.run_layoutbox("batch", table, "--no-render", "-o", self.path("out"))
            catalog = self.run_layoutbox("plan", ROOMS["bed"], "--catalog", table)
            judge = self.run_layoutbox("judge", SOURCE / "examples/layouts/study.json", "--annotations", table)
            for run in (batch, catalog, judge):
                self.assert_status(run, WRONG_INPUT)
                self.assertIn(f"{table} line 2: ", run.err)
                self.assertEqual(run.err.count("line 2"), 1, run.err)


class Resumed(BatchCase):
    def test_finished_rooms_are_kept(self):
        self.assert_done(self.batch(lines_of(ROOMS)))
        before = self.stamps()
        run = self.batch(lines_of(ROOMS))
        self.assert_done(run)
        self.assertEqual(self.stamps(), before)
        self.assertEqual(self.summary()["kept"], 3)
        self.assertIn("3 of them were there already", run.out)

    def test_changed_prompts_and_options_are_made_again(self):
        self.assert_done(self.batch(lines_of(ROOMS)))
        before = self.stamps()
        self.assert_done(self.batch(lines_of({**ROOMS, "bed": ROOMS["study"]})))
        changed = {name for name, stamp in self.stamps().items() if stamp != before[name]}
        self.assertEqual(changed, {"bed"})
        self.assert_done(self.batch(lines_of(ROOMS), "--seed", "3"))
        self.assertEqual(self.summary()["kept"], 0)
        self.assert_done(self.batch(lines_of(ROOMS), "--seed", "3", "--force"))
        self.assertEqual(self.summary()["kept"], 0)

    def test_a_changed_catalogue_counts(self):
        def made_of(width):
            table = self.write_text("own.csv", f"id,category,width,depth,height\nA1,bed,{width},2,0.5\n")
            self.assert_done(self.batch(lines_of({"bed": ROOMS["bed"]}), "--catalog", table))
            return self.summary()["kept"]

        self.assertEqual([made_of(1.4), made_of(1.4), made_of(1.5)], [0, 1, 0])

    def test_failed_rooms_are_tried_again(self):
        self.assert_status(self.batch(lines_of({"a": "hmm hmm"})), NOT_AS_ASKED)
        self.assertEqual(self.read_json("out/a/run.json")["status"], "failed")
        self.assert_done(self.batch(lines_of({"a": ROOMS["bed"]})))
        self.assertEqual({path.name for path in self.path("out/a").iterdir()}, FILES)

    def test_what_is_somebody_elses_is_not_replaced(self):
        self.path("out/a").mkdir(parents=True)
        self.write_text("out/a/diary.txt", "mine")
        self.assert_status(self.batch(lines_of({"a": ROOMS["bed"]})), WRONG_SURROUNDINGS)
        self.assertEqual(self.path("out/a/diary.txt").read_text(encoding="utf-8"), "mine")
        self.assertEqual({path.name for path in self.path("out/a").iterdir()}, {"diary.txt"})

    def test_one_batch_at_a_time(self):
        endless = self.start_long("first")
        run = self.batch(lines_of(ROOMS), out="first")
        self.assert_status(run, WRONG_SURROUNDINGS)
        self.assertIn("another run", run.err)
        endless.kill()
        endless.communicate()

    def start_long(self, out):
        """A batch of many rooms, of which some are finished."""
        prompts = self.write_text("many.jsonl", lines_of({f"room {i}": ROOMS["dining"] for i in range(400)}))
        process = self.start("batch", prompts, "--no-render", "-j", "2", "-o", self.path(out))
        end = time.monotonic() + 60
        while time.monotonic() < end and len(list(self.path(out).glob("room */run.json"))) < 3:
            time.sleep(0.005)
        return process

    def assert_whole(self, out):
        """Every room that has its place has all its files; nothing else lies there."""
        rooms = [path for path in self.path(out).iterdir() if not path.name.startswith(".") and path.is_dir()]
        self.assertGreater(len(rooms), 2)
        for room in rooms:
            self.assertEqual({path.name for path in room.iterdir()}, FILES)
        return len(rooms)

    def test_interrupt_keeps_what_is_finished(self):
        process = self.start_long("out")
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, INTERRUPTED)
        made = self.assert_whole("out")
        summary = self.summary()
        self.assertTrue(summary["stopped"])
        self.assertEqual(summary["done"], made)
        self.assertEqual(summary["notStarted"], 400 - made)
        self.assertNotIn(".layoutbox-batch", self.names())

    def test_kill_leaves_nothing_half_written_and_the_next_run_goes_on(self):
        made = 0
        for _ in range(3):
            process = self.start_long("out")
            time.sleep(0.03)
            process.kill()
            process.communicate()
            made = self.assert_whole("out")
        few = lines_of({f"room {i}": ROOMS["dining"] for i in range(made + 2)})
        run = self.batch(few)
        self.assert_status(run, DONE)
        self.assertGreaterEqual(self.summary()["kept"], made)
        self.assertNotIn(".layoutbox-batch", self.names())
