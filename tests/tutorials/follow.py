"""Follows a tutorial: runs its blocks in their order, in an empty folder, and compares what they print.

usage: follow.py TUTORIAL

Fenced blocks of a tutorial:
  ```sh       commands; all of them must succeed
  ```sh fails commands, the last of which must fail
  ```text     what the block before printed; `...` stands for anything but rows of a table of response modes
  ```json NAME, ```python NAME, ```cpp NAME, ```cmake NAME: written to the file NAME; `NAME` is the second word
Other blocks are read by people only.

A tutorial whose runs leave more than one in twenty realisations of a condition unresolved says what to do: it has the
word `unresolved` in its text.
"""

import itertools
import json
import os
import re
import subprocess
import sys


def blocks(text):
    for match in re.finditer(r"^```(\w+)[ ]?([^\n]*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        yield match.group(1), match.group(2).strip(), match.group(3), text.count("\n", 0, match.start()) + 1


def matches(expected, printed):
    """Line by line; `...` alone stands for any lines, within a line for any characters."""
    def squeezed(text):
        return "\n".join(line.rstrip() for line in text.strip().splitlines())

    pattern = re.escape(squeezed(expected)).replace(re.escape("..."), ".*?")
    return re.fullmatch(pattern, squeezed(printed), re.DOTALL) is not None


def response_table(lines):
    """The first table with a column `n`, as `rocking run` prints it."""
    heading = next((i for i, line in enumerate(lines) if "n" in line.split()), len(lines))
    return list(itertools.takewhile(lambda line: line.strip(), lines[heading:]))


def hidden_rows(expected, printed):
    """Lines of that table that a text which shows its heading does not show as they were printed."""
    shown, table = ([line.rstrip() for line in text.splitlines()] for text in (expected, printed))
    table = response_table(table)
    is_shown = table and any(line.split()[:1] == table[0].split()[:1] for line in shown)
    return [line for line in table if line not in shown] if is_shown else []


def unresolved_conditions(folder):
    """`REPORT: share` of the conditions of all runs of which many realisations are unresolved."""
    for place, _, names in os.walk(folder):
        if "report.json" not in names:
            continue
        with open(os.path.join(place, "report.json"), encoding="utf-8") as file:
            for condition in json.load(file)["result"]["conditions"]:
                share = condition["counts"].get("unresolved", 0) / condition["realisations"]
                if share > 0.05:
                    yield f"{place}: {100 * share:.0f} % at {condition['parameters']}"


def follow(path):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    printed, commands = "", 0
    for language, note, body, line in blocks(text):
        place = f"{path}:{line}"
        if language == "sh":
            done = subprocess.run(["bash", "-eo", "pipefail", "-c", body], stdout=subprocess.PIPE, text=True)
            printed, commands = done.stdout, commands + 1
            if (done.returncode != 0) != (note == "fails"):
                sys.exit(f"{place}: exit code {done.returncode}\n{printed}")
        elif language == "text" and commands:
            if not matches(body, printed):
                sys.exit(f"{place}: printed something else:\n{printed}")
            if hidden := hidden_rows(body, printed):
                sys.exit(f"{place}: does not show the whole table:\n" + "\n".join(hidden))
        elif note:
            folder = os.path.dirname(note)
            if folder:
                os.makedirs(folder, exist_ok=True)
            with open(note, "w", encoding="utf-8") as file:
                file.write(body)
    prose = re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)
    if "unresolved" not in prose and (unresolved := list(unresolved_conditions("."))):
        sys.exit(f"{path}: does not say what to do about unresolved realisations:\n" + "\n".join(unresolved))
    if commands == 0:
        sys.exit(f"{path}: has no commands")
    print(f"{path}: {commands} blocks of commands")


if __name__ == "__main__":
    follow(sys.argv[1])
