"""An installed program is whole: it needs nothing of the folder that it was built in."""

import os
import shlex
import shutil
import subprocess
import unittest

from harness import BINARY, DEPS, SOURCE, CliTestCase, clean_environment

HEADERS = sorted((SOURCE / "include/layoutbox").glob("*.h"))


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

    def run_outside_program(self, program):
        done = subprocess.run([program, "A bedroom with a bed."], capture_output=True, text=True, cwd=self.folder, timeout=300, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("bed_1", done.stdout)
        self.assertTrue((self.folder / "room.glb").read_bytes().startswith(b"glTF"))
        self.assertIn("</svg>", (self.folder / "plan.svg").read_text())

    def must(self, *command, **options):
        done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_an_outside_project_links_the_library(self):
        project = shutil.copytree(SOURCE / "examples/cpp", self.path("outside"))
        build = self.path("outside-build")
        self.must("cmake", "-G", "Ninja", "-S", project, "-B", build, f"-DCMAKE_PREFIX_PATH={self.place}")
        self.must("cmake", "--build", build)
        self.run_outside_program(build / "furnish_a_room")

    @unittest.skipUnless(shutil.which("pkg-config") and shutil.which("g++"), "pkg-config is not there")
    def test_pkg_config_knows_the_library(self):
        found = list(self.place.glob("**/pkgconfig/layoutbox.pc"))
        self.assertEqual(len(found), 1)
        env = {**os.environ, "PKG_CONFIG_PATH": str(found[0].parent)}
        flags = shlex.split(self.must("pkg-config", "--cflags", "--libs", "--static", "layoutbox", env=env))
        header = self.write_text("all.cc", "".join(f"#include <layoutbox/{path.name}>\n" for path in HEADERS))
        self.must("g++", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", *flags, header)
        program = self.path("by-pkg-config")
        self.must("g++", SOURCE / "examples/cpp/furnish_a_room.cc", "-o", program, *flags)
        self.run_outside_program(program)

    def test_licences_come_with_it(self):
        for name in ("LICENSE", "NOTICE"):
            self.assertTrue(list(self.place.glob(f"share/doc/*/{name}")), name)
