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
    """Summary, usage, [(heading, lines)], closing lines of a help text; examples before the usage are among the latter."""
    lines = text.strip("\n").split("\n")
    usage_at = next(i for i, line in enumerate(lines) if line.startswith("Usage:"))
    summary_ends = lines[:usage_at].index("") if "" in lines[:usage_at] else usage_at
    summary = " ".join(line.strip() for line in lines[:summary_ends]).strip()
    usage = lines[usage_at][len("Usage:") :].strip()
    sections, closing = [], []
    examples = [line.strip() for line in lines[summary_ends:usage_at] if line.strip()]
    for line in lines[usage_at + 1 :]:
        if re.match(r"^[A-Z][A-Za-z ]*:$", line):
            sections.append((line[:-1], []))
        elif line.startswith("  ") and sections and not closing:
            sections[-1][1].append(line)
        elif line.strip():
            closing.append(line.strip())
    return summary, usage, sections, examples + closing


def commands_of(program):
    """Of all groups."""
    groups = [lines for heading, lines in parts_of(help_of(program))[2] if heading != "Options"]
    return [term for lines in groups for term, _ in entries(lines)]
