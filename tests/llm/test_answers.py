"""Bad answers as models gave them (answers/*.json): each ends in a mended scene, with what was mended listed, or in a clear error."""

import json
import unittest
from pathlib import Path

import model_case
from fault_server import FaultServer, completion, raw

ANSWERS = sorted((Path(__file__).resolve().parent / "answers").glob("*.json"))
PROMPT = "A bedroom."  # says nothing that the answers could be compared with


class Answers(model_case.ModelCase):
    one_process = True

    def test_there_are_enough(self):
        self.assertGreaterEqual(len(ANSWERS), 40)

    def test_each(self):
        for path in ANSWERS:
            case = json.loads(path.read_text(encoding="utf-8"))
            with self.subTest(path.stem):
                self.check(case)

    def check(self, case):
        body = json.dumps(completion(case["message"], case.get("finish", "stop")))
        with FaultServer([raw(200, body)]) as server:
            self.path("scene.json").unlink(missing_ok=True)
            run = self.plan(server, "--max-attempts", "1", "--no-cache", "-v", prompt=PROMPT)
        if case["ends"] == "error":
            self.assert_status(run, 1)
            self.assertFalse(self.path("scene.json").exists())
            said = run.err
        else:
            self.assert_status(run, 0)
            scene = self.read_json("scene.json")
            said = json.dumps(scene.get("notes", []), ensure_ascii=False).replace('\\"', '"')
            self.assertEqual([item["id"] for item in scene["furniture"]], case["objects"])
            if "relations" in case:
                self.assertEqual([[c["type"], c["targets"]] for c in scene["constraints"] if not c.get("assumed")], case["relations"])
        for words in case["says"]:
            self.assertIn(words.lower(), said.lower())


if __name__ == "__main__":
    unittest.main()
