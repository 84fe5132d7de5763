"""Dockerfile: the image has every shared library that the program links, by what apt would install into an empty system."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
BINARY = os.environ.get("LAYOUTBOX_BINARY", "layoutbox")


def output(*command: str) -> str:
    return subprocess.run(command, capture_output=True, text=True).stdout


def packages_of_image() -> list[str]:
    """What the last stage installs: the names in the Dockerfile, and the rows of packages.txt that its awk takes."""
    stage = (ROOT / "Dockerfile").read_text().rpartition("FROM ")[2]
    install = re.search(r"--no-install-recommends(.*?)&&", stage, re.DOTALL).group(1)
    taken = set(re.findall(r'\$1 == "(\w+)"', install))
    rows = [line.split() for line in (ROOT / "scripts/packages.txt").read_text().splitlines() if line and not line.startswith("#")]
    named = re.sub(r"\$\(.*\)", "", install).replace("\\", " ").split()
    return named + [row[2] for row in rows if row[0] in taken]


def installed_with(packages: list[str]) -> set[str]:
    with tempfile.NamedTemporaryFile() as nothing:
        told = output("apt-get", "-o", f"Dir::State::status={nothing.name}", "--no-install-recommends", "-s", "install", *packages)
    return {line.split()[1] for line in told.splitlines() if line.startswith("Inst ")}


def package_of(library: str) -> str:
    for path in (os.path.realpath(library), library):
        if found := output("dpkg", "-S", path):
            return found.split(":")[0]
    return ""


class Container(unittest.TestCase):
    def test_the_image_has_what_the_program_links(self):
        program = shutil.which(BINARY)
        if "VERSION_CODENAME=bookworm" not in Path("/etc/os-release").read_text() or not program:
            self.skipTest("this is not the image's system, or there is no program")
        image = installed_with(packages_of_image())
        if "libc6" not in image:
            self.skipTest("apt has no lists of packages")
        linked = [line.split()[2] for line in output("ldd", program).splitlines() if "=> /" in line]
        self.assertTrue(linked)
        self.assertEqual([library for library in linked if package_of(library) not in image], [])


if __name__ == "__main__":
    unittest.main()
