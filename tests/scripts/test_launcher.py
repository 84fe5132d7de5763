"""./layoutbox builds when it must, only then, and hands everything on to the program. On a stand-in of the repository."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(standin LANGUAGES NONE)
set(out ${CMAKE_BINARY_DIR}/src/layoutbox/layoutbox)
add_custom_command(OUTPUT ${out} COMMAND sh ${CMAKE_SOURCE_DIR}/src/make.sh ${out} DEPENDS src/make.sh src/program.sh VERBATIM)
add_custom_target(layoutbox DEPENDS ${out})
"""
MAKE = """set -e
mkdir -p "$(dirname "$1")"
cp "$(dirname "$0")/program.sh" "$1.part"
chmod +x "$1.part"
mv "$1.part" "$1"
echo built >> "$(dirname "$0")/../made"
"""
PROGRAM = """#!/bin/sh
printf 'arguments:'; printf ' <%s>' "$@"; echo
echo "input: $(cat)"
exit 7
"""


@unittest.skipUnless(shutil.which("cmake") and shutil.which("ninja"), "cmake and ninja are not there")
class Launcher(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory(prefix="launcher with blank ")))
        self.root = self.folder / "check out"
        for name in ("scripts", "src", "elsewhere"):
            (self.root / name).mkdir(parents=True)
        shutil.copy(SOURCE / "layoutbox", self.root)
        shutil.copy(SOURCE / "scripts/build.sh", self.root / "scripts")
        shutil.copy(SOURCE / "CMakePresets.json", self.root)
        self.write("scripts/setup.sh", "#!/bin/sh\necho set up >> made\n", executable=True)
        self.write("CMakeLists.txt", PROJECT)
        self.write("src/make.sh", MAKE)
        self.write("src/program.sh", PROGRAM)

    def write(self, name, text, executable=False):
        path = self.root / name
        path.write_text(text)
        if executable:
            path.chmod(0o755)

    def start(self, *arguments, program=None, cwd=None):
        command = [str(program or self.root / "layoutbox"), *arguments]
        pipe = subprocess.PIPE
        return subprocess.Popen(command, cwd=cwd or self.folder, text=True, stdin=pipe, stdout=pipe, stderr=pipe, env=dict(os.environ))

    def launch(self, *arguments, stdin="", **options):
        process = self.start(*arguments, **options)
        out, err = process.communicate(stdin, timeout=60)
        return process.returncode, out, err

    def times_built(self):
        made = self.root / "made"
        return made.read_text().count("built") if made.exists() else 0

    def test_first_run_builds_and_hands_everything_on(self):
        status, out, err = self.launch("plan", "a bed  and", "--seed=1", "", stdin="from a pipe")
        self.assertEqual(status, 7, err)
        self.assertEqual(out, "arguments: <plan> <a bed  and> <--seed=1> <>\ninput: from a pipe\n")
        self.assertIn("first build", err)
        self.assertEqual(self.times_built(), 1)

    def test_later_runs_only_run(self):
        self.launch()
        made = (self.root / "made").read_text()
        status, _, err = self.launch()
        self.assertEqual((status, err), (7, ""))
        self.assertEqual((self.root / "made").read_text(), made)

    def test_a_changed_source_is_built_again(self):
        self.launch()
        self.write("src/program.sh", "#!/bin/sh\necho new\n")
        status, out, _ = self.launch()
        self.assertEqual((status, out), (0, "new\n"))

    def test_by_symbolic_link_from_another_folder(self):
        link = self.folder / "link"
        link.symlink_to(self.root / "layoutbox")
        status, out, err = self.launch("x", program=link, cwd=self.root / "elsewhere")
        self.assertEqual((status, out.splitlines()[0]), (7, "arguments: <x>"), err)

    def test_a_failed_build_says_why_and_where_the_log_is(self):
        self.write("src/make.sh", "echo the compiler is cross; exit 1\n")
        status, out, err = self.launch("plan")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("the compiler is cross", err)
        self.assertIn(str(self.root / "build/logs/build-release.log"), err)

    def test_a_failed_build_is_tried_again(self):
        self.write("src/make.sh", "exit 1\n")
        self.launch()
        self.write("src/make.sh", MAKE)
        self.assertEqual(self.launch()[0], 7)

    def test_a_failed_set_up_stops(self):
        self.write("scripts/setup.sh", "#!/bin/sh\necho no compiler >&2\nexit 3\n", executable=True)
        status, out, err = self.launch("plan")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("no compiler", err)

    def test_two_first_runs_at_once(self):
        processes = [self.start(str(number)) for number in range(3)]
        for number, process in enumerate(processes):
            out, err = process.communicate("", timeout=60)
            self.assertEqual((process.returncode, out.splitlines()[0]), (7, f"arguments: <{number}>"), err)
        self.assertEqual(self.times_built(), 1)

    def test_a_build_folder_from_elsewhere_is_made_anew(self):
        self.launch()
        moved = self.folder / "moved"
        self.root.rename(moved)
        self.root = moved
        self.write("src/program.sh", "#!/bin/sh\necho moved\n")
        status, out, err = self.launch()
        self.assertEqual((status, out), (0, "moved\n"), err)
