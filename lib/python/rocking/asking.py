"""How a study is asked."""

from __future__ import annotations

import json
import math
import os
import platform
import warnings
from typing import Any, Callable, Dict, List, Optional, Sequence, Union

from . import _core
from .experiments import ExperimentLike, experiment
from .results import Result
from .running import Progress, now, open_run, processors, run
from .tables import Given, Path, Text, file, told_by_row

Source = Union[Result, ExperimentLike]


def words(given: Union[str, Sequence[str], None]) -> List[str]:
    """One word, or several, as a list."""
    return [given] if isinstance(given, str) else list(given or ())


def numbers(kind: Callable[[Any], Any], given: Any) -> List[Any]:
    """One number, or several, as a list of this kind."""
    if given is None:
        return []
    return [kind(each) for each in given] if hasattr(given, "__iter__") else [kind(given)]


def paths(given: Union[Path, Sequence[Path], None]) -> List[str]:
    """One path, or several, as a list."""
    return [os.fspath(given)] if isinstance(given, (str, os.PathLike)) else [os.fspath(each) for each in given or ()]


def several(given: Union[Source, Sequence[Source]]) -> Sequence[Source]:
    """One subject, or several, as a list."""
    return given if isinstance(given, (list, tuple)) else [given]  # type: ignore[list-item]


def _plain(value: Any, texts: Dict[str, str]) -> Any:
    """A value that JSON can hold: a number that is not finite is named, and refused with its keyword."""
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if isinstance(value, list):
        return [_plain(each, texts) for each in value]
    if isinstance(value, Text):
        name = value.name
        while name in texts:
            name += "'"
        texts[name] = value.text
        return name
    return value.item() if hasattr(value, "item") else value


def _result(source: Source, threads: Optional[int], progress: Optional[Progress]) -> Result:
    if isinstance(source, Result):
        return source
    if isinstance(source, (str, os.PathLike)) and os.path.isdir(source):
        return open_run(source)
    return run(source, threads=threads, progress=progress)


def _name_of(source: Source, number: int, all: int) -> str:
    if isinstance(source, (str, os.PathLike)):
        return os.fspath(source)
    return "the run" if all == 1 else ("the first run", "the second run")[number] if all == 2 else f"run {number + 1}"


def _document(given: Optional[Given]) -> str:
    """The text of an earlier answer, or of its file; empty without one."""
    found = file("resume", given)
    if not isinstance(found, str):
        return "" if found is None else found.text
    with open(found, encoding="utf-8") as earlier:
        return earlier.read()


def answer(
    study: str,
    question: Dict[str, Any],
    *,
    source: Optional[ExperimentLike] = None,
    seed: Union[int, str, None] = None,
    realisations: Optional[int] = None,
    runs: Sequence[Source] = (),
    resume: Optional[Given] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> str:
    """The text of the document that a study writes."""
    results = [_result(each, threads, progress) for each in runs]
    names = [_name_of(each, i, len(runs)) for i, each in enumerate(runs)]
    about = None if source is None else experiment(source, seed=seed, realisations=realisations)
    texts: Dict[str, str] = {}
    asked = json.dumps({keyword: _plain(value, texts) for keyword, value in question.items()})
    with told_by_row(list(texts)):
        text, notices = _core.answer(
            study,
            asked,
            None if about is None else about._core,
            "." if about is None else about._files,
            [(name, each.experiment._core, each._core) for name, each in zip(names, results)],
            texts,
            _document(resume),
            threads or processors(),
            platform.platform(),
            now(),
            progress,
        )
    for notice in notices:
        warnings.warn(notice, stacklevel=3)
    return text
