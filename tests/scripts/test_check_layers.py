"""The layer check finds what points up or sideways and types that share a name, and nothing else."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts/check_layers.py"


class CheckLayers(unittest.TestCase):
    def check(self, **files):
        """The status and output for a source folder with the given files: folder__name=text."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = Path(folder, name.replace("__", "/") + ".cc")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            done = subprocess.run([sys.executable, SCRIPT, folder], text=True, capture_output=True, check=False)
        return done.returncode, done.stdout

    def test_down_is_allowed(self):
        text = '#include "layoutbox/base/result.h"\n#include <vector>\n#include "layoutbox/embedded/schema.h"\n'
        self.assertEqual(self.check(scene__a=text, cli__b='#include "layoutbox/scene/a.h"\n')[0], 0)

    def test_own_folder_is_allowed(self):
        self.assertEqual(self.check(solve__a='#include "layoutbox/solve/cp_sat/wire.h"\n')[0], 0)

    def test_up_is_a_fault_with_its_place(self):
        status, out = self.check(base__a='// top\n#include "layoutbox/scene/layout.h"\n')
        self.assertEqual(status, 1)
        self.assertIn("base/a.cc:2: includes layoutbox/scene/layout.h: scene/ is above base/", out)

    def test_sibling_is_a_fault(self):
        status, out = self.check(render__a="#  include <layoutbox/export/export.h>\n")
        self.assertEqual(status, 1)
        self.assertIn("export/ is on the same floor as render/", out)

    def test_verifier_shares_no_code_with_the_solver(self):
        status, out = self.check(verify__a='#include "layoutbox/solve/geometry.h"\n')
        self.assertEqual(status, 1)
        self.assertIn("must share no code", out)

    def test_the_planner_by_model_is_behind_its_interface(self):
        text = '#include "layoutbox/plan/llm/conversation.h"\n'
        self.assertIn("use its interface in plan/", self.check(pipeline__a=text)[1])
        self.assertEqual(self.check(cli__a=text, experiment__b=text, plan__c=text)[0], 0)

    def test_subfolders_are_looked_at(self):
        self.assertEqual(self.check(solve__cp_sat__a='#include "layoutbox/render/render.h"\n')[0], 1)

    def test_folders_inside_have_floors_too(self):
        status, out = self.check(plan__words__a='#include "layoutbox/plan/phrases/chunks.h"\n')
        self.assertEqual(status, 1)
        self.assertIn("plan/phrases/ is above plan/words/", out)
        self.assertIn("on the same floor", self.check(plan__edit__a='#include "layoutbox/plan/llm/conversation.h"\n')[1])
        down = '#include "layoutbox/plan/words/tokens.h"\n#include "layoutbox/plan/planner.h"\n'
        self.assertEqual(self.check(plan__phrases__a=down, plan__offline__b='#include "layoutbox/plan/phrases/a.h"\n')[0], 0)

    def test_unknown_folder_is_a_fault(self):
        self.assertEqual(self.check(attic__a="")[0], 1)

    def test_path_not_from_src_is_a_fault(self):
        for path in ("../scene/layout.h", "layout.h", "layoutbox/solve/../render/render.h"):
            self.assertEqual(self.check(solve__a=f'#include "{path}"\n')[0], 1, path)

    def test_two_types_of_one_name(self):
        for one, other in (
            ("struct Way {", "enum class Way : int {"),
            ("class Way final : public Base {", "class Way {"),
            ("struct Way {", "using Way = std::vector<int>;"),
            ("template <typename T>\nstruct Way {", "struct [[nodiscard]] Way {"),
        ):
            status, out = self.check(base__a=one, cli__b=f"// first line\n{other}")
            self.assertEqual(status, 1, other)
            self.assertRegex(out, r"type Way is also at .*/(base/a|cli/b)\.cc:[12]", other)

    def test_what_is_no_second_type(self):
        for other in (
            "struct Way;",  # a forward declaration
            "struct Road {\n  struct Way {\n  };\n};",  # Road::Way
            "using Way = edit::Way;",
            "// struct Way {\n",
            "struct Ways {",
        ):
            self.assertEqual(self.check(base__a="struct Way {", cli__b=other)[0], 0, other)
        self.assertEqual(self.check(base__a="using Json = nlohmann::json;", cli__b="using Json = nlohmann::ordered_json;")[0], 0)

    def test_this_repository(self):
        done = subprocess.run([sys.executable, SCRIPT], text=True, capture_output=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
