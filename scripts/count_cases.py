#!/usr/bin/env python3
"""Reads CTest's JUnit file.

usage: count_cases.py FILE             prints "PASSED FAILED SKIPPED"
       count_cases.py --explain FILE   prints the name of each case that failed, with the end of its output, or was skipped, with why
"""

import re
import sys
import xml.etree.ElementTree as ET

# A case that left itself out; a test program that is missing is "notrun" as well, and that is a failure.
LEFT_OUT = re.compile(r"SKIP_RETURN_CODE|SKIP_REGULAR_EXPRESSION|Disabled", re.IGNORECASE)


def verdict(case):
    if case.get("status") == "run":
        return "passed"
    skipped = case.find("skipped")
    if case.get("status") == "disabled" or (skipped is not None and LEFT_OUT.search(skipped.get("message", ""))):
        return "skipped"
    return "failed"


def reason(output):
    """Why a case left itself out, from what it printed (unittest's or GoogleTest's way of saying it)."""
    found = re.search(r"skipped ['\"](.*)['\"]", output) or re.search(r"Skipped\n(.+)", output)
    return found.group(1).strip() if found else "it gave no reason"


def main(arguments):
    explain = arguments[:1] == ["--explain"]
    cases = list(ET.parse(arguments[-1]).getroot().iter("testcase"))
    counts = dict.fromkeys(("passed", "failed", "skipped"), 0)
    for case in cases:
        kind = verdict(case)
        counts[kind] += 1
        output = case.findtext("system-out") or ""
        if explain and kind == "failed":
            print(f"  failed: {case.get('name')}")
            print("".join(f"  | {line}\n" for line in output.splitlines()[-40:]), end="")
        elif explain and kind == "skipped":
            print(f"  skipped: {case.get('name')}: {reason(output)}")
    if not explain:
        print(*counts.values())
    return 0 if cases else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
