"""Runs the real program for whole-program tests.

    from harness import CliTestCase

    class Something(CliTestCase):
        def test_it(self):
            run = self.run_layoutbox("validate", self.write_json("scene.json", {...}))
            self.assert_status(run, 2)

By hand: python3 tests/run_case.py tests/cli/test_basics.py Help.test_lists_commands
The program is LAYOUTBOX_BINARY, else the release build.
"""

import importlib.util
import json
import os
import shutil
import subprocess
import tempfile
import unittest
from dataclasses import dataclass
from pathlib import Path

SOURCE = Path(os.environ.get("LAYOUTBOX_SOURCE") or Path(__file__).resolve().parents[2])
BINARY = Path(os.environ.get("LAYOUTBOX_BINARY") or SOURCE / "build/release/src/layoutbox/layoutbox")
DEPS = SOURCE / "build/deps"
SHARED = SOURCE.parent / "shared"  # data and tools that are not part of a checkout

# Exit statuses, see docs and `layoutbox --help`.
DONE, NOT_AS_ASKED, WRONG_INPUT, WRONG_SURROUNDINGS, INTERRUPTED = 0, 1, 2, 3, 130


@dataclass
class Run:
    """One finished run of the program."""

    command: list
    status: int
    out: str
    err: str

    def json(self):
        """The one JSON document on stdout (--json prints nothing else there)."""
        return json.loads(self.out)

    def __str__(self):
        return f"{' '.join(self.command)}\nexit status {self.status}\nstdout:\n{self.out}\nstderr:\n{self.err}"


def clean_environment(home, changes):
    """The caller's environment without what would change the program's answers; `changes` are added, None removes."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("OPENAI_", "LAYOUTBOX_"))}
    if "LAYOUTBOX_BLENDER" in os.environ:
        kept["LAYOUTBOX_BLENDER"] = os.environ["LAYOUTBOX_BLENDER"]
    kept.update(HOME=str(home), NO_COLOR="1", LC_ALL="C.UTF-8")
    for name, value in changes.items():
        if value is None:
            kept.pop(name, None)
        else:
            kept[name] = str(value)
    return kept


def blender_is_there():
    """Whether the program can find a Blender: the places of `layoutbox doctor`."""
    named = os.environ.get("LAYOUTBOX_BLENDER")
    return bool(
        (named and shutil.which(named)) or shutil.which("blender") or importlib.util.find_spec("bpy") or (DEPS / "bpy/bin/python").exists()
    )


def no_sandbox():
    """Why there is none, as the program says it; empty where there is one."""
    doctor = subprocess.run([BINARY, "doctor", "--json"], capture_output=True, text=True, check=False)
    finding = next(item for item in json.loads(doctor.stdout) if item["what"] == "sandbox")
    return "" if finding["there"] else finding["detail"]


needs_blender = unittest.skipUnless(blender_is_there(), "no Blender on this machine")
needs_shared = unittest.skipUnless((SHARED / "tools").is_dir(), "the folder shared/ is not beside this checkout")


class CliTestCase(unittest.TestCase):
    """A test with a folder of its own, `self.folder`, removed afterwards."""

    maxDiff = None

    @classmethod
    def setUpClass(cls):
        if not BINARY.exists():
            raise RuntimeError(f"{BINARY} is not built; ninja layoutbox")
        cls.class_folder = Path(tempfile.mkdtemp(prefix="layoutbox test "))  # a blank in every path, on purpose
        cls.addClassCleanup(shutil.rmtree, cls.class_folder, ignore_errors=True)
        cls.home = cls.class_folder / "home"
        cls.home.mkdir()

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="case ", dir=self.class_folder))

    @classmethod
    def start(cls, *arguments, cwd=None, env=None, **options):
        """The running program, for tests that signal it or read it as it goes."""
        command = [str(argument) for argument in (BINARY, *arguments)]
        environment = clean_environment(cls.home, env or {})
        return subprocess.Popen(command, cwd=cwd or cls.class_folder, env=environment, text=True, **options)

    @classmethod
    def run_layoutbox(cls, *arguments, stdin="", cwd=None, env=None, timeout=300):
        process = cls.start(*arguments, cwd=cwd, env=env, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        try:
            out, err = process.communicate(stdin, timeout=timeout)
        except subprocess.TimeoutExpired:
            process.kill()
            out, err = process.communicate()
            raise AssertionError(f"not finished after {timeout} s\n{out}\n{err}") from None
        return Run(process.args, process.returncode, out, err)

    def assert_status(self, run, status):
        self.assertEqual(run.status, status, str(run))

    def assert_done(self, run):
        self.assert_status(run, DONE)

    def path(self, name):
        return self.folder / name

    def write_text(self, name, text):
        self.path(name).write_text(text, encoding="utf-8")
        return self.path(name)

    def write_json(self, name, value):
        return self.write_text(name, json.dumps(value, ensure_ascii=False))

    def read_json(self, name):
        return json.loads(self.path(name).read_text(encoding="utf-8"))

    def assert_valid_gltf(self, *files):
        """The official validator finds no error and no warning in the files."""
        if not (DEPS / "node/node_modules/gltf-validator").is_dir():
            self.fail("the glTF validator is not there: scripts/setup.sh --tests")
        validator = [shutil.which("node") or "node", SOURCE / "tests/tools/validate_gltf.cjs", *files]
        done = subprocess.run(validator, text=True, capture_output=True, timeout=300, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
