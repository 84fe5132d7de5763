#!/usr/bin/env python3
"""Judges the pictures of an experiment as a scripted vision model, and runs the experiment again with it: who sees (every answer is right,
by the truth that geometry has of the room whose picture is shown), who says yes to everything, who is blind (a coin). What stands in the
report's four columns then is planted, and marked: the judge is called scripted-sees, scripted-yes or scripted-blind.

usage: LAYOUTBOX_BINARY=… tests/llm/scripted_judge.py sees|yes|blind SUITE FOLDER [OPTION OF EXPERIMENT…]
FOLDER holds the rooms and their pictures of `layoutbox experiment SUITE -o FOLDER --pictures`.
"""

import base64
import hashlib
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import model_case  # noqa: F401  puts the harness on the path
from fault_server import FaultServer, call, scripted
from harness import BINARY


def truths_of(folder, options):
    """SHA-256 of a picture → question → is it so?, of every room with pictures."""
    which = ("--singles", "--multis", "--question-seed")
    numbers = [word for i, option in enumerate(options) if option in which for word in options[i : i + 2]]
    command = [BINARY, "judge", folder / "runs", "--questions", "--json", *numbers]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    truths = {}
    for room in json.loads(done.stdout)["rooms"]:
        for name in ("scene.png", "scene-walls.png"):
            picture = folder / "runs" / room["name"] / name
            if picture.exists():
                known = truths.setdefault(hashlib.sha256(picture.read_bytes()).hexdigest(), {})
                known.update({q["question"]: q["truth"] for q in room["questions"]})
    return truths


class Judge(FaultServer):
    def __init__(self, kind, folder, options):
        self.kind, self.truths = kind, truths_of(folder, options) if kind == "sees" else {}
        super().__init__([scripted(self.reply)])

    def reply(self, request):
        body = request.json()
        name, parts = body["tools"][0]["function"]["name"], body["messages"][-1]["content"]
        text = " ".join(part["text"] for part in parts if part["type"] == "text")
        url = next(part["image_url"]["url"] for part in parts if part["type"] == "image_url")
        picture = base64.b64decode(url.split(",", 1)[1])
        if name == "score":
            return call(name, {"score": {"sees": 0.9, "yes": 1.0, "blind": 0.5}[self.kind], "reason": "scripted"})
        return call(name, {"answer": self.answer(picture, text), "reason": "scripted"})

    def answer(self, picture, text):
        if self.kind == "yes":
            return "yes"
        if self.kind == "blind":
            return "yes" if hashlib.sha256(text.encode() + picture).digest()[0] % 2 else "no"
        known = self.truths.get(hashlib.sha256(picture).hexdigest(), {})
        return next(("yes" if so else "no" for question, so in known.items() if question in text), "unsure")


def main():
    kind, suite, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    with tempfile.TemporaryDirectory() as cache, Judge(kind, folder, sys.argv[4:]) as server:
        env = {**os.environ, "OPENAI_BASE_URL": server.url, "OPENAI_API_KEY": "none", "XDG_CACHE_HOME": cache}
        judged = ["--vlm", "--vlm-model", f"scripted-{kind}", *sys.argv[4:]]
        return subprocess.run([BINARY, "experiment", suite, "-o", folder, *judged], env=env, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
