"""Tables that are given in place of files."""

from __future__ import annotations

import contextlib
import csv
import io
import json
import os
import re
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Protocol, Sequence, Union

from .errors import InputError, Problem

if TYPE_CHECKING:
    import numpy.typing as npt
    import pandas

Path = Union[str, "os.PathLike[str]"]
#: Columns by name, rows, a structured array, a table of pandas, or two columns without names.
Table = Union[
    Mapping[str, Any], Sequence[Mapping[str, Any]], Sequence[Sequence[float]], "npt.NDArray[Any]", "pandas.DataFrame"
]


class HasText(Protocol):
    """A hazard curve."""

    @property
    def text(self) -> str: ...


class HasJson(Protocol):
    """A document."""

    @property
    def json(self) -> str: ...


#: A path, or what stands in the file.
Given = Union[Path, Table, HasText, HasJson]


class Text(NamedTuple):
    """What stands in place of a file."""

    name: str
    text: str


def file(name: str, given: Optional[Given]) -> Union[None, str, Text]:
    """A path, or the text of what is given; `name` is the keyword."""
    if given is None or isinstance(given, (str, os.PathLike)):
        return given if given is None else os.fspath(given)
    text = getattr(given, "json", getattr(given, "text", None))  # of a document, of a hazard curve
    return Text(getattr(given, "file", name), text if isinstance(text, str) else _csv(_columns(given)))


def files(name: str, given: Union[None, Given, Sequence[Given]]) -> List[Union[None, str, Text]]:
    """One file, or several."""
    is_one = isinstance(given, (str, os.PathLike, Mapping)) or not isinstance(given, Sequence) or _is_pair(given)
    if given is None or is_one:
        return [] if given is None else [file(name, given)]  # type: ignore[arg-type]
    if len(given) == 0:
        raise InputError([(name, "", "is an empty list", "omit it, or give a file or a table", "")])
    return [file(f"{name}[{i}]", each) for i, each in enumerate(given)]


@contextlib.contextmanager
def told_by_row(names: Sequence[str]) -> Iterator[None]:
    """Problems of these texts name the row, counted from 0, and no line: the caller has not seen the text."""
    try:
        yield
    except InputError as error:
        raise InputError([_by_row(problem, names) for problem in error.problems]) from None


def _by_row(problem: Problem, names: Sequence[str]) -> Problem:
    found = [name for name in names for said in (problem.place, problem.where) if f"{said}, ".startswith(f"{name}, ")]
    if not found:
        return problem
    place = re.sub(r", line (\d+)$", lambda line: _row(int(line[1])), problem.place)
    reason = re.sub(r"\bline (\d+)", lambda line: f"row {int(line[1]) - 2}", problem.reason)
    return problem._replace(place=place, reason=reason, where=found[0] if problem.where else "")


def _row(line: int) -> str:
    return f"[{line - 2}]" if line > 1 else ""  # the first line has the names of the columns


def _is_pair(given: Any) -> bool:
    """Whether they are two columns of numbers."""
    def is_column(each: Any) -> bool:
        return not isinstance(each, (str, Mapping)) and hasattr(each, "__len__") and not any(
            hasattr(one, "__len__") for one in each)

    return len(given) == 2 and all(is_column(each) for each in given)


def _columns(given: Any) -> Dict[str, List[Any]]:
    if hasattr(given, "columns"):  # of pandas
        return {str(name): given[name].tolist() for name in given.columns}
    if isinstance(given, Mapping):
        return {name: _column(values) for name, values in given.items()}
    names = getattr(getattr(given, "dtype", None), "names", None)
    if names:
        return {name: given[name].tolist() for name in names}
    if hasattr(given, "__len__") and _is_pair(given):
        return {"intensity": _column(given[0]), "annual_rate": _column(given[1])}
    if isinstance(given, Sequence) and given and all(isinstance(row, Mapping) for row in given):
        if any(row.keys() != given[0].keys() for row in given):
            raise ValueError("the rows of a table must have the same keys")
        return {name: [row[name] for row in given] for name in given[0]}
    raise TypeError(f"a {type(given).__name__} is neither a path nor a table: give columns by name, such as "
                    '{"pga_g": [...], "annual_rate": [...]}')


def _column(values: Any) -> List[Any]:
    if hasattr(values, "tolist"):
        values = values.tolist()
    return list(values) if isinstance(values, (list, tuple)) else [values]


def _csv(columns: Mapping[str, Sequence[Any]]) -> str:
    lengths = {name: len(values) for name, values in columns.items()}
    if len(set(lengths.values())) > 1:
        raise ValueError(f"the columns of a table must have one length, not {lengths}")
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(columns)
    table.writerows([_cell(value) for value in row] for row in zip(*columns.values()))
    return text.getvalue()


def _cell(value: Any) -> str:
    value = value.item() if hasattr(value, "item") else value
    if value is None or isinstance(value, str):
        return value or ""
    return json.dumps(value)
