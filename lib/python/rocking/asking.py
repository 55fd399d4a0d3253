"""How a study is asked."""

from __future__ import annotations

import json
import math
import os
import platform
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

from . import _core
from .experiments import ExperimentLike, experiment
from .results import Result
from .running import Progress, now, open_run, processors, run

Path = Union[str, "os.PathLike[str]"]
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


def ends(name: str, given: Tuple[Optional[float], Optional[float]]) -> Dict[str, Optional[float]]:
    """Both ends of a range as two keywords."""
    low, high = given
    return {f"{name}[0]": low, f"{name}[1]": high}


def _plain(value: Any) -> Any:
    """A value that JSON can hold: a number that is not finite is named, and refused with its keyword."""
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if isinstance(value, list):
        return [_plain(each) for each in value]
    return value.item() if hasattr(value, "item") else value


def _result(source: Source, threads: Optional[int], progress: Optional[Progress]) -> Result:
    if isinstance(source, Result):
        return source
    if isinstance(source, (str, os.PathLike)) and os.path.isdir(source):
        return open_run(source)
    return run(source, threads=threads, progress=progress)


def answer(
    study: str,
    question: Dict[str, Any],
    *,
    source: Optional[ExperimentLike] = None,
    runs: Sequence[Source] = (),
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> str:
    """The text of the document that a study writes."""
    results = [_result(each, threads, progress) for each in runs]
    about = None if source is None else experiment(source)
    return _core.answer(
        study,
        json.dumps({keyword: _plain(value) for keyword, value in question.items()}),
        None if about is None else about._core,
        "." if about is None else about._files,
        [(each.experiment._core, each._core) for each in results],
        threads or processors(),
        platform.platform(),
        now(),
        progress,
    )
