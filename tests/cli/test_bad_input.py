"""Every wrong input of the table ends in a clear error with the right status, and leaves nothing behind."""

from bad_input_cases import CASES, FILES
from harness import CliTestCase


class BadInput(CliTestCase):
    one_process = True  # a hundred runs of a few milliseconds each

    def test_table(self):
        self.assertEqual(len({title for title, *_ in CASES}), len(CASES), "two cases have one name")
        for name, content in FILES.items():
            self.path(name).write_bytes(content if isinstance(content, bytes) else content.encode())
        for number, (title, arguments, status, words) in enumerate(CASES):
            with self.subTest(title):
                self.check(self.path(f"out{number}"), arguments, status, words)

    def check(self, out, arguments, status, words):
        run = self.run_layoutbox(*(argument.format(dir=self.folder, out=out) for argument in arguments), timeout=60)
        self.assert_status(run, status)
        said = run.err.lower()
        self.assertTrue(said.strip(), "no error in words")
        for word in words:
            self.assertIn(word.format(dir=self.folder).lower(), said)
        self.assertNotIn("terminate called", said)
        self.assertEqual(run.out, "", "an error belongs on stderr")
        self.assertFalse(out.exists() and any(out.iterdir()), "files were left behind")
