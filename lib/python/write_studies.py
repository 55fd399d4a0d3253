"""Writes rocking/studies.py: a function for each study, of the list that `rocking schema studies` prints.

usage: write_studies.py OUTPUT STUDIES
"""

import json
import keyword
import os
import re
import sys
import textwrap

HEAD = '''"""Studies. Made of the fields of their questions, by lib/python/write_studies.py."""

from __future__ import annotations

import os
from typing import Optional, Sequence, Union

from . import documents
from .asking import Source, answer, items, items_if_given, one, seed_text, several
from .experiments import ExperimentLike
from .running import Progress
from .tables import Given, Path, file as file_of, files as files_of

'''

SIMPLE = {"string": "str", "number": "float", "integer": "int", "boolean": "bool"}

# By the subject of a study: its parameters, their part of the docstring, and the arguments of asking.answer().
SUBJECTS = {
    "none": ("", "", ""),
    "files": ("", "", ""),
    "experiment": ("source: ExperimentLike", "source: an experiment.", "source=source"),
    "runs": (
        "source: Union[Source, Sequence[Source]]",
        "source: a Result, the folder of a complete run, or an experiment, which is run first; several in a list.",
        "runs=several(source)",
    ),
    "two_runs": (
        "first: Source, second: Source",
        "first, second: a Result, or the folder of a run.",
        "runs=(first, second)",
    ),
}


def in_a_sentence(words):
    """Without a capital letter at the start, but of a name such as JSON."""
    return words if words[:2].isupper() else words[:1].lower() + words[1:]


class Parameter:
    """A parameter of a function, for one keyword. Python keeps some words for itself: `from` is `from_`."""

    def __init__(self, asked, study):
        self.keyword = asked["keyword"]
        self.name = self.keyword + ("_" if keyword.iskeyword(self.keyword) else "")
        self.sentence = re.sub(r", e\.g\. \w+", " [s]", in_a_sentence(asked["sentence"]))
        self.is_required = asked["is_required"] or self.name in ("files",)
        schema = asked["schema"].get("anyOf", [asked["schema"]])[0]
        types = schema.get("type", "string")
        types = [types] if isinstance(types, str) else types
        self.is_list = types[0] == "array"
        self.is_path = asked["is_path"]
        self.may_be_table = self.is_path and not asked["is_written"] and study["subject"] in ("experiment", "runs")
        kind = schema["items"].get("type", "string") if self.is_list else types[0]
        self.type, self.default, self.reading = self.described(SIMPLE[kind], asked["default"])

    def described(self, simple, default):
        """Annotation, default and what reads the argument."""
        if self.may_be_table and self.is_list:
            return "Union[None, Given, Sequence[Given]]", "None", "files_of"
        if self.may_be_table:
            return ("Given" if self.is_required else "Optional[Given]"), "None", "file_of"
        if self.is_list and simple == "str":
            single = "Path" if self.is_path else "str"
            return f"Union[{single}, Sequence[{single}]]", "()", "items"
        if self.is_list and default is None:
            return f"Optional[Sequence[{simple}]]", "None", "items_if_given"
        if self.is_list:
            values = tuple(default) if default else ()
            return f"Union[{simple}, Sequence[{simple}]]", repr(values), "items"
        if self.is_path:
            return ("Path" if self.is_required else "Optional[Path]"), "None", "one"
        if self.name == "seed":
            return "Union[int, str]", default, "seed_text"
        optional = default is None
        return (f"Optional[{simple}]" if optional else simple), repr(default), "one"

    def source(self):
        return f"{self.name}: {self.type}" + ("" if self.is_required else f" = {self.default}")


# What several studies take, by the flags of the same names.
REPLACING = {"seed": "seed: Union[int, str, None] = None", "realisations": "realisations: Optional[int] = None",
             "resume": "resume: Optional[Given] = None"}


def replacing(study):
    """Those of a study, with what they say."""
    found = {}
    if study["takes_seed"]:
        found["seed"] = "instead of that of the experiment"
    if study["realisations"]:
        found["realisations"] = in_a_sentence(study["realisations"]).replace("file", "experiment")
    if study["kept"]:
        found["resume"] = f"go on from the {study['kept']} of an earlier answer, or of its file"
    return found


def sentences(parameters, study, of_subject):
    parts = [of_subject] if of_subject else []
    parts += [f"{each.name}: {each.sentence}." for each in parameters]
    parts += [f"{name}: {sentence}." for name, sentence in replacing(study).items()]
    if any(each.may_be_table for each in parameters):
        parts.append("In place of a file stand its columns by name, rows, a structured array, a table of pandas, or what "
                     "a function of this module has returned.")
    if study["has_progress"]:
        parts.append("threads: one for each processor, unless given; they change the time, never the result.")
        parts.append("progress: called with what is done and all, once that is known.")
    parts.append(study["notes"])
    parts = [re.sub(r"(?<![\w-])--(\w[\w-]*)", lambda flag: flag.group(1).replace("-", "_"), part) for part in parts]
    text = re.sub(r"`([^`]+)`", r"``\1``", " ".join(part for part in parts if part).replace("``", "`"))
    return textwrap.wrap(text.replace("\\", "\\\\"), 112, break_long_words=False)


def function(study):
    own, of_subject, about = SUBJECTS[study["subject"]]
    parameters = [Parameter(asked, study) for asked in study["keywords"]]
    required = [each for each in parameters if each.is_required]
    optional = [each for each in parameters if not each.is_required]
    if study["name"] == "check_normal":  # how many may stand first
        required, optional = optional[:1], optional[1:]
    arguments = [own] if own else []
    arguments += [each.source() for each in required]
    optional_sources = [each.source() for each in optional] + [REPLACING[name] for name in replacing(study)]
    if study["has_progress"]:
        optional_sources += ["threads: Optional[int] = None", "progress: Optional[Progress] = None"]
    if optional_sources:
        arguments += ["*", *optional_sources]
    values = [f"\"{each.keyword}\": ({each.reading}, {each.name})" for each in parameters]
    call = [json.dumps(study["name"]), "{" + ", ".join(values) + "}"]
    if about:
        call.append(about)
    call += [f"{name}={name}" for name in replacing(study)]
    if study["has_progress"]:
        call += ["threads=threads", "progress=progress"]
    lines = [f"def {study['name']}("] + [f"    {each}," for each in arguments]
    lines += [f") -> documents.{study['document']}:", f'    """{study["sentence"]}.', ""]
    lines += [f"    {line}" for line in sentences(parameters, study, of_subject)]
    lines += [""] + [f"    {line}".rstrip() for line in study["example"].replace("\\", "\\\\").split("\n")] + ['    """']
    lines += [f"    return documents.{study['document']}(", "        *answer("]
    lines += [f"            {each}," for each in call] + ["        )", "    )"]
    return "\n".join(lines)


def main(output, studies):
    with open(studies, encoding="utf-8") as file:
        found = json.load(file)
    names = sorted(study["name"] for study in found)
    text = HEAD + "__all__ = [\n" + "".join(f'    "{name}",\n' for name in names) + "]\n"
    for study in found:
        text += "\n\n" + function(study) + "\n"
    if os.path.islink(output):  # of a build before the functions were made here
        os.remove(output)
    with open(output, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
