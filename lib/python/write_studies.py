"""Writes rocking/studies.py: a function for each study, of the list that `rocking schema studies` prints.

usage: write_studies.py OUTPUT STUDIES
"""

import json
import os
import re
import sys
import textwrap

HEAD = '''"""Studies. Made of the fields of their questions, by lib/python/write_studies.py."""

from __future__ import annotations

import os
from typing import Optional, Sequence, Tuple, Union

from . import documents
from .asking import Path, Source, answer, ends, numbers, paths, words
from .experiments import ExperimentLike
from .running import Progress

'''

SIMPLE = {"string": "str", "number": "float", "integer": "int", "boolean": "bool"}

# By the subject of a study: its parameters, their part of the docstring, and the arguments of asking.answer().
SUBJECTS = {
    "none": ("", "", ""),
    "files": ("", "", ""),
    "experiment": ("source: ExperimentLike", "source: an experiment.", "source=source"),
    "runs": (
        "source: Source",
        "source: a Result, the folder of a complete run, or an experiment, which is run first.",
        "runs=(source,)",
    ),
    "two_runs": (
        "first: Source, second: Source",
        "first, second: a Result, or the folder of a run.",
        "runs=(first, second)",
    ),
}


class Parameter:
    """A parameter of a function: one keyword, or both ends of a range, such as `branch_range[0]`."""

    def __init__(self, keywords):
        first = keywords[0]
        self.name = first["keyword"].split("[")[0]
        self.is_range = len(keywords) > 1
        self.sentence = "; ".join(each["sentence"][:1].lower() + each["sentence"][1:] for each in keywords)
        self.is_required = first["is_required"] or self.name in ("files",)
        schema = first["schema"].get("anyOf", [first["schema"]])[0]
        types = schema.get("type", "string")
        types = [types] if isinstance(types, str) else types
        self.is_list = types[0] == "array"
        self.is_path = first["is_path"]
        kind = schema["items"].get("type", "string") if self.is_list else types[0]
        self.type, self.default, self.value = self.described(SIMPLE[kind], first["default"])

    def described(self, simple, default):
        """Annotation, default and the value of the question."""
        if self.is_range:
            return "Tuple[Optional[float], Optional[float]]", "(None, None)", f"ends(\"{self.name}\", {self.name})"
        if self.is_list and simple == "str":
            single = "Path" if self.is_path else "str"
            convert = "paths" if self.is_path else "words"
            return f"Union[{single}, Sequence[{single}]]", "()", f"{convert}({self.name})"
        if self.is_list and default is None:
            convert = f"None if {self.name} is None else [{simple}(each) for each in {self.name}]"
            return f"Optional[Sequence[{simple}]]", "None", convert
        if self.is_list:
            values = tuple(default) if default else ()
            return f"Union[{simple}, Sequence[{simple}]]", repr(values), f"numbers({simple}, {self.name})"
        if self.is_path:
            annotation = "Path" if self.is_required else "Optional[Path]"
            return annotation, "None", f"None if {self.name} is None else os.fspath({self.name})"
        if self.name == "seed":
            return "Union[int, str]", default, f"str({self.name})"
        optional = default is None
        return (f"Optional[{simple}]" if optional else simple), repr(default), self.name

    def source(self):
        return f"{self.name}: {self.type}" + ("" if self.is_required else f" = {self.default}")


def parameters_of(study):
    groups = {}
    for keyword in study["keywords"]:
        groups.setdefault(keyword["keyword"].split("[")[0], []).append(keyword)
    return [Parameter(group) for group in groups.values()]


def sentences(parameters, study, of_subject):
    parts = [of_subject] if of_subject else []
    parts += [f"{each.name}: {each.sentence}." for each in parameters]
    if study["has_progress"]:
        parts.append("threads: one for each processor, unless given; they change the time, never the result.")
        parts.append("progress: called with what is done and all, once that is known.")
    parts.append(study["notes"])
    parts = [re.sub(r"(?<![\w-])--(\w[\w-]*)", lambda flag: flag.group(1).replace("-", "_"), part) for part in parts]
    text = re.sub(r"`([^`]+)`", r"``\1``", " ".join(part for part in parts if part).replace("``", "`"))
    return textwrap.wrap(text.replace("\\", "\\\\"), 112, break_long_words=False)


def function(study):
    own, of_subject, about = SUBJECTS[study["subject"]]
    parameters = parameters_of(study)
    required = [each for each in parameters if each.is_required]
    optional = [each for each in parameters if not each.is_required]
    if study["name"] == "check_normal":  # how many may stand first
        required, optional = optional[:1], optional[1:]
    arguments = [own] if own else []
    arguments += [each.source() for each in required]
    optional_sources = [each.source() for each in optional]
    if study["has_progress"]:
        optional_sources += ["threads: Optional[int] = None", "progress: Optional[Progress] = None"]
    if optional_sources:
        arguments += ["*", *optional_sources]
    values = [f"**{each.value}" if each.is_range else f"\"{each.name}\": {each.value}" for each in parameters]
    call = [json.dumps(study["name"]), "{" + ", ".join(values) + "}"]
    if about:
        call.append(about)
    if study["has_progress"]:
        call += ["threads=threads", "progress=progress"]
    lines = [f"def {study['name']}("] + [f"    {each}," for each in arguments]
    lines += [f") -> documents.{study['document']}:", f'    """{study["sentence"]}.', ""]
    lines += [f"    {line}" for line in sentences(parameters, study, of_subject)]
    lines += [""] + [f"    {line}".rstrip() for line in study["example"].replace("\\", "\\\\").split("\n")] + ['    """']
    lines += [f"    return documents.{study['document']}(", "        answer("]
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
