"""The question stays below 6,000 tokens with our catalogue, counted by a rule of its own that is on the safe side."""

import csv
import json
import math
import re
import unittest
from pathlib import Path

import model_case
from harness import SHARED

ROOT = Path(__file__).resolve().parents[2]
SCENEEVAL = SHARED / "data/sceneeval/annotations-000-099.csv"
MOST, MOST_BRIEF = 6000, 2000


def tokens(text):
    """More than tokenizers of 49,000 words make: a token for five letters, for each digit and byte beyond ASCII, for two signs."""
    count = 0
    for piece in re.findall(rb"[A-Za-z]+|[0-9]|\s+|[\x80-\xff]|[^A-Za-z0-9\s\x80-\xff]+", text.encode()):
        if piece.isalpha():
            count += math.ceil(len(piece) / 5)
        elif not piece.isspace():
            count += math.ceil(len(piece) / 2)
        elif piece != b" ":
            count += 1
    return count


class QuestionSize(model_case.ModelCase):
    one_process = True

    def size(self, prompt, *options):
        run = self.run_layoutbox("plan", prompt, "--planner", "llm", "--dry-run", *options, env=self.environment("http://127.0.0.1:9/v1"))
        self.assert_done(run)
        body = json.loads(run.out.partition("\n\n")[2])
        return tokens("".join(message["content"] for message in body["messages"])) + tokens(
            json.dumps(body["tools"], separators=(",", ":"))
        )

    def check(self, prompts):
        worst = max((self.size(prompt), prompt) for prompt in prompts)
        self.assertLess(worst[0], MOST, worst[1])
        brief = max((self.size(prompt, "--model-context", "4096"), prompt) for prompt in prompts[:10])
        self.assertLess(brief[0], MOST_BRIEF, brief[1])

    def test_the_examples(self):
        prompts = []
        for path in sorted((ROOT / "examples/prompts").glob("*.jsonl")):
            lines = [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines() if line.strip()]
            prompts += [line["prompt"] for line in lines if "prompt" in line]
        self.check(prompts)

    def test_scenes_of_an_evaluation(self):
        if not SCENEEVAL.exists():
            self.skipTest("the data of SceneEval are not here")
        with SCENEEVAL.open(encoding="utf-8", newline="") as file:
            self.check([row["Description"] for row in csv.DictReader(file)])


if __name__ == "__main__":
    unittest.main()
