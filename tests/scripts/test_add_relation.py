"""What scripts/add_relation.py writes, on a copy of the files that it changes."""

import contextlib
import io
import json
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import add_relation  # noqa: E402

FILES = (
    "src/layoutbox/scene/relation_list.inc",
    "src/layoutbox/scene/relation_traits.cc",
    "schema/scene.schema.json",
    "catalog/relation_phrases.json",
    "docs/relations.md",
)
FOLDERS = ("src/layoutbox/solve/compile", "src/layoutbox/verify/relations", "tests/relations")
NEW = ("inShadowOf", "--sentence", "{targets} stands in the shadow of {references}", "--parameters", "max=0.6", "--say", "in shadow of")


class AddRelation(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name in FILES:
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, self.root / name)
        for name in FOLDERS:
            shutil.copytree(ROOT / name, self.root / name)

    def add(self, *arguments):
        """Its exit status, and what it said."""
        said = io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            try:
                status = add_relation.main(["--root", str(self.root), *arguments])
            except SystemExit as end:
                status = end.code
        return status, said.getvalue()

    def read(self, name):
        return (self.root / name).read_text("utf-8")

    def table(self):
        return re.findall(r'^LAYOUTBOX_RELATION\(\w+, "(\w+)"', self.read(FILES[0]), re.MULTILINE)

    def test_all_lists_have_it_at_the_same_place(self):
        for like in self.table():  # behind each relation there is, whatever its rows look like
            name = f"likeOf{like}"
            status, said = self.add(name, "--like", like, "--sentence", "{targets} stands so")
            self.assertEqual(status, 0, said)
        table = self.table()
        self.assertEqual(table[1::2], [f"likeOf{like}" for like in table[::2]])
        enum = json.loads(self.read(FILES[2]))["definitions"]["relationType"]["enum"]
        self.assertEqual(enum, table)
        traits = re.findall(r"\{\.type = R::k(\w+)", self.read(FILES[1]))
        self.assertEqual([name[0].lower() + name[1:] for name in traits], table)
        self.assertEqual(re.findall(r"^\| `(\w+)` \|", self.read(FILES[4]), re.MULTILINE), table)

    def test_what_only_a_person_knows_is_named_and_stops_the_build(self):
        status, said = self.add(*NEW, "--like", "alongSide")
        self.assertEqual(status, 0, said)
        for word in ("solve/compile/pair.cc", "verify/relations/pair.cc", "pair_limits.cc", "pair_examples.cc", "docs/relations.md"):
            self.assertIn(word, said)
        self.assertEqual(json.loads(self.read(FILES[3]))["relations"]["inShadowOf"], {"phrases": ["in shadow of"]})
        for name in ("src/layoutbox/solve/compile/pair.cc", "src/layoutbox/verify/relations/pair.cc"):
            self.assertIn("#error", self.read(name))
        self.assertIn("| `inShadowOf` | max=0.6 |  |", self.read(FILES[4]))

    def test_the_pages_own_example_compiles(self):
        page = (ROOT / "docs/add-a-relation.md").read_text("utf-8")
        command = re.search(r"add_relation\.py (backToBack .*?)\n *```", page, re.DOTALL)[1].replace("\\\n", " ")
        self.assertEqual(self.add(*shlex.split(command))[0], 0)
        for head, folder in (("void compile_BackToBack", FOLDERS[0]), ("Finding check_BackToBack", FOLDERS[1])):
            body = re.search(rf"```cpp\n( *{head}.*?)\n *```", page, re.DOTALL)[1]
            (file,) = [one for one in (self.root / folder).glob("*.cc") if head in one.read_text("utf-8")]
            text = re.sub(rf"{head}\([^\n]*\n#error[^\n]*\n\}}", body.replace("\\", r"\\"), file.read_text("utf-8"))
            self.assertNotIn("#error", text)
            file.write_text(text, "utf-8")
            compiler = ["c++", "-std=c++20", "-fsyntax-only", "-DFMT_SHARED", f"-I{self.root}/src", f"-I{ROOT}/src", file]
            done = subprocess.run(compiler, text=True, capture_output=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_what_cannot_be_writes_nothing(self):
        before = {name: self.read(name) for name in FILES}
        for arguments in ((*NEW, "--like", "noSuch"), ("near", *NEW[1:], "--like", "alongSide"), ("Bad-name", *NEW[1:], "--like", "near")):
            status, said = self.add(*arguments)
            self.assertNotEqual(status, 0, arguments)
            self.assertTrue(said)
        self.assertEqual(before, {name: self.read(name) for name in FILES})


if __name__ == "__main__":
    unittest.main()
