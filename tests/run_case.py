#!/usr/bin/env python3
"""Runs unittest cases one by one for CTest.

usage: run_case.py --list FILE     prints the cases of a file, one a line: Class.test_name
       run_case.py FILE CASE       runs one; exit status 0 passed, 1 failed, 77 skipped

A class that has `one_process = True` (costly to set up) is listed and run as a whole, and counts as one.
"""

import ast
import importlib
import sys
import unittest
from pathlib import Path

SKIPPED = 77


def is_whole(node):
    return any(
        isinstance(part, ast.Assign)
        and any(isinstance(target, ast.Name) and target.id == "one_process" for target in part.targets)
        and isinstance(part.value, ast.Constant)
        and part.value.value is True
        for part in node.body
    )


def cases(path):
    """The names of the cases, read from the text: nothing is imported. A class without test methods is a base class."""
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if not isinstance(node, ast.ClassDef):
            continue
        methods = [part.name for part in node.body if isinstance(part, ast.FunctionDef) and part.name.startswith("test")]
        if methods and is_whole(node):
            yield node.name
        else:
            yield from (f"{node.name}.{method}" for method in methods)


def run(path, case):
    sys.path.insert(0, str(path.parent))
    suite = unittest.defaultTestLoader.loadTestsFromName(case, importlib.import_module(path.stem))
    if suite.countTestCases() == 0:
        print(f"{path}: no case {case}", file=sys.stderr)
        return 1
    result = unittest.TextTestRunner(verbosity=2).run(suite)
    if not result.wasSuccessful() or result.unexpectedSuccesses:
        return 1
    return SKIPPED if len(result.skipped) == result.testsRun else 0


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    if arguments[0] == "--list":
        print("\n".join(cases(Path(arguments[1]))))
        return 0
    return run(Path(arguments[0]).resolve(), arguments[1])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
