"""Reads the help that the program prints."""

import re
import subprocess

DESCRIPTION_AT = 30  # column at which descriptions begin


def help_of(program, *command):
    return subprocess.run([program, *command, "--help"], check=True, capture_output=True, text=True).stdout


def entries(lines):
    """(term, description) of lines such as `  --flag N    words`; further lines of a description are indented more.

    A term that is too long for its column stands on a line of its own.
    """
    found = []
    for line in lines:
        if re.match(r"  \S", line):
            is_short = line[DESCRIPTION_AT - 1 : DESCRIPTION_AT] in ("", " ")
            term, description = (line[:DESCRIPTION_AT], line[DESCRIPTION_AT:]) if is_short else (line, "")
            found.append([term.strip(), description.strip()])
        elif found and line.strip():
            found[-1][1] = f"{found[-1][1]} {line.strip()}".strip()
    return found


def parts_of(text):
    """Summary, usage, [(heading, lines)], closing lines of a help text."""
    lines = text.strip("\n").split("\n")
    usage_at = next(i for i, line in enumerate(lines) if line.startswith("Usage:"))
    summary = " ".join(line.strip() for line in lines[:usage_at]).strip()
    usage = lines[usage_at][len("Usage:") :].strip()
    sections, closing = [], []
    for line in lines[usage_at + 1 :]:
        if re.match(r"^[A-Z][A-Za-z ]*:$", line):
            sections.append((line[:-1], []))
        elif line.startswith("  ") and sections and not closing:
            sections[-1][1].append(line)
        elif line.strip():
            closing.append(line.strip())
    return summary, usage, sections, closing


def commands_of(program):
    return [term for term, _ in entries(dict(parts_of(help_of(program))[2])["Subcommands"])]
