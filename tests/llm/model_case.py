"""What the tests of the planner by model share: a scene, a clean environment, and the run of one command against a server."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))

from harness import CliTestCase  # noqa: E402

KEY = "sk-secret-0123456789abcdef"
PROMPT = "A bedroom of 4 x 3.5 x 2.6 m with a bed, a desk and a lamp. The bed stands against the back wall."
SCENE = {
    "metadata": {"roomType": "bedroom"},
    "room": {"dims": {"w": 4, "d": 3.5, "h": 2.6}},
    "furniture": [
        {"id": "bed_1", "category": "bed", "name": "bed"},
        {"id": "desk_1", "category": "desk", "name": "desk"},
        {"id": "lamp_1", "category": "lamp", "name": "lamp"},
    ],
    "constraints": [{"id": "c1", "type": "againstWall", "targets": ["bed_1"], "relativeTo": ["wall3"], "why": "against the back wall"}],
}
QUICK = ["--attempt-pause", "0"]


class ModelCase(CliTestCase):
    def environment(self, server, **changes):
        env = {
            "OPENAI_BASE_URL": server if isinstance(server, str) else server.url,
            "OPENAI_API_KEY": KEY,
            "XDG_CACHE_HOME": self.folder / "cache",
            "NO_PROXY": "127.0.0.1,localhost",
            "http_proxy": None,
            "https_proxy": None,
            "HTTP_PROXY": None,
            "HTTPS_PROXY": None,
            "ALL_PROXY": None,
            "all_proxy": None,
            "SSL_CERT_FILE": None,
        }
        return {**env, **changes}

    def plan(self, server, *options, prompt=PROMPT, env=None, **more):
        """`plan --planner llm` into scene.json."""
        arguments = ["plan", prompt, "--planner", "llm", "-o", self.path("scene.json"), *QUICK, *options]
        return self.run_layoutbox(*arguments, env=self.environment(server, **(env or {})), **more)

    def generate(self, server, *options, prompt=PROMPT, env=None):
        """`generate --planner llm --no-render` into out/."""
        arguments = ["generate", prompt, "--planner", "llm", "--no-render", "-o", self.path("out"), *QUICK, *options]
        return self.run_layoutbox(*arguments, env=self.environment(server, **(env or {})))

    def requests_of_run(self):
        return self.read_json("out/run.json")["modelRequests"]

    def assert_no_key(self, run):
        """The key stands in no output and in no file."""
        self.assertNotIn(KEY, run.out + run.err)
        for path in self.folder.rglob("*"):
            if path.is_file():
                self.assertNotIn(KEY.encode(), path.read_bytes(), str(path))
