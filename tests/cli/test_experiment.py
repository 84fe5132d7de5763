"""Experiments: the suites that are built in, tables of anybody's, what comes out, going on where a run was stopped."""

import csv
import json
import unittest

from harness import DONE, WRONG_INPUT, CliTestCase

TABLE = """ID,Description,ObjCount,ObjAttr,OORel,OARel
one,A bedroom with a bed.,"eq,1,bed",,,
two,A bedroom with a bed and a nightstand to the left of the bed.,"eq,1,bed; eq,1,nightstand",,"eq,1,left,0,bed,nightstand",
"""
NO_KEY = {"OPENAI_API_KEY": None, "OPENAI_BASE_URL": None}


class Experiment(CliTestCase):
    def experiment(self, *more, suite=None, env=NO_KEY):
        suite = suite or self.write_text("table.csv", TABLE)
        return self.run_layoutbox("experiment", suite, "-o", self.path("out"), "--effort", "10", *more, env=env)

    def lines(self):
        return [json.loads(line) for line in self.path("out/results.jsonl").read_text().splitlines()]

    def test_methods_that_need_no_model(self):
        run = self.experiment()
        self.assert_status(run, DONE)
        self.assertIn("model: no model is at hand", run.err)
        lines = self.lines()
        self.assertEqual(len(lines), 2 * 5)
        by_key = {line["key"]: line for line in lines}
        self.assertTrue(by_key["two/pipeline/1"]["everything"])
        self.assertEqual(by_key["two/pipeline/1"]["measures"]["OOR"], [1, 1])
        self.assertEqual(by_key["one/random/1"]["outcome"], "placed")
        with self.path("out/results.csv").open(newline="") as file:
            self.assertEqual(len(list(csv.DictReader(file))), len(lines))
        page = self.path("out/report.html").read_text()
        self.assertIn("<svg", page)
        self.assertNotIn('src="http', page)
        self.assertTrue(self.path("out/runs/two.pipeline.1/layout.json").exists())

    def test_goes_on_where_it_was_stopped(self):
        self.assert_status(self.experiment("--methods", "pipeline"), DONE)
        first = self.lines()
        run = self.experiment("--methods", "pipeline,random", "--repeats", "2", "-j", "2")
        self.assert_status(run, DONE)
        self.assertIn("2 of 8 rooms were there already", run.err)
        lines = {line["key"]: line for line in self.lines()}
        self.assertEqual(len(lines), 8)
        for line in first:
            self.assertEqual(lines[line["key"]], line)

    def test_the_same_again(self):
        rooms = []
        for name in ("a", "b"):
            run = self.run_layoutbox(
                "experiment", self.write_text("table.csv", TABLE), "-o", self.path(name), "--methods", "pipeline,random", env=NO_KEY
            )
            self.assert_status(run, DONE)
            measures = [json.loads(line) for line in self.path(f"{name}/results.jsonl").read_text().splitlines()]
            rooms.append([{k: v for k, v in line.items() if k != "seconds"} for line in measures])
        self.assertEqual(rooms[0], rooms[1])

    def test_suites_that_are_built_in(self):
        run = self.experiment("--methods", "random", suite="paper")
        self.assert_status(run, DONE)
        self.assertEqual(len(self.lines()), 7)

    def test_ratings_by_people(self):
        """Tables of the studio's rating page: means by method, how they go with what is measured, how two raters agree."""
        rows = {"one.pipeline.1": (9, 8), "two.pipeline.1": (8, 8), "one.random.1": (3, 4), "two.random.1": (2, 1), "elsewhere": (5, 5)}
        files = []
        for rater in (0, 1):
            lines = [f'{room},{scores[rater]},place,"a ""bed"", askew",x' for room, scores in rows.items()]
            files.append(str(self.write_text(f"rater{rater}.csv", "\n".join(["id,score,kind,reason,prompt", *lines]) + "\n")))
        run = self.experiment("--methods", "pipeline,random", "--ratings", ",".join(files))
        self.assert_status(run, DONE)
        self.assertIn("2 ratings are of rooms that are not here", run.err)
        with self.path("out/results.csv").open(newline="") as file:
            rated = {f"{row['scene']}.{row['method']}": row for row in csv.DictReader(file)}
        self.assertEqual((rated["one.pipeline"]["ratings"], rated["one.pipeline"]["rating"]), ("2", "8.5"))
        page = self.path("out/report.html").read_text()
        self.assertIn("Ratings by people", page)
        self.assertIn("raters agree with 0.9", page)
        self.assertIn("<th>pipeline</th><td class=n>2</td><td class=n>8.25", page)
        for broken in ("id,score\na,11\n", "id,grade\na,3\n", "id,score\na,good\n"):
            run = self.experiment("--methods", "random", "--ratings", self.write_text("broken.csv", broken))
            self.assert_status(run, WRONG_INPUT)

    def test_the_page_says_each_style_and_room_once(self):
        self.assert_status(self.experiment("--methods", "pipeline,no-proofs,random"), DONE)
        page = self.path("out/report.html").read_text()
        self.assertIn("<b>pipeline, no-proofs</b>", page)  # the same rooms
        self.assertNotIn('stroke-width="0.18"', page)
        self.assertIn("stroke-width:0.18", page)
        self.assertLess(len(page), 60_000)

    def test_wrong_names(self):
        run = self.experiment(suite="nothing.csv")
        self.assertIn("paper", run.err)
        run = self.experiment("--methods", "magic")
        self.assert_status(run, WRONG_INPUT)
        self.assertIn("pipeline", run.err)


if __name__ == "__main__":
    unittest.main()
