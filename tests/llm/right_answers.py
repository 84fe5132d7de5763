"""A model that answers as the annotation of a prompt says: is its answer left as it is, and is a wrong one found?

    right_answers.py BINARY ANNOTATIONS.csv… [--list]

For every annotated prompt (columns ID, Description, ObjCount, OORel, OARel) a scene is made from the annotation and played by a scripted
server to `batch --planner llm`. Counted are
  lost      things and relations of the answer that the scene no longer has, or has otherwise
  denied    things and relations that were added although the annotation denies them: a kind of which it has its number already, or a
            side or wall other than the annotated one
  requests  of the prompts whose answer has a layout by itself (`--trust model`)
  found     wrong answers (a thing forgotten, one too few, one too many) that come back with a note about a thing that the right one has not
"""

import argparse
import csv
import json
import os
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from annotated_answers import entries, forgotten, right_answer, snake, too_few, too_many  # noqa: E402
from fault_server import FaultServer, call, scripted  # noqa: E402

SIDES = {"leftOf", "rightOf", "inFrontOf", "behind"}
HEIGHTS = {"on", "in", "under", "above"}
WALLS = {"againstWall", "onWall", "centeredOnWall", "corner", "centerOfRoom"}


class Player:
    """Plays the answers of a table's prompts; counts the requests for each."""

    def __init__(self, rows, answers):
        self.answers = {" ".join(row["Description"].split()): answer for row, answer in zip(rows, answers, strict=True)}
        self.requests = Counter()

    def __call__(self, request):
        user = next(message["content"] for message in request.json()["messages"] if message["role"] == "user")
        prompt = " ".join(user.replace("<request>", "").replace("</request>", "").replace("‹", "<").split())
        self.requests[prompt] += 1
        return call("create_scene", self.answers[prompt])


# What becomes of the scene matters little: no repair, and not much of a search.
ROUGHLY = ["--on-conflict", "relax", "--effort", "1", "--time-limit", "0.5"]


def play(binary, rows, answers, *options):
    """(scene.json or None, requests, whether the layout holds it all) of each row."""
    if not rows:
        return []
    player = Player(rows, answers)
    with tempfile.TemporaryDirectory() as folder, FaultServer([scripted(player)]) as server:
        prompts, out = Path(folder) / "prompts.jsonl", Path(folder) / "out"
        prompts.write_text("".join(json.dumps({"id": row["ID"], "prompt": row["Description"]}) + "\n" for row in rows), encoding="utf-8")
        kept = {name: value for name, value in os.environ.items() if not name.upper().endswith("_PROXY")}
        env = {**kept, "OPENAI_BASE_URL": server.url, "OPENAI_API_KEY": "sk-x", "NO_PROXY": "127.0.0.1,localhost", "XDG_CACHE_HOME": folder}
        arguments = ["batch", prompts, "-o", out, "--no-render", "--planner", "llm", "--no-cache", "--attempt-pause", "0"]
        done = subprocess.run([binary, *map(str, arguments), *options], env=env, capture_output=True, text=True, check=False)
        if done.returncode not in (0, 1):
            raise RuntimeError(f"batch ended with {done.returncode}\n{done.stderr}")
        results = []
        for row in rows:
            path = out / row["ID"] / "scene.json"
            scene = json.loads(path.read_text(encoding="utf-8")) if path.is_file() else None
            layout = path.with_name("layout.json")
            solved = layout.is_file() and json.loads(layout.read_text(encoding="utf-8"))["status"] == "solved"
            results.append((scene, player.requests[" ".join(row["Description"].split())], solved))
        return results


def relation_key(relation):
    references = relation.get("relativeTo", [])
    return relation["type"], tuple(relation["targets"]), tuple([references] if isinstance(references, str) else references)


def losses(answer, scene):
    """Things and relations of the answer that are gone or changed."""
    things = {item["id"] for item in scene["furniture"]}
    lost = [f"thing {item['id']}" for item in answer["furniture"] if item["id"] not in things]
    kept = {relation_key(relation) for relation in scene["constraints"]}
    return lost + [f"relation {relation_key(r)}" for r in answer["constraints"] if relation_key(r) not in kept]


def opposed(one, other):
    """Two relations of one thing that cannot both be."""
    (kind, targets, references), (other_kind, others, other_references) = relation_key(one), relation_key(other)
    if not set(targets) & set(others):
        return False
    if kind == other_kind:
        return kind in ("againstWall", "onWall") and bool(references) and bool(other_references) and references != other_references
    for group in (SIDES, HEIGHTS):
        if kind in group and other_kind in group and set(references) & set(other_references):
            return True
    return kind in WALLS and other_kind in WALLS and "centerOfRoom" in (kind, other_kind)


def additions(answer, scene, row):
    """What the scene has beyond the answer and the annotation denies, and how much was added in all. Assumptions are no additions."""
    had = {item["id"] for item in answer["furniture"]}
    told = {relation_key(relation) for relation in answer["constraints"]}
    new_things = [item for item in scene["furniture"] if item["id"] not in had and not item.get("assumed")]
    new_relations = [r for r in scene["constraints"] if relation_key(r) not in told and not r.get("assumed")]
    # The annotation has all things of the room; of some kinds it leaves open how many.
    open_kinds = {snake(word) for quantifier, _, word in entries(row["ObjCount"]) if quantifier != "eq"}
    wrong = [f"thing {item['id']}" for item in new_things if item["category"] not in open_kinds]
    wrong += [f"relation {relation_key(r)}" for r in new_relations if any(opposed(r, made) for made in answer["constraints"])]
    return wrong, len(new_things) + len(new_relations)


def differences(scene):
    return Counter(note["message"] for note in scene.get("notes", []) if note["code"] == "text-differs") if scene else Counter()


ABOUT_THINGS = ("the text names", "the text has", "the model adds")


def measure_right(binary, rows, figures, lines):
    """The right answers; the differences that each is noted to have."""
    answers = {row["ID"]: right_answer(row) for row in rows}
    alone = play(binary, rows, answers.values(), "--trust", "model", *ROUGHLY)
    # An answer that has no layout is asked about again with reason.
    sound = [row for row, (_, _, solved) in zip(rows, alone, strict=True) if solved]
    others = [row for row in rows if row not in sound]
    noted = {}
    for some, options in ((sound, []), (others, ROUGHLY)):
        played = play(binary, some, [answers[row["ID"]] for row in some], *options)
        for row, (scene, requests, _) in zip(some, played, strict=True):
            name, answer = row["ID"], answers[row["ID"]]
            figures["parts"] += len(answer["furniture"]) + len(answer["constraints"])
            noted[name] = differences(scene)
            if scene is None:
                figures["lost"] += 1
                lines.append(f"{name}: no scene")
                continue
            if some is sound:
                figures["asked"] += 1
                figures["requests"] += requests
                lines += [f"{name}: {requests} requests"] if requests > 1 else []
            lost = losses(answer, scene)
            wrong, added = additions(answer, scene, row)
            figures.update(lost=len(lost), denied=len(wrong), added=added, differences=noted[name].total())
            lines += [f"{name}: lost {what}" for what in lost] + [f"{name}: added {what}" for what in wrong]
    return noted


def measure_wrong(binary, rows, noted, figures, lines):
    """Wrong answers: each must have a note about a thing that the right one has not."""
    for make in (forgotten, too_few, too_many):
        cases = [(row, answer) for row in rows if (answer := make(row)) is not None]
        played = play(binary, [row for row, _ in cases], [answer for _, answer in cases], *ROUGHLY)
        for (row, _), (scene, _, _) in zip(cases, played, strict=True):
            found = any(sentence.startswith(ABOUT_THINGS) for sentence in differences(scene) - noted.get(row["ID"], Counter()))
            settled = scene is not None and len(scene["furniture"]) == len(right_answer(row)["furniture"])
            figures.update({"wrong": 1, "found": found, "settled": settled, f"{make.__name__}": 1, f"{make.__name__} found": found})
            if not found:
                lines.append(f"{row['ID']}: not found ({make.__name__})")


def measure(binary, rows):
    """The figures, and a line for each thing that is wrong."""
    figures, lines = Counter(prompts=len(rows)), []
    noted = measure_right(binary, rows, figures, lines)
    measure_wrong(binary, rows, noted, figures, lines)
    return figures, lines


def read(path):
    with Path(path).open(newline="", encoding="utf-8-sig") as file:
        return [row for row in csv.DictReader(file) if entries(row["ObjCount"])]  # of nothing there is no answer


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("binary")
    parser.add_argument("annotations", nargs="+")
    parser.add_argument("--list", action="store_true", help="each thing that is wrong")
    arguments = parser.parse_args()
    for path in arguments.annotations:
        figures, lines = measure(arguments.binary, read(path))
        print(Path(path).name, dict(figures))
        print(
            f"  lost {figures['lost']} of {figures['parts']}, denied {figures['denied'] / figures['parts']:.2%},"
            f" {figures['requests'] / max(1, figures['asked']):.2f} requests, found {figures['found'] / max(1, figures['wrong']):.1%}"
        )
        if arguments.list:
            print("\n".join("  " + line for line in lines))


if __name__ == "__main__":
    main()
