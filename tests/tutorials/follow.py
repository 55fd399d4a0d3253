"""Follows a tutorial: runs its blocks in their order, in an empty folder, and compares what they print.

usage: follow.py TUTORIAL

Fenced blocks of a tutorial:
  ```sh       commands; all of them must succeed
  ```sh fails commands, the last of which must fail
  ```text     what the block before printed; `...` stands for anything
  ```json NAME, ```python NAME, ```cpp NAME, ```cmake NAME: written to the file NAME; `NAME` is the second word
Other blocks are read by people only.
"""

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
        elif note:
            folder = os.path.dirname(note)
            if folder:
                os.makedirs(folder, exist_ok=True)
            with open(note, "w", encoding="utf-8") as file:
                file.write(body)
    if commands == 0:
        sys.exit(f"{path}: has no commands")
    print(f"{path}: {commands} blocks of commands")


if __name__ == "__main__":
    follow(sys.argv[1])
