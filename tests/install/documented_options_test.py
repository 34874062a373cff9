#!/usr/bin/env python3
"""Man page and completion name every command and option that `ease --help` names, and no other option.

    documented_options_test.py PROGRAM MAN_PAGE COMPLETION
"""

import re
import subprocess
import sys
import unittest
from pathlib import Path

PROGRAM, MAN_PAGE, COMPLETION = (sys.argv.pop(1) for _ in range(3))
COMMANDS = ("run", "check", "garment", "pattern")


def options_of(*arguments):
    """Long options in the help of the program or of one of its commands."""
    text = subprocess.run([PROGRAM, *arguments, "--help"], capture_output=True, text=True, check=True).stdout
    return set(re.findall(r"^\s+(?:-\w,\s*)?(--[a-z-]+)", text, re.MULTILINE))


def completions_of(line, word):
    """What bash offers for `word` after `line`."""
    words = " ".join([*line.split(), f"'{word}'"])
    script = (f'source "{COMPLETION}"; compopt() {{ :; }}; COMP_WORDS=({words}); '
              f'COMP_CWORD={len(line.split())}; _ease ease "{word}" "{line.split()[-1]}"; printf "%s\\n" "${{COMPREPLY[@]}}"')
    return set(subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=True).stdout.split())


class Documented(unittest.TestCase):
    def test_man_page_names_the_options_that_exist(self):
        existing = set().union(options_of(), *map(options_of, COMMANDS))
        page = Path(MAN_PAGE).read_text(encoding="utf-8").replace("\\-", "-")
        self.assertEqual(set(re.findall(r"--[a-z]+", page)), existing)
        for command in COMMANDS:
            self.assertIn(f'"{command} " SCENE', page)

    def test_completion_offers_the_commands(self):
        offered = completions_of("ease", "")
        self.assertEqual({word for word in offered if not word.startswith("-")}, set(COMMANDS))

    def test_completion_offers_the_options_of_each_command(self):
        self.assertEqual(completions_of("ease", "--"), options_of())
        for command in COMMANDS:
            self.assertEqual(completions_of(f"ease {command}", "--"), options_of(command), command)


if __name__ == "__main__":
    unittest.main()
