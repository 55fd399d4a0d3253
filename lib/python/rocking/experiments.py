"""Experiments as dictionaries, paths or objects."""

from __future__ import annotations

import json
import math
import os
from typing import Any, Dict, Mapping, Optional, Tuple, Union

from . import _core
from .fields import interface

__all__ = ["Experiment", "ExperimentLike", "experiment", "validate"]

ExperimentLike = Union["Experiment", Mapping[str, Any], str, "os.PathLike[str]"]


def _plain(value: Any) -> Any:
    """Numbers and arrays of numpy as those of Python; what JSON has not is named, and refused with its place."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, Mapping):
        return {str(key): _plain(each) for key, each in value.items()}
    if isinstance(value, (list, tuple, range)):
        return [_plain(each) for each in value]
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if value is None or isinstance(value, (str, int, float)):
        return value
    raise TypeError(f"an experiment cannot contain a {type(value).__name__}")


class Experiment:
    """A checked experiment. Made by :func:`experiment`; can be given wherever an experiment is asked for."""

    def __init__(self, core: _core.Experiment, files: str) -> None:
        self._core = core
        self._files = files  # folder of the ground motions that it names

    @property
    def title(self) -> str:
        """Its title; may be empty."""
        return self._core.title

    @property
    def seed(self) -> int:
        """Its seed, of 64 bits."""
        return self._core.seed

    @property
    def shape(self) -> Tuple[int, ...]:
        """Number of values of each entry of the sweep: the grid of the conditions, whose last entry varies fastest."""
        return tuple(self._core.shape)

    def __len__(self) -> int:
        """Number of conditions."""
        return self._core.conditions

    def parameters(self, condition: int) -> Dict[str, Any]:
        """The swept values of a condition, by JSON pointer."""
        if not 0 <= condition < len(self):
            raise IndexError(f"condition {condition}: the experiment has {len(self)}, counted from 0")
        return dict(self._core.parameters(condition))

    def to_dict(self) -> Dict[str, Any]:
        """The experiment with every default written out."""
        found: Dict[str, Any] = json.loads(self._core.text)
        return found

    __dir__ = interface

    def __reduce__(self) -> Tuple[Any, ...]:
        return _of_text, (self._core.text, self._files)

    def __deepcopy__(self, memo: Dict[int, Any]) -> Experiment:
        return self  # nothing of it can change

    def __repr__(self) -> str:
        return f"<rocking.Experiment {self.title!r}, {len(self)} condition{'s' if len(self) != 1 else ''}>"


def _of_text(text: str, files: str) -> Experiment:
    return Experiment(_core.parse(text, "", files, None, None, False), files)


def experiment(
    source: ExperimentLike,
    *,
    seed: Union[int, str, None] = None,
    realisations: Optional[int] = None,
    skip_unreadable: bool = False,
) -> Experiment:
    """Read and check an experiment.

    source: a dictionary as in an experiment file, the path of one, or an Experiment, which is returned as it is.
    seed, realisations: replace those of the source; not with an Experiment.
    skip_unreadable: leaves out records of a suite that cannot be read; `excitation.left_out` names them.

    Ground motions that a dictionary names are relative to the current folder, those of a file to the file's.
    Raises InputError with all problems, each with its place in the experiment, and of a file with the line; and OSError
    where a file cannot be read.

    >>> import rocking
    >>> slab = rocking.experiment({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0}, "restitution": 0.9})
    >>> len(slab), slab.to_dict()["realisations"]
    (1, 1)
    """
    if isinstance(source, Experiment):
        if seed is not None or realisations is not None or skip_unreadable:
            raise TypeError("seed, realisations and skip_unreadable are of a dictionary or a file, not of an Experiment")
        return source
    seed_text = None if seed is None else str(seed)
    number_text = None if realisations is None else str(realisations)
    if isinstance(source, Mapping):
        text = json.dumps(_plain(source))
        return Experiment(_core.parse(text, "", ".", seed_text, number_text, skip_unreadable), os.getcwd())
    path = os.fspath(source)
    return Experiment(_core.read(path, seed_text, number_text, skip_unreadable), os.path.dirname(os.path.abspath(path)))


def validate(
    source: ExperimentLike,
    *,
    seed: Union[int, str, None] = None,
    realisations: Optional[int] = None,
    skip_unreadable: bool = False,
) -> Dict[str, Any]:
    """The experiment with every default written out, as a dictionary. Nothing is simulated. Arguments as experiment().

    >>> import rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0}, "restitution": 0.9}
    >>> rocking.validate(slab)["horizon"]
    {'transient_periods': 500, 'sampled_periods': 120}
    """
    return experiment(source, seed=seed, realisations=realisations, skip_unreadable=skip_unreadable).to_dict()
