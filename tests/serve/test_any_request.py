"""Requests made up from the OpenAPI document, right ones and wrong ones: no crash, no 500, and answers as the document says."""

import os
import subprocess
import sys
import unittest
from pathlib import Path

from service import ServiceCase

SCHEMATHESIS = Path(sys.executable).parent / "schemathesis"
SECONDS = os.environ.get("LAYOUTBOX_REQUEST_SECONDS", "20")
# That a document with the right outline may still be refused for what it says is no fault: a layout whose walls do not meet, say.
NOT_CHECKED = "positive_data_acceptance"


class AnyRequest(ServiceCase):
    environment = {"LAYOUTBOX_BLENDER": "/no/such/blender"}

    @unittest.skipUnless(SCHEMATHESIS.exists(), "schemathesis is missing: scripts/setup.sh --tests")
    def test_answers_are_as_the_document_says(self):
        address = f"http://127.0.0.1:{self.service.port}/api/openapi.json"
        options = ["--phases", "examples,coverage,fuzzing", "--max-examples", "30", "--max-time", SECONDS, "--request-timeout", "60"]
        more = ["--generation-deterministic", "--exclude-checks", NOT_CHECKED, "--warnings", "off", "--no-color", "--workers", "2"]
        done = subprocess.run([SCHEMATHESIS, "run", address, *options, *more], capture_output=True, text=True, cwd=self.folder, check=False)
        self.assertEqual(done.returncode, 0, done.stdout[-6000:] + done.stderr[-2000:])
        self.assertEqual(self.service.get("/api/health").json()["status"], "ok")
        answers = self.service.get("/metrics").body.decode()
        self.assertNotIn('status="500"', answers)
