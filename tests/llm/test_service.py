"""A service that offers a language model: who asks chooses, and the key is told to nobody."""

import sys
import tempfile
from pathlib import Path

from fault_server import FaultServer, scene_call
from model_case import KEY, PROMPT, SCENE, ModelCase

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "serve"))

from service import Service  # noqa: E402


class ModelInService(ModelCase):
    def start(self, server, *options):
        environment = {name: str(value) for name, value in self.environment(server).items() if value is not None}
        service = Service(Path(self.enterContext(tempfile.TemporaryDirectory())), *options, **environment)
        self.addCleanup(service.stop)
        return service

    def test_the_planner_is_chosen_by_who_asks(self):
        with FaultServer([scene_call(SCENE)]) as server:
            service = self.start(server, "--planner", "llm", "--model", "test-model")
            self.assertEqual(service.get("/api/health").json()["planners"], ["offline", "llm"])
            self.assertEqual(service.post("/api/generate", {"prompt": PROMPT}).status, 200)
            self.assertEqual(len(server.requests), 0)
            answer = service.post("/api/generate", {"prompt": PROMPT, "planner": "llm"})
            self.assertEqual(answer.status, 200, str(answer))
            self.assertEqual(len(server.requests), 1)
            self.assertEqual({item["id"] for item in answer.json()["layouts"][0]["objects"]}, {"bed_1", "desk_1", "lamp_1"})
            self.assertNotIn(KEY.encode(), answer.body)

    def test_without_a_model_the_choice_is_refused(self):
        with FaultServer([scene_call(SCENE)]) as server:
            service = self.start(server)
            self.assertEqual(service.get("/api/health").json()["planners"], ["offline"])
            answer = service.post("/api/plan", {"prompt": PROMPT, "planner": "llm"})
            self.assertEqual((answer.status, answer.json()["pointer"]), (422, "/planner"))
            self.assertEqual(len(server.requests), 0)
