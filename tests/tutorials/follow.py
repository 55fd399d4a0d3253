"""Follows a tutorial: runs its blocks in their order, in an empty folder, and compares what they print.

usage: follow.py TUTORIAL [--store]

`--store` writes what the blocks print into the tutorial instead. Fenced blocks of a tutorial:
  ```sh       commands; all of them must succeed
  ```sh fails commands, the last of which must fail
  ```text     all that the block before printed, each row, name and number: nothing is left out; of a number with
              more than 13 decimals 12 digits are compared, since the last ones depend on the C library
  ```json NAME, ```python NAME, ```cpp NAME, ```cmake NAME: written to the file NAME; `NAME` is the second word
Other blocks are read by people only.

A tutorial whose runs leave more than one in twenty realisations of a condition unresolved says what to do: it has the
word `unresolved` in its text.
"""

import difflib
import json
import os
import re
import subprocess
import sys


def blocks(text):
    for match in re.finditer(r"^```(\w+)[ ]?([^\n]*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        yield match.group(1), match.group(2).strip(), match.group(3), text.count("\n", 0, match.start()) + 1


def squeezed(text):
    return "\n".join(line.rstrip() for line in text.strip("\n").splitlines())


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


def compared(text):
    return re.sub(r"\d+\.\d{14,}", lambda number: f"{float(number[0]):.12g}", squeezed(text))


def difference(shown, printed):
    lines = difflib.unified_diff(compared(shown).splitlines(), compared(printed).splitlines(), "shown", "printed", "", "")
    return "\n".join(line.rstrip("\n") for line in lines)


def follow(path, store):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    printed, commands, stored = "", 0, text
    for language, note, body, line in blocks(text):
        place = f"{path}:{line}"
        if language == "sh":
            done = subprocess.run(["bash", "-eo", "pipefail", "-c", body], stdout=subprocess.PIPE, text=True)
            printed, commands = done.stdout, commands + 1
            if (done.returncode != 0) != (note == "fails"):
                sys.exit(f"{place}: exit code {done.returncode}\n{printed}")
        elif language == "text" and commands:
            if store:
                stored = stored.replace(f"```text\n{body}```", f"```text\n{squeezed(printed)}\n```", 1)
            elif compared(body) != compared(printed):
                sys.exit(f"{place}: printed something else:\n{difference(body, printed)}")
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
    if store:
        with open(path, "w", encoding="utf-8") as file:
            file.write(stored)
    print(f"{path}: {commands} blocks of commands")


if __name__ == "__main__":
    follow(sys.argv[1], "--store" in sys.argv[2:])
