"""The four judgements of an experiment by a scripted vision model: one who sees, one who says yes, one who is blind. The columns come out
as planted, are kept, and are no part of a run without a judge."""

import csv
import hashlib
import json
import unittest

import model_case
from harness import DONE, needs_blender
from test_vision import Image, VisionServer

TABLE = """ID,Description,ObjCount,ObjAttr,OORel,OARel
one,"A bedroom of 4 x 4 m with a bed, a nightstand to the left of the bed, a desk and a wardrobe.","eq,1,bed",,,
two,"An office of 4 x 3.5 m with a desk, a chair at the desk, a bookshelf and a plant next to the bookshelf.","eq,1,desk",,,
three,"A living room of 5 x 4 m with a sofa, a coffee table in front of the sofa and a floor lamp next to the sofa.","eq,1,sofa",,,
"""


@unittest.skipIf(Image is None, "no Pillow")
class JudgedExperiment(model_case.ModelCase):
    def experiment(self, judge, *more, methods="pipeline,random", name="scripted"):
        suite = self.write_text("table.csv", TABLE)
        with VisionServer(judge) as server:
            options = ["--methods", methods, "--effort", "10", "--vlm", "--vlm-model", name, *more]
            run = self.run_layoutbox("experiment", suite, "-o", self.path("out"), *options, env=self.environment(server))
            self.assert_status(run, DONE)
            self.assertEqual(server.errors, [])
        with self.path("out/results.csv").open(newline="") as file:
            return list(csv.DictReader(file)), server

    def truths(self):
        """Question → is it so?, as geometry says of each room that was made."""
        runs = self.run_layoutbox("judge", self.path("out/runs"), "--questions", "--json").json()
        return {(room["name"], q["question"]): q["truth"] for room in runs["rooms"] for q in room["questions"]}

    def test_who_sees_and_who_says_yes(self):
        rows, server = self.experiment(lambda picture, text: "yes" if text else 1.0)
        self.assertGreater(server.count, 30)
        for row in rows:
            self.assertEqual(2 * int(row["single_right"]), int(row["single_answers"]), row["scene"])
            self.assertEqual(2 * int(row["multi_right"]), int(row["multi_answers"]), row["scene"])
            self.assertEqual((row["scene_score"], row["prompt_score"]), ("1", "1"))
        page = self.path("out/report.html").read_text()
        for words in (
            "single-relation questions right",
            "multi-relation questions right",
            "score against the scene",
            "shown the floor plan",
            "scripted at http",
            "answers that are neither yes nor no",
        ):
            self.assertIn(words, page)
        truths = {question: truth for (_, question), truth in self.truths().items()}
        by_room = {}
        for (_room, question), truth in self.truths().items():
            by_room.setdefault(question, set()).add(truth)
        unclear = {question for question, said in by_room.items() if len(said) > 1}

        def seeing(picture, text):
            if text is None:
                return 0.8
            question = next(question for question in truths if question in text)
            return "unsure" if question in unclear else "yes" if truths[question] else "no"

        rows, _ = self.experiment(seeing, methods="pipeline", name="seeing")
        for row in rows:
            self.assertGreaterEqual(int(row["single_right"]) + int(row["multi_right"]), 4, row["scene"])
            self.assertEqual(row["scene_score"], "0.8")

    def test_who_is_blind_and_what_is_kept(self):
        def coin(picture, text):
            return "yes" if text and hashlib.sha256(text.encode()).digest()[0] % 2 else "no" if text else 0.5

        rows, server = self.experiment(coin, "--singles", "8", methods="pipeline")
        right = sum(int(row["single_right"]) for row in rows) / sum(int(row["single_answers"]) for row in rows)
        self.assertTrue(0.2 < right < 0.8, right)
        lines = [json.loads(line) for line in self.path("out/results.jsonl").read_text().splitlines()]
        self.assertTrue(all(line["judged"]["shown"] == "floor plan" for line in lines))
        # A run without a judge keeps what was said.
        run = self.run_layoutbox(
            "experiment",
            self.path("table.csv"),
            "-o",
            self.path("out"),
            "--methods",
            "pipeline",
            "--effort",
            "10",
            env={"OPENAI_API_KEY": None, "OPENAI_BASE_URL": None},
        )
        self.assert_status(run, DONE)
        again = [json.loads(line) for line in self.path("out/results.jsonl").read_text().splitlines()]
        self.assertEqual(again, lines)

    def test_models_are_compared(self):
        suite = self.write_text("table.csv", TABLE)
        with VisionServer(lambda picture, text: "yes") as server:
            server.answer = lambda name, parts: model_case.SCENE
            run = self.run_layoutbox(
                "experiment",
                suite,
                "-o",
                self.path("out"),
                "--methods",
                "model-no-repair",
                "--models",
                "large,small",
                "--effort",
                "10",
                env=self.environment(server),
            )
            self.assert_status(run, DONE)
        with self.path("out/results.csv").open(newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual({row["method"] for row in rows}, {"model-no-repair@large", "model-no-repair@small"})
        self.assertTrue(all(int(row["request_tokens"]) > 0 for row in rows), rows[0])
        self.assertIn("tokens asked", self.path("out/report.html").read_text())

    @needs_blender
    def test_pictures_with_and_without_all_walls(self):
        sizes = []

        def judge(picture, text):
            sizes.append(picture.size)
            return "yes" if text else 0.5

        suite = self.write_text("one.csv", "\n".join(TABLE.splitlines()[:2]) + "\n")
        with VisionServer(judge) as server:
            run = self.run_layoutbox(
                "experiment",
                suite,
                "-o",
                self.path("out"),
                "--methods",
                "pipeline",
                "--effort",
                "10",
                "--pictures",
                "--all-walls",
                "--vlm",
                "--vlm-model",
                "scripted",
                env=self.environment(server),
            )
            self.assert_status(run, DONE)
            self.assertEqual(server.errors, [])
        room = self.path("out/runs/one.pipeline.1")
        for name in ("scene.png", "scene-overlay.png", "scene-walls.png"):
            with Image.open(room / name) as picture:
                self.assertEqual(picture.size, (560, 440), name)
        self.assertEqual(set(sizes), {(560, 440)})
        self.assertNotEqual((room / "scene.png").read_bytes(), (room / "scene-walls.png").read_bytes())
        line = json.loads(self.path("out/results.jsonl").read_text())
        self.assertEqual(line["judged"]["shown"], "picture")
        self.assertIn("allWalls", line["judged"])
        page = self.path("out/report.html").read_text()
        self.assertIn("data:image/jpeg;base64,", page)
        self.assertIn("right answers on the same rooms with all walls", page)


if __name__ == "__main__":
    unittest.main()
