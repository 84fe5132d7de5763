"""What holds for every run: help, version, wrong usage."""

import json

from harness import DONE, WRONG_INPUT, CliTestCase

COMMANDS = ("generate", "plan", "solve", "render", "export", "verify", "validate", "doctor")


class Help(CliTestCase):
    def test_lists_commands(self):
        run = self.run_layoutbox("--help")
        self.assert_status(run, DONE)
        for command in COMMANDS:
            self.assertIn(command, run.out)

    def test_each_command_has_its_own(self):
        for command in COMMANDS:
            run = self.run_layoutbox(command, "--help")
            self.assert_status(run, DONE)
            self.assertIn(command, run.out)

    def test_version_is_one_line(self):
        run = self.run_layoutbox("--version")
        self.assert_status(run, DONE)
        self.assertRegex(run.out, r"\A\S*\d+\.\d+\.\d+\S*\n\Z")
        self.assertEqual(run.err, "")


class WrongUsage(CliTestCase):
    def test_no_command(self):
        run = self.run_layoutbox()
        self.assert_status(run, WRONG_INPUT)
        self.assertEqual(run.out, "")
        self.assertNotEqual(run.err, "")

    def test_unknown_command(self):
        run = self.run_layoutbox("furbish")
        self.assert_status(run, WRONG_INPUT)
        self.assertIn("furbish", run.err)

    def test_unknown_option_as_json(self):
        run = self.run_layoutbox("plan", "--furbish", "a bed", "--json")
        self.assert_status(run, WRONG_INPUT)
        answer = json.loads(run.out)
        error = answer.get("error", answer)
        self.assertLessEqual({"code", "message"}, error.keys())
