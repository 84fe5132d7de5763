"""Judging rooms from the command line: one, many, against a table, a scene, and what is said of broken ones."""

import json
import unittest

from harness import DONE, NOT_AS_ASKED, SOURCE, WRONG_INPUT, CliTestCase

TABLE = """ID,Description,ObjCount,ObjAttr,OORel,OARel
study,A study.,"eq,1,desk; ge,1,bookshelf",,,"eq,1,on,desk,floor"
gone,A room that nobody made.,"eq,2,bed",,,
"""
STUDY = SOURCE / "examples/layouts/study.json"


class Judge(CliTestCase):
    def test_a_room_of_ours(self):
        run = self.run_layoutbox("judge", STUDY, "--json")
        self.assertIn(run.status, (DONE, NOT_AS_ASKED))
        judged = run.json()
        self.assertEqual(judged["format"], "layoutbox/judgement@1")
        self.assertEqual(judged["measures"]["COL"]["part"], 0)
        self.assertEqual(judged["measures"]["CF"]["share"], 1)

    def test_many_against_a_table(self):
        table = self.write_text("table.csv", TABLE)
        for name in ("study", "broken"):
            self.path(f"rooms/{name}").mkdir(parents=True)
        self.path("rooms/study/layout.json").write_text(STUDY.read_text())
        self.path("rooms/broken/layout.json").write_text("{")
        run = self.run_layoutbox("judge", self.path("rooms"), "--annotations", table)
        self.assert_status(run, WRONG_INPUT)  # the table has no row "broken"
        table.write_text(TABLE + 'broken,,"eq,1,bed",,,\n')
        page = self.path("page.html")
        run = self.run_layoutbox("judge", self.path("rooms"), "--annotations", table, "-o", self.path("out.json"), "--report", page)
        self.assert_status(run, NOT_AS_ASKED)
        rooms = {room["name"]: room for room in json.loads(self.path("out.json").read_text())["rooms"]}
        self.assertEqual(set(rooms), {"study", "broken", "gone"})
        self.assertTrue(all(entry["holds"] for entry in rooms["study"]["entries"]), rooms["study"]["entries"])
        self.assertIn("error", rooms["broken"])
        self.assertEqual(rooms["gone"]["measures"]["COL"]["whole"], 2)
        self.assertIn("<svg", page.read_text())

    def test_what_we_export_is_judged_alike(self):
        self.assert_done(self.run_layoutbox("export", STUDY, "-o", self.path("study.glb")))
        ours = self.run_layoutbox("judge", STUDY, "--json").json()
        theirs = self.run_layoutbox("judge", self.path("study.glb"), "--json").json()
        for name in ("COL", "OOB", "SUP", "NAV"):
            self.assertEqual(ours["measures"][name], theirs["measures"][name], name)

    def test_nothing_that_is_known(self):
        run = self.run_layoutbox("judge", self.write_text("x.json", "[1]"))
        self.assert_status(run, WRONG_INPUT)
        self.assertIn("glTF", run.err)

    def test_bad_table(self):
        table = self.write_text("table.csv", "ID,Description,ObjCount,OORel,OARel\nstudy,,maybe 2 beds,,\n")
        run = self.run_layoutbox("judge", STUDY, "--annotations", table)
        self.assert_status(run, WRONG_INPUT)
        self.assertIn("maybe 2 beds", run.err)


if __name__ == "__main__":
    unittest.main()
