"""Objects, lists and documents that studies return. Their classes in rocking.documents follow from the lists of fields."""

from __future__ import annotations

import base64
import html
import json
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, ClassVar, Dict, Iterator, List, Mapping, Tuple, TypeVar

import numpy as np

from . import _core

if TYPE_CHECKING:
    import numpy.typing as npt
    import pandas
    import xarray

__all__ = ["Document", "Fields", "Rows"]

_Row = TypeVar("_Row")
_MOST_ROWS = 60  # of a table in a notebook


_GONE = {  # keys of former states, and what says more
    "simple": "pooled, the law with the scatter between records",
    "leave_one_out": "interval",
    "jackknife": "interval",
    "without": "share, of the rate",
    "text": "json, or table() for what the program prints",
}


def interface(thing: object) -> List[str]:
    """What dir() shows of an object: its interface alone."""
    return [name for name in object.__dir__(thing) if not name.startswith("_")]


class Fields:
    """An object with the keys of a document as attributes; None where a key is absent. ``from`` is ``from_``."""

    _keys: ClassVar[Mapping[str, Callable[[Any], Any]]] = {}  # what makes an attribute's value of a JSON value

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.data: Mapping[str, Any] = data  #: as in the document

    if not TYPE_CHECKING:  # the classes declare their attributes

        def __getattr__(self, name: str) -> Any:
            key = name.rstrip("_")
            if key not in self._keys:
                instead = f"; use {_GONE[key]}" if key in _GONE else ""
                raise AttributeError(f"{type(self).__name__} has no attribute {name!r}{instead}")
            value = self.data.get(key)
            made = None if value is None else self._keys[key](value)
            self.__dict__[name] = made
            return made

    def __dir__(self) -> List[str]:
        return sorted({*interface(self), *(name_of(key) for key in self._keys)})

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, Fields) and self.data == other.data

    def to_xarray(self) -> "xarray.Dataset":
        """The lists of numbers: those of one length share a dimension, named after the first. The rest as ``attrs``."""
        arrays = {name: getattr(self, name) for name, _ in self._shown()}
        arrays = {name: value for name, value in arrays.items() if isinstance(value, np.ndarray) and value.ndim == 1}
        first = {len(value): name for name, value in reversed(list(arrays.items()))}
        facts = {name: value for name, value in self._shown() if isinstance(value, (str, int, float))}
        coordinates = {name: arrays.pop(name) for name in first.values()}
        return dataset({name: ((first[len(value)],), value) for name, value in arrays.items()}, coordinates, facts)

    def __repr__(self) -> str:
        words = ", ".join(f"{name}={_brief(value)}" for name, value in self._shown())
        return f"<rocking.{type(self).__name__} {words}>"

    def _repr_html_(self) -> str:
        return _table(["key", "value"], [[name, _brief(value)] for name, value in self._shown()])

    def _shown(self) -> Iterator[Tuple[str, Any]]:
        return ((name_of(key), self.data[key]) for key in self.data if key in self._keys)


class Rows(List[_Row]):
    """A list of objects that is a table: a row each.

    >>> import rocking
    >>> levels = rocking.fields.Rows([rocking.documents.State({"tilt": 0.5}), rocking.documents.State({"tilt": None})])
    >>> levels.column("tilt")
    array([0.5, nan])
    """

    __dir__ = interface

    def column(self, name: str) -> npt.NDArray[Any]:
        """The values of one attribute, ``intensity`` or ``law.median.value``, by row; NaN where a number is missing."""
        values = [_attribute(row, name) for row in self]
        if any(value is None for value in values):
            values = [np.nan if value is None else value for value in values]
        return np.array(values)

    def to_pandas(self) -> "pandas.DataFrame":
        """A row each, with a column for each key; keys of objects within have names such as ``law.median.value``."""
        import pandas

        return pandas.json_normalize([row.data for row in self if isinstance(row, Fields)])

    def to_xarray(self) -> "xarray.Dataset":
        """The same along the dimension ``row``."""
        table = self.to_pandas().rename_axis("row")
        return table.to_xarray()

    def __repr__(self) -> str:
        return f"<rocking.Rows: {len(self)} of {', '.join(sorted({type(row).__name__ for row in self}))}>"

    def _repr_html_(self) -> str:
        shown = [dict(row._shown()) for row in self[:_MOST_ROWS] if isinstance(row, Fields)]
        names = list(dict.fromkeys(name for row in shown for name in row))
        rows = [["" if row.get(name) is None else _brief(row[name]) for name in names] for row in shown]
        rest = f"<p>{len(self) - _MOST_ROWS} more rows</p>" if len(self) > _MOST_ROWS else ""
        return _table(names, rows) + rest


class Document(Fields):
    """What a study has found, as a file of rocking holds it. Notebooks show it with its figures."""

    def __init__(self, text: str, table: str = "", answer: str = "") -> None:
        super().__init__(json.loads(text))
        self.json: str = text  #: as the program writes it
        self.answer: str = answer  #: what was found, in one sentence
        self._table = table

    def table(self) -> str:
        """What the program prints."""
        return self._table

    def _repr_html_(self) -> str:
        tables = [f"<h4>{name}</h4>{getattr(self, name)._repr_html_()}" for name in self._tables()]
        return super()._repr_html_() + "".join(tables) + pictures("draw", [("", self.json)], shown=(0.0, None))

    def _tables(self) -> List[str]:
        return [name for name, value in self._shown() if value and isinstance(getattr(self, name), Rows)]


def pictures(function: str, *source: Any, shown: Tuple[Any, ...]) -> str:
    """The first figures that a function of the core draws, as HTML; empty where gnuplot or fmt is missing."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            files, _ = getattr(_core, function)(*source, folder, 0, ["svg"], *shown)
        except (AttributeError, ValueError):  # built without fmt; an InputError where there is nothing to draw
            return ""
        drawn = [Path(file) for file in files if file.endswith(".svg")][:3]
        images = [base64.b64encode(file.read_bytes()).decode() for file in drawn]
    return "".join(f'<img src="data:image/svg+xml;base64,{image}"/>' for image in images)


def dataset(
    variables: Mapping[str, Tuple[Tuple[str, ...], Any]], coordinates: Mapping[str, Any], facts: Mapping[str, Any]
) -> "xarray.Dataset":
    """Variables with the names of their dimensions, the values along these, and what holds for all of them."""
    import xarray

    known = {name: value for name, value in facts.items() if value is not None}
    return xarray.Dataset(dict(variables), dict(coordinates), known)


def name_of(key: str) -> str:
    """The attribute of a key."""
    return "from_" if key == "from" else key


def same(value: Any) -> Any:
    """A text, a number, or what has no list of fields."""
    return value


def numbers(value: Any) -> npt.NDArray[np.float64]:
    """An array of numbers; NaN for null."""
    return np.array(value, dtype=float)


def whole_numbers(value: Any) -> npt.NDArray[np.int64]:
    """An array of whole numbers."""
    return np.array(value, dtype=np.int64)


def complex_numbers(value: Any) -> npt.NDArray[np.complex128]:
    """An array of [re, im]."""
    return np.array([complex(*pair) for pair in value], dtype=complex)


def rows_of(make: Callable[[Any], _Row]) -> Callable[[Any], Rows[_Row]]:
    """A list of objects."""
    return lambda value: Rows(make(row) for row in value)


def by_name(make: Callable[[Any], _Row]) -> Callable[[Any], Dict[str, _Row]]:
    """An object of any keys."""
    return lambda value: {name: make(item) for name, item in value.items()}


def either(*classes: Any) -> Callable[[Any], Any]:
    """An object of the first class that has all its keys, or what is no object."""

    def make(value: Any) -> Any:
        if not isinstance(value, dict):
            return value
        return next(each for each in classes if value.keys() <= each._keys.keys())(value)

    return make


def _attribute(row: Any, name: str) -> Any:
    for part in name.split("."):
        row = None if row is None else getattr(row, part)
    return row


def _brief(value: Any) -> str:
    """A number or a text; what is short of a list or an object, else its size."""
    if isinstance(value, float):
        return f"{value:.6g}"
    if not isinstance(value, (list, dict)):
        return str(value)
    inner = list(value.values() if isinstance(value, dict) else value)
    if len(inner) > 3 or any(isinstance(each, (list, dict)) for each in inner):
        return f"{len(inner)} {'keys' if isinstance(value, dict) else 'entries'}"
    if isinstance(value, dict):
        return f"{{{', '.join(f'{name}: {_brief(each)}' for name, each in value.items())}}}"
    return f"[{', '.join(map(_brief, inner))}]"


def _table(names: List[str], rows: List[List[str]]) -> str:
    head = "".join(f"<th>{html.escape(name)}</th>" for name in names)
    body = "".join("<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
