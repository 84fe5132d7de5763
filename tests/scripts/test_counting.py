"""Whatever happens to a test run, its last line counts what passed and failed, and its exit status says whether all is well."""

import os
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
CTEST = """#!/usr/bin/env python3
import os, pathlib, sys
pathlib.Path(sys.argv[sys.argv.index("--output-junit") + 1]).write_text(os.environ["JUNIT"])
"""
JUNIT = """<?xml version="1.0"?><testsuite>
<testcase name="a" status="run"><system-out>fine</system-out></testcase>
<testcase name="b" status="run"><system-out>fine</system-out></testcase>
<testcase name="c" status="fail"><failure message="Failed"/><system-out>two is not three</system-out></testcase>
<testcase name="d" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/><system-out>d ... skipped 'no moon'</system-out></testcase>
<testcase name="e" status="notrun"><skipped message="Unable to find executable"/><system-out/></testcase>
</testsuite>"""


class Counting(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory(prefix="counting with blank ")))
        (self.folder / "scripts").symlink_to(SOURCE / "scripts")
        ctest = self.folder / "programs/ctest"
        ctest.parent.mkdir()
        ctest.write_text(CTEST)
        ctest.chmod(0o755)
        self.env = {**os.environ, "PATH": f"{ctest.parent}:{os.environ['PATH']}", "JUNIT": JUNIT}

    def start(self, body):
        script = self.folder / "run.sh"
        script.write_text(f"set -uo pipefail\nsource scripts/counting.sh\n{body}\n")
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
        return subprocess.Popen(["bash", script], cwd=self.folder, text=True, env=self.env, **pipes)

    def run_script(self, body):
        process = self.start(body)
        out, _ = process.communicate(timeout=60)
        return process.returncode, out

    def last_line(self, out):
        return out.splitlines()[-1]

    def test_all_passed(self):
        status, out = self.run_script("step one true; step two true; finished=1")
        self.assertEqual((status, self.last_line(out)), (0, "2 passed, 0 failed"))

    def test_a_failed_step_shows_its_output(self):
        status, out = self.run_script("step one sh -c 'echo it broke; exit 4'; step two true; finished=1")
        self.assertEqual((status, self.last_line(out)), (1, "1 passed, 1 failed"))
        self.assertIn("it broke", out)

    def test_cases_are_counted_one_by_one(self):
        status, out = self.run_script("cases unit nowhere; finished=1")
        self.assertEqual((status, self.last_line(out)), (1, "2 passed, 2 failed, 1 skipped"))
        self.assertIn("two is not three", out)
        self.assertIn("skipped: d: no moon", out)

    def test_no_cases_at_all_is_a_failure(self):
        self.env["JUNIT"] = "<testsuite/>"
        self.assertEqual(self.run_script("cases unit nowhere; finished=1")[0], 1)

    def test_an_early_end_is_a_failure(self):
        status, out = self.run_script("step one true; exit 0")
        self.assertEqual((status, self.last_line(out)), (1, "1 passed, 1 failed"))

    def test_a_signal_ends_it_at_once_with_the_count(self):
        process = self.start("step one true; step two sleep 300; finished=1")
        self.assertIn("ok    one", process.stdout.readline())
        began = time.monotonic()
        process.send_signal(signal.SIGTERM)
        out, _ = process.communicate(timeout=100)
        self.assertLess(time.monotonic() - began, 100)
        self.assertEqual((process.returncode, self.last_line(out)), (1, "1 passed, 1 failed"))
