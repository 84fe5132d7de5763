"""The README is true: its commands run, and print what it shows (times and counts of milliseconds apart)."""

import re
import shlex
import shutil
import subprocess
import unittest

from harness import BINARY, DONE, NOT_AS_ASKED, SOURCE, CliTestCase


def examples():
    """(command, lines shown below it) of every console block of the README that starts the program."""
    text = (SOURCE / "README.md").read_text(encoding="utf-8")
    for block in re.findall(r"```console\n(.*?)```", text, re.DOTALL):
        lines = block.rstrip("\n").split("\n")
        assert lines[0].startswith("$ "), lines[0]
        if lines[0].startswith("$ ./layoutbox "):
            yield shlex.split(lines[0].removeprefix("$ ./layoutbox ")), lines[1:]


def without_times(line):
    return re.sub(r"\s+[\d.]+ (ms|s)\s+", " ", line)


class Readme(CliTestCase):
    def test_has_examples(self):
        self.assertGreaterEqual(len(list(examples())), 4)

    def test_examples(self):
        for arguments, shown in examples():
            with self.subTest(" ".join(arguments)[:60]):
                makes_picture = arguments[0] == "generate" and "--no-render" not in arguments
                here = [str(SOURCE / word) if word.startswith("examples/") else word for word in arguments]
                run = self.run_layoutbox(*here, *(["--no-render"] if makes_picture else []), cwd=self.folder)
                self.assert_status(run, NOT_AS_ASKED if "out/conflict" in arguments else DONE)
                said = [without_times(line) for line in (run.err + run.out).splitlines()]
                for line in shown:
                    if makes_picture and (line.startswith("render ") or "scene.png" in line):
                        continue
                    self.assertIn(without_times(line), said)

    @unittest.skipUnless(shutil.which("cmake") and shutil.which("ninja"), "cmake or ninja is not there")
    def test_install_lines(self):
        lines = ["./scripts/build.sh", "cmake --install build/release --prefix ~/layoutbox"]
        self.assertIn("```console\n" + "".join(f"$ {line}\n" for line in lines) + "```", (SOURCE / "README.md").read_text())
        self.assertIn("```sh\n" + "\n".join(lines) + "\n```", (SOURCE / "docs/library.md").read_text())
        # The first builds all, the second finds there what it copies from the build folder.
        build = BINARY.parents[2]
        built = subprocess.run(["ninja", "-C", build, "-t", "commands", "all"], capture_output=True, text=True, check=True).stdout
        scripts = "".join((build / folder / "cmake_install.cmake").read_text() for folder in (".", "src/layoutbox"))
        installed = re.findall(rf'FILES "{re.escape(str(build))}/([^"]+\.a|[^"]+/layoutbox)"', scripts)
        self.assertIn("src/layoutbox/layoutbox", installed)
        self.assertIn("liblayoutbox.a", installed)
        for file in installed:
            self.assertTrue(re.search(rf"(?m) {re.escape(file)}( |$)", built), f"no command of the build makes {file}")

    def test_links_lead_somewhere(self):
        for page in [SOURCE / "README.md", *(SOURCE / "docs").glob("*.md")]:
            text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)  # a lambda's [&](…) is no link
            for link in re.findall(r"\]\(([^)#]+)", text):
                if "://" not in link:
                    self.assertTrue((page.parent / link).exists(), f"{page.name} links to {link}")
