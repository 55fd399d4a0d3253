"""Exceptions of the package. A file that cannot be read or written raises :class:`OSError`."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, NamedTuple, Sequence, Tuple

from .fields import interface

if TYPE_CHECKING:
    from .results import Result

__all__ = ["DifferentBits", "InputError", "Interrupted", "Problem", "StoreError"]


def in_python(words: str) -> str:
    """Words about flags as those of keywords; a command of the program, between backticks, stays."""
    parts = words.split("`")
    flag = re.compile(r"(?<![\w-])--(\w[\w-]*)")
    parts[::2] = [flag.sub(lambda found: found[1].replace("-", "_"), part) for part in parts[::2]]
    return "`".join(parts)


class Problem(NamedTuple):
    """One fault of the input."""

    place: str  #: JSON pointer such as ``/block/width_m``, or name of the argument
    value: str  #: the value found there, as written; empty if there is none
    reason: str  #: why it is not accepted
    remedy: str  #: what would be accepted; empty if the reason says it
    where: str  #: file and line; empty if ``place`` says it, or the text of the input was made here

    __dir__ = interface

    def __str__(self) -> str:
        text = f"{self.where}: " if self.where else ""
        text += self.place
        if self.value:
            text += f" = {self.value}"
        text += f": {self.reason}"
        return f"{text}; {self.remedy}" if self.remedy else text


class InputError(ValueError):
    """The input cannot be used. Has all problems that were found.

    >>> import rocking
    >>> try:
    ...     rocking.validate({"format": "rocking.experiment/1", "block": {"width_m": -1, "height_m": 4}})
    ... except rocking.InputError as error:
    ...     print(error.pointer)
    /block/width_m
    """

    problems: Tuple[Problem, ...]

    __dir__ = interface

    def __init__(self, problems: Sequence[Tuple[str, str, str, str, str]]) -> None:
        self.problems = tuple(
            Problem(in_python(place), value, in_python(reason), in_python(remedy), where)
            for place, value, reason, remedy, where in problems
        )
        super().__init__("\n".join(str(problem) for problem in self.problems))

    def __reduce__(self) -> Tuple[Any, ...]:  # so that it reaches the parent of a process pool
        return type(self), (tuple(tuple(problem) for problem in self.problems),)

    @property
    def pointer(self) -> str:
        """Place of the first problem: a JSON pointer."""
        return self.problems[0].place if self.problems else ""


class DifferentBits(RuntimeError):
    """A realisation that was simulated again has another result than the stored one."""


class StoreError(RuntimeError):
    """A store of realisations is damaged, or is none."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C stopped the run. What is done is kept in ``result``, and in the folder if there is one."""

    result: "Result"

    __dir__ = interface

    def __init__(self, result: "Result") -> None:
        self.result = result
        kept = f"; {result.folder} keeps them, and the same call goes on" if result.folder else ""
        super().__init__(f"stopped after {result.done} of {result.all} realisations{kept}")

    def __reduce__(self) -> Tuple[Any, ...]:
        return type(self), (self.result,)
