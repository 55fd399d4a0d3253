"""How a study is asked."""

from __future__ import annotations

import json
import math
import os
import platform
import warnings
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from . import _core
from .errors import InputError
from .experiments import ExperimentLike, experiment
from .results import Result
from .running import Progress, now, open_run, processors, run
from .tables import Given, Text, file, told_by_row

Source = Union[Result, ExperimentLike]
#: How an argument is read, called with its keyword, and the argument.
Asked = Tuple[Callable[[str, Any], Any], Any]
NO_SOURCE = object()


def one(keyword: str, given: Any) -> Any:
    """A value as it is; what is wrong with it is refused by the library."""
    return given


def items(keyword: str, given: Any) -> List[Any]:
    """One value, or several, as a list."""
    if given is None:
        return []
    is_one = isinstance(given, (str, bytes, os.PathLike, Mapping)) or not hasattr(given, "__iter__")
    return [given] if is_one else list(given)


def items_if_given(keyword: str, given: Any) -> Optional[List[Any]]:
    """Likewise, where nothing is not the same as none."""
    return None if given is None else items(keyword, given)


def seed_text(keyword: str, given: Any) -> Any:
    """A seed as the library reads it."""
    return str(given) if isinstance(given, int) else given


def several(given: Union[Source, Sequence[Source]]) -> Sequence[Source]:
    """One subject, or several, as a list."""
    return given if isinstance(given, (list, tuple)) else [given]  # type: ignore[list-item]


def _plain(value: Any, texts: Dict[str, str]) -> Any:
    """A value that JSON can hold: what it cannot is named, and refused with its keyword."""
    if isinstance(value, Text):
        name = value.name
        while name in texts:
            name += "'"
        texts[name] = value.text
        return name
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        return [_plain(each, texts) for each in value]
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if value is None or isinstance(value, (str, int, float)):
        return value
    return {"a": type(value).__name__}


def refusing(place: str, make: Callable[[], Any]) -> Any:
    """What a function makes of an argument; a wrong type or value is refused as all input is."""
    try:
        return make()
    except InputError:
        raise
    except (TypeError, ValueError) as error:
        raise InputError([(place, "", str(error), "", "")]) from None


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


def _question(question: Dict[str, Asked], texts: Dict[str, str]) -> str:
    found = {}
    for keyword, (reading, given) in question.items():
        value = refusing(keyword, lambda: reading(keyword, given))
        found[keyword] = _plain(value, texts)
    return json.dumps(found)


def answer(
    study: str,
    question: Dict[str, Asked],
    *,
    source: Any = NO_SOURCE,
    seed: Union[int, str, None] = None,
    realisations: Optional[int] = None,
    runs: Sequence[Source] = (),
    resume: Optional[Given] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Tuple[str, str, str]:
    """The text of the document that a study writes, what the program prints, and the answer in a sentence."""
    if not (threads is None or (type(threads) is int and 0 < threads < 2**16)):
        raise InputError([("threads", repr(threads), "must be a whole number from 1", "", "")])
    if not (progress is None or callable(progress)):
        raise InputError([("progress", type(progress).__name__, "must be a function", "", "")])
    results = [refusing("source", lambda: _result(each, threads, progress)) for each in runs]
    names = [_name_of(each, i, len(runs)) for i, each in enumerate(runs)]
    about = None
    if source is not NO_SOURCE:
        about = refusing("source", lambda: experiment(source, seed=seed, realisations=realisations))
    texts: Dict[str, str] = {}
    asked = _question(question, texts)
    with told_by_row(list(texts)):
        text, table, sentence, notices = _core.answer(
            study,
            asked,
            None if about is None else about._core,
            "." if about is None else about._files,
            [(name, each.experiment._core, each._core) for name, each in zip(names, results)],
            texts,
            refusing("resume", lambda: _document(resume)),
            threads or processors(),
            platform.platform(),
            now(),
            progress,
        )
    for notice in notices:
        warnings.warn(notice, stacklevel=3)
    return text, table, sentence
