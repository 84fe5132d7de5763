"""An installed program is whole: it needs nothing of the folder that it was built in."""

import shutil
import subprocess
import unittest

from harness import BINARY, DEPS, CliTestCase, clean_environment


@unittest.skipUnless(shutil.which("cmake"), "cmake is not there")
class Installed(CliTestCase):
    def setUp(self):
        super().setUp()
        prefix = self.path("prefix")
        done = subprocess.run(["cmake", "--install", BINARY.parents[2], "--prefix", prefix], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.place = self.path("moved")
        prefix.rename(self.place)

    def run_installed(self, *arguments):
        command = [self.place / "bin/layoutbox", *arguments]
        env = clean_environment(self.home, {"ORTOOLS_ROOT": None})
        return subprocess.run(command, capture_output=True, text=True, env=env, cwd=self.folder, timeout=300, check=False)

    def test_it_furnishes_a_room(self):
        done = self.run_installed("generate", "A bedroom (4 x 3 x 2.5 m) with a bed against the back wall.", "--no-render", "-o", "out")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertTrue((self.folder / "out/layout.json").exists())

    @unittest.skipUnless((DEPS / "ortools").exists(), "the solver library is one of the user's own")
    def test_it_brings_the_solver_library(self):
        done = self.run_installed("doctor")
        self.assertIn(str(self.place / "lib/layoutbox/ortools/.libs/libortools.so.9"), done.stdout, done.stderr)

    def test_licences_come_with_it(self):
        for name in ("LICENSE", "NOTICE"):
            self.assertTrue(list(self.place.glob(f"share/doc/*/{name}")), name)
