"""Writes rocking/documents.py: a class for each object in the documents, of the schemas that `rocking schema` prints.

usage: write_documents.py OUTPUT SCHEMA...
"""

import json
import sys
import textwrap

HEAD = '''"""Classes of what stands in documents. Made of the lists of fields, by lib/python/write_documents.py."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .fields import Document, Fields, Rows, by_name, complex_numbers, either, numbers, rows_of, same, whole_numbers

if TYPE_CHECKING:
    from typing import Any, Dict, List, Literal, Optional, Tuple, Union

    import numpy as np
    import numpy.typing as npt
'''

SIMPLE = {"string": "str", "number": "float", "integer": "int", "boolean": "bool"}


class Classes:
    """The classes in the order in which they can be defined: of what stands in an object before the object's."""

    def __init__(self):
        self.sources = {}
        self.schemas = {}

    def add(self, schema, base="Fields"):
        """The name of an object's class."""
        name = schema["title"]
        keys = schema["properties"]
        members = {key: self.member(value, key in schema.get("required", [])) for key, value in keys.items()}
        if name in self.schemas:
            if self.schemas[name] != members:
                raise SystemExit(f"{name}: two lists of fields have this name; rename one")
            return name
        self.schemas[name] = members
        lines = [f"class {name}({base}):"]
        words = [schema["description"] if base == "Document" else f"{name} in documents.", *self.sentences(keys)]
        lines += [f'    """{words[0]}'.rstrip(), *[f"    {line}".rstrip() for line in words[1:]], '    """', ""]
        lines += [f"    {attribute(key)}: {annotation}" for key, (annotation, _) in members.items()]
        lines += ["", "    _keys = {", *[f"        {key!r}: {make}," for key, (_, make) in members.items()], "    }"]
        self.sources[name] = "\n".join(lines)
        return name

    @staticmethod
    def sentences(keys):
        lines = [""]
        for key, schema in keys.items():
            sentence = schema.get("description", "of the document").replace("\\", "\\\\").replace("`", "``")
            lines += textwrap.wrap(f"- ``{attribute(key)}``: {sentence}", 112, subsequent_indent="  ")
        return lines

    def member(self, schema, is_required):
        annotation, make = self.value(schema)
        may_be_none = not is_required and not annotation.startswith("Optional")
        return (f"Optional[{annotation}]" if may_be_none else annotation), make

    def value(self, schema):
        """(type, function that makes it of a JSON value)."""
        alternatives = [each for each in schema.get("anyOf", []) if each.get("type") != "null"]
        types = schema.get("type", [])
        types = [types] if isinstance(types, str) else list(types)
        is_nullable = "null" in types or len(alternatives) < len(schema.get("anyOf", []))
        annotation, make = self.present(schema, alternatives, [each for each in types if each != "null"])
        return (f"Optional[{annotation}]" if is_nullable else annotation), make

    def present(self, schema, alternatives, types):
        if len(alternatives) == 1:
            return self.value(alternatives[0])
        if alternatives:
            return self.one_of(alternatives)
        if "const" in schema or "enum" in schema:
            return f"Literal[{', '.join(map(repr, schema.get('enum', [schema.get('const')])))}]", "same"
        if "properties" in schema:
            name = self.add(schema)
            return name, name
        if types == ["object"]:
            of = schema.get("additionalProperties")
            annotation, make = self.value(of) if isinstance(of, dict) else ("Any", "same")
            return f"Dict[str, {annotation}]", "same" if make == "same" else f"by_name({make})"
        if types == ["array"]:
            return self.list(schema)
        return (SIMPLE[types[0]] if len(types) == 1 else "Any"), "same"

    def one_of(self, alternatives):
        found = [self.value(each) for each in alternatives]
        annotation = f"Union[{', '.join(annotation for annotation, _ in found)}]"
        classes = [make for _, make in found if make != "same"]
        if classes and classes[0].startswith("rows_of("):
            inner = [make[len("rows_of("):-1] for make in classes]
            return f"Rows[Union[{', '.join(inner)}]]", f"rows_of(either({', '.join(inner)}))"
        return annotation, f"either({', '.join(classes)})" if classes else "same"

    def list(self, schema):
        items = schema["items"]
        annotation, make = self.value(items)
        if make != "same" and items.get("type") != "array":
            return f"Rows[{annotation}]", f"rows_of({make})"
        if items.get("title") == "Complex":
            return "npt.NDArray[np.complex128]", "complex_numbers"
        size = schema.get("minItems")
        if size and size == schema.get("maxItems") and items.get("type") != "array":
            return f"Tuple[{', '.join([annotation] * size)}]", "tuple"
        kinds = {"int": ("np.int64", "whole_numbers")}
        if self.is_numeric(items):
            dtype, make = kinds.get(annotation, ("np.float64", "numbers"))
            return f"npt.NDArray[{dtype}]", make
        return f"List[{annotation}]", "same"

    def is_numeric(self, schema):
        if schema.get("type") == "array":
            return self.is_numeric(schema["items"])
        types = schema.get("type", [])
        return bool({"number", "integer"} & set([types] if isinstance(types, str) else types))


def attribute(key):
    return "from_" if key == "from" else key


def main(output, *schemas):
    classes = Classes()
    for path in schemas:
        with open(path, encoding="utf-8") as file:
            classes.add(json.load(file), "Document")
    names = "".join(f'    "{name}",\n' for name in sorted(classes.sources))
    head = f"{HEAD.rstrip()}\n\n__all__ = [\n{names}]\n\n\ndef __dir__() -> List[str]:\n    return __all__\n"
    with open(output, "w", encoding="utf-8") as file:
        file.write("\n\n".join([head, *(source + "\n" for source in classes.sources.values())]))


if __name__ == "__main__":
    main(*sys.argv[1:])
