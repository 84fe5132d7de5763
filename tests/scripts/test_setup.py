"""setup.sh says what is missing and how to get it, and does nothing where all is there. On a copy, with nothing fetched."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]


class Setup(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory(prefix="setup with blank ")))
        self.root = self.folder / "check out"
        shutil.copytree(SOURCE / "scripts", self.root / "scripts")
        for folder in ("tests/tools", "tests/render/three", "tests/llm/mocks"):
            (self.root / folder).mkdir(parents=True)
            for file in (SOURCE / folder).glob("package*.json"):
                shutil.copy(file, self.root / folder)
        self.packages("build cmd:sh dash\n")
        self.solver = self.folder / "own solver/lib"
        self.solver.mkdir(parents=True)
        (self.solver / "libortools.so.9").touch()
        self.programs = self.folder / "programs"
        self.programs.mkdir()

    def packages(self, text):
        (self.root / "scripts/packages.txt").write_text(text)

    def fake(self, name, text):
        """Puts a stand-in of a program first on the PATH."""
        (self.programs / name).write_text(f"#!/bin/sh\n{text}\n")
        (self.programs / name).chmod(0o755)

    def run_setup(self, *arguments, **environment):
        values = {"ORTOOLS_ROOT": self.solver.parent, "LAYOUTBOX_BLENDER": "/bin/true", **environment}
        env = {**os.environ, **{name: str(value) for name, value in values.items() if value is not None}}
        for name, value in values.items():
            if value is None:
                env.pop(name, None)
        env["PATH"] = f"{self.programs}:{env['PATH']}"
        done = subprocess.run(
            [self.root / "scripts/setup.sh", *arguments], text=True, capture_output=True, env=env, stdin=subprocess.DEVNULL, check=False
        )
        return done.returncode, done.stdout, done.stderr

    def test_all_there_and_then_nothing_to_do(self):
        status, out, err = self.run_setup()
        self.assertEqual((status, out, err), (0, "", "setup: everything is in place\n"))
        self.assertEqual(self.run_setup(), (0, "", ""))

    def test_force_looks_again(self):
        self.run_setup()
        self.assertEqual(self.run_setup("--force")[2], "setup: everything is in place\n")

    def test_changed_inputs_are_looked_at_again(self):
        self.run_setup()
        with (self.root / "scripts/requirements/solver.txt").open("a") as file:
            file.write("# another\n")
        self.assertIn("everything is in place", self.run_setup()[2])

    def test_what_went_away_is_noticed(self):
        self.run_setup()
        (self.solver / "libortools.so.9").unlink()
        status, _, err = self.run_setup()
        self.assertEqual(status, 3)
        self.assertIn("ORTOOLS_ROOT", err)

    def test_without_root_it_prints_the_exact_line(self):
        self.packages("build inc:no/such/header.h libnowhere-dev\nbuild cmd:sh dash\npicture lib:libnosuch.so.1 libnosuch1\n")
        self.fake("id", "echo 1000")
        self.fake("apt-get", "exit 9")
        status, _, err = self.run_setup()
        self.assertEqual(status, 3)
        self.assertIn("sudo apt-get update && sudo apt-get install -y --no-install-recommends libnowhere-dev libnosuch1\n", err)

    def test_as_root_it_installs_exactly_what_is_missing(self):
        header = self.folder / "include/no/such.h"
        self.packages("build inc:no/such.h libnowhere-dev\nbuild cmd:sh dash\n")
        self.fake("id", "echo 0")
        self.fake("apt-get", f'echo "$@" >> "{self.folder}/asked"; mkdir -p "{header.parent}"; touch "{header}"')
        status, _, err = self.run_setup(CPLUS_INCLUDE_PATH=self.folder / "include")
        self.assertEqual(status, 0, err)
        self.assertIn("installing by apt-get: libnowhere-dev\n", err)
        asked = (self.folder / "asked").read_text().splitlines()
        self.assertEqual(asked[0], "update")
        self.assertTrue(asked[1].endswith("install -y --no-install-recommends libnowhere-dev"), asked)

    def test_a_package_that_cannot_be_installed_is_an_error_with_its_log(self):
        self.packages("build cmd:no-such-program nowhere\n")
        self.fake("id", "echo 0")
        self.fake("apt-get", "echo E: Unable to locate package nowhere; exit 100")
        status, _, err = self.run_setup()
        self.assertEqual(status, 3)
        self.assertIn("Unable to locate package nowhere", err)
        self.assertIn(str(self.root / "build/logs/setup.log"), err)

    def test_another_processor_is_an_error_in_words(self):
        self.fake("uname", "echo riscv64")
        status, _, err = self.run_setup(ORTOOLS_ROOT=None)
        self.assertEqual(status, 3)
        self.assertIn("this machine is riscv64", err)
        self.assertIn("ORTOOLS_ROOT", err)

    def test_blender_can_be_left_to_a_later_run(self):
        self.fake("python3.11", "exit 1")
        self.fake("apt-get", "exit 9")
        status, _, err = self.run_setup("--blender-later", LAYOUTBOX_BLENDER=None)
        self.assertEqual(status, 0, err)
        self.assertRegex(err, r"^setup: Blender [0-9.]+ \(370 MB\) is fetched while the program is compiled\n$")
        self.assertIn("no Blender could be had", self.run_setup(LAYOUTBOX_BLENDER=None)[2])

    def test_ray_and_others_are_fetched_when_asked_for(self):
        # An environment whose pip does as it is told, or fails.
        pip = 'mkdir -p "$3/bin"; printf "#!/bin/sh\\nexit %s\\n" > "$3/bin/python"; chmod +x "$3/bin/python"'
        self.fake("python3", pip % "1")
        status, _, err = self.run_setup("--scale")
        self.assertEqual(status, 3)
        self.assertIn("Ray, submitit and PyArrow could not be fetched", err)
        self.assertFalse((self.root / "build/deps/scale").exists())
        self.fake("python3", pip % "0")
        self.assertEqual(self.run_setup("--scale")[0], 0)
        self.assertTrue((self.root / "build/deps/scale/requirements.txt").exists())
        self.assertEqual(self.run_setup("--scale"), (0, "", ""))
        with (self.root / "scripts/requirements/scale.txt").open("a") as file:
            file.write("# another\n")
        self.assertIn("fetching Ray", self.run_setup("--scale")[2])

    def test_wrong_option(self):
        self.assertEqual(self.run_setup("--everything")[0], 2)

    def test_no_address_of_a_registry_is_recorded(self):
        locks = [SOURCE / folder / "package-lock.json" for folder in ("tests/tools", "tests/render/three", "tests/llm/mocks", "web")]
        pinned = [*(SOURCE / "scripts/requirements").iterdir(), *locks]
        for file in pinned:
            self.assertNotIn("://", file.read_text(), file)
