"""A model's right answer is never made worse, and a wrong one is found: measured over annotated prompts (right_answers.py)."""

import os
import unittest

import model_case
import right_answers
from harness import BINARY, SHARED, needs_shared


class RightAnswers(model_case.ModelCase):
    @needs_shared
    def test_of_annotated_prompts(self):
        path = SHARED / "data/sceneeval/annotations-000-099.csv"
        if not path.is_file():
            self.skipTest(f"{path.name} is not beside this checkout")
        every = 1 if os.environ.get("LAYOUTBOX_ALL_ANSWERS") else 3  # all of them nightly
        figures, lines = right_answers.measure(str(BINARY), right_answers.read(path)[::every])
        told = "\n".join(lines)
        self.assertEqual(figures["lost"], 0, told)
        self.assertLessEqual(figures["denied"], 0.005 * figures["parts"], told)
        self.assertEqual(figures["requests"], figures["asked"], told)
        self.assertGreaterEqual(figures["found"], 0.9 * figures["wrong"], told)


if __name__ == "__main__":
    unittest.main()
