"""The judgement of a vision model against a scripted server that receives the picture, decodes it, and plays a judge who sees, one who says
yes to everything and one who is blind: the figures come out as planted."""

import base64
import hashlib
import io
import re
import unittest

import model_case
from fault_server import FaultServer, call, scripted

try:
    from PIL import Image
except ImportError:
    Image = None


def thing(name, category, size, at, turn, on="floor", mount="floor"):
    return {"id": name, "category": category, "size": size, "pos": at, "rotation": turn, "supportedBy": on, "mount": mount}


ROOM = {
    "format": "layoutbox/layout@1",
    "prompt": "A bedroom with a bed, a nightstand with a lamp, a desk and a wardrobe.",
    "room": {"polygon": [[0, 0], [5, 0], [5, 4], [0, 4]], "height": 2.6},
    "objects": [
        thing("bed_1", "bed", [1.6, 2.0, 0.5], [2.5, 3.0, 0], 0),
        thing("stand_1", "nightstand", [0.45, 0.4, 0.5], [1.4, 3.8, 0], 0),
        thing("lamp_1", "table_lamp", [0.2, 0.2, 0.4], [1.4, 3.8, 0.5], 0, on="stand_1", mount="surface"),
        thing("desk_1", "desk", [1.2, 0.6, 0.75], [0.3, 1.5, 0], 90),
        thing("wardrobe_1", "wardrobe", [1.2, 0.6, 2.0], [4.7, 1.5, 0], 270),
    ],
}
OPTIONS = ["--singles", "12", "--multis", "4"]


class VisionServer(FaultServer):
    """Answers chat completions with a picture by `judge(picture, question)`."""

    def __init__(self, judge):
        self.judge, self.pictures, self.errors = judge, [], []
        super().__init__([scripted(self.reply)])

    @property
    def count(self):
        return len(self.requests)

    def reply(self, request):
        body = request.json()
        name = body["tools"][0]["function"]["name"]
        try:
            if name == "write_questions":
                return call(name, self.write(body["messages"][-1]["content"]))
            return call(name, self.answer(name, body["messages"][-1]["content"]))
        except Exception as error:  # told by the test, which else would only see a broken answer
            self.errors.append(repr(error))
            return call(name, {"answer": "unsure", "reason": "", "score": 0})

    @staticmethod
    def write(text):
        """Every statement but the first as a question of its own wording."""
        statements = re.findall(r"^(\d+)\. (.+)$", text, re.MULTILINE)
        assert "wardrobe_1" in text, "the scene is not shown"
        return {"questions": [{"number": int(n), "question": f"Can it be seen that {what}?"} for n, what in statements[1:]]}

    def answer(self, name, parts):
        urls = [part["image_url"]["url"] for part in parts if part["type"] == "image_url"]
        text = " ".join(part["text"] for part in parts if part["type"] == "text")
        assert len(urls) == 1 and urls[0].startswith("data:image/png;base64,"), urls[0][:40]
        picture = Image.open(io.BytesIO(base64.b64decode(urls[0].split(",", 1)[1]))).convert("RGB")
        picture.load()
        self.pictures.append(picture.size)
        if name == "score":
            return {"score": self.judge(picture, None), "reason": "scripted"}
        return {"answer": self.judge(picture, text), "reason": "scripted"}


@unittest.skipIf(Image is None, "no Pillow")
class Vision(model_case.ModelCase):
    def setUp(self):
        super().setUp()
        self.path("room").mkdir()
        self.room = self.write_json("room/layout.json", ROOM)
        picture = Image.new("RGB", (64, 48), (10, 200, 30))
        picture.save(self.path("room/scene.png"))

    def truths(self):
        """Question → is it so?, as geometry says."""
        answers = self.run_layoutbox("judge", self.room, "--questions", "--json", *OPTIONS).json()
        self.assertEqual(answers["figures"]["all"]["accuracy"]["value"], 1)
        return {q["question"]: q["truth"] for room in answers["rooms"] for q in room["questions"]}

    def ask(self, judge, *more, env=None):
        with VisionServer(judge) as server:
            options = ["--by", "vlm", "--json", *OPTIONS, *more]
            run = self.run_layoutbox("judge", self.room, *options, env=self.environment(server, **(env or {})))
            self.assert_status(run, 0)
            self.assertEqual(server.errors, [])
            return run.json(), server

    def seeing(self, truths):
        def judge(picture, text):
            self.assertEqual(picture.getpixel((5, 5)), (10, 200, 30))
            if text is None:
                return 0.9
            return "yes" if next(truth for question, truth in truths.items() if question in text) else "no"

        return judge

    def test_who_sees_is_right(self):
        truths = self.truths()
        self.assertGreaterEqual(len(truths), 24)
        self.assertEqual(2 * sum(truths.values()), len(truths))
        answers, server = self.ask(self.seeing(truths))
        figures = answers["figures"]
        for name in ("accuracy", "precision", "recall", "kappa"):
            self.assertEqual(figures["all"][name]["value"], 1, name)
        self.assertEqual(figures["meanScore"], 0.9)
        self.assertEqual(set(server.pictures), {(64, 48)})
        self.assertEqual({q["saw"] for q in answers["rooms"][0]["questions"]}, {"picture"})
        self.assertEqual({s["against"] for s in answers["rooms"][0]["scores"]}, {"scene", "prompt"})

    def test_who_says_yes_is_right_half_the_time(self):
        answers, _ = self.ask(lambda picture, text: "yes" if text else 1.0)
        figures = answers["figures"]["all"]
        self.assertEqual(figures["accuracy"]["value"], 0.5)
        self.assertEqual(figures["recall"]["value"], 1)
        self.assertEqual(figures["precision"]["value"], 0.5)
        self.assertEqual(figures["kappa"]["value"], 0)

    def test_who_is_blind_agrees_by_chance(self):
        # A bound of 95 % misses the truth once in twenty times.
        chance = 0
        for salt in range(8):

            def coin(picture, text, salt=salt):
                return "yes" if text and hashlib.sha256(f"{salt} {text}".encode()).digest()[0] % 2 else "no" if text else 0.5

            kappa = self.ask(coin)[0]["figures"]["all"]["kappa"]
            chance += kappa["low"] < 0 < kappa["high"]
        self.assertGreaterEqual(chance, 6)

    def test_who_will_not_say_is_counted_apart(self):
        answers, _ = self.ask(lambda picture, text: "unsure" if text else 0.5)
        figures = answers["figures"]["all"]
        self.assertEqual(figures["neitherRate"]["value"], 1)
        self.assertIsNone(figures["kappa"])

    def test_questions_in_the_models_words_keep_their_truth(self):
        def judge(picture, text):
            return ("yes" if text.startswith("Can it be seen") else "no") if text else 0.5

        answers, server = self.ask(judge, "--written")
        questions = answers["rooms"][0]["questions"]
        self.assertEqual([q["writtenBy"] for q in questions], ["program"] + ["model"] * (len(questions) - 1))
        self.assertEqual(server.count, 1 + len(questions) + 2)
        for question in questions[1:]:
            self.assertEqual(question["question"], f"Can it be seen that {', and '.join(hop['sentence'] for hop in question['hops'])}?")
            self.assertEqual(question["truth"], all(hop["holds"] for hop in question["hops"]))
            self.assertEqual(question["answers"][0]["verdict"], "yes")

    def test_a_model_without_eyes_writes_what_geometry_answers(self):
        with VisionServer(lambda picture, text: 1 / 0) as server:
            options = ["--questions", "--written", "--json", *OPTIONS]
            answers = self.run_layoutbox("judge", self.room, *options, env=self.environment(server)).json()
            self.assertEqual((server.errors, server.count), ([], 1))
        questions = answers["rooms"][0]["questions"]
        self.assertTrue(all(q["writtenBy"] == "model" and q["question"].startswith("Can it be seen") for q in questions[1:]))
        self.assertEqual(answers["figures"]["all"]["accuracy"]["value"], 1)

    def test_repeats_are_asked_apart_and_kept(self):
        turn = iter(range(10**6))
        often = ["--repeats", "3", "--temperature", "1"]
        answers, server = self.ask(lambda picture, text: ("yes" if next(turn) % 2 else "no") if text else 0.5, *often)
        questions = answers["rooms"][0]["questions"]
        self.assertTrue(all(len(q["answers"]) == 3 for q in questions))
        self.assertEqual(answers["figures"]["unsteady"]["value"], 1)
        self.assertEqual(server.count, 3 * len(questions) + 6)
        address = answers["judge"].split(" at ")[1]
        again, server = self.ask(lambda picture, text: 1 / 0, *often, "--base-url", address)
        self.assertEqual(server.count, 0)
        self.assertEqual(again["rooms"], answers["rooms"])

    def test_the_models_own_temperature(self):
        answers, server = self.ask(lambda picture, text: "yes" if text else 0.5, "--temperature", "default")
        self.assertIsNone(answers["temperature"])
        self.assertTrue(all("temperature" not in request.json() for request in server.requests))
        _, server = self.ask(lambda picture, text: "yes" if text else 0.5, "--temperature", "0.5")
        self.assertEqual({request.json()["temperature"] for request in server.requests}, {0.5})

    def test_verify_asks_as_judge_does(self):
        """The same questions by the same code; the report by geometry beside them."""
        truths = self.truths()
        with VisionServer(self.seeing(truths)) as server:
            files = ["-o", self.path("report.json"), "--report", self.path("report.html"), "--answers", self.path("answers.json")]
            options = ["--by", "vlm", "--json", "--reasons", *OPTIONS, *files]
            run = self.run_layoutbox("verify", self.room, *options, env=self.environment(server))
            self.assertIn(run.status, (0, 1))
            self.assertEqual(server.errors, [])
        answers = self.read_json("answers.json")
        self.assertEqual(answers, run.json())
        self.assertEqual(answers["figures"]["all"]["accuracy"]["value"], 1)
        self.assertEqual(answers["rooms"][0]["scores"][0]["reason"], "scripted")
        self.assertEqual(run.status == 0, self.read_json("report.json")["passed"])
        self.assertIn("data:image/png;base64,", self.path("report.html").read_text())
        by_geometry = self.run_layoutbox("verify", self.room, "--questions", "--json", *OPTIONS).json()
        self.assertEqual({q["question"]: q["truth"] for q in by_geometry["rooms"][0]["questions"]}, truths)

    def test_verify_shows_a_picture_that_is_given(self):
        self.path("room/scene.png").unlink()
        Image.new("RGB", (32, 24), (10, 200, 30)).save(self.path("other.png"))
        with VisionServer(lambda picture, text: "no" if text else 0.1) as server:
            run = self.run_layoutbox("verify", self.room, "--by", "vlm", "--image", self.path("other.png"), env=self.environment(server))
            self.assertIn(run.status, (0, 1))
            self.assertEqual(set(server.pictures), {(32, 24)})

    def test_a_room_without_picture_is_shown_by_its_plan(self):
        self.path("room/scene.png").unlink()
        sizes = set()

        def judge(picture, text):
            sizes.add(picture.size)
            self.assertGreater(len(picture.getcolors(1 << 24)), 3)  # something is drawn
            return "yes" if text else 0.5

        answers, _ = self.ask(judge)
        self.assertTrue(all(width > 500 for width, _ in sizes))

    def test_without_key_it_says_so(self):
        run = self.run_layoutbox("judge", self.room, "--by", "vlm", env={"OPENAI_API_KEY": None, "XDG_CACHE_HOME": self.folder / "cache"})
        self.assert_status(run, 3)
        self.assertIn("OPENAI_API_KEY", run.err)


if __name__ == "__main__":
    unittest.main()
