"""Comparisons of two runs with common random numbers."""

from __future__ import annotations

import json
import os
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Tuple, Union

from . import _core
from .results import Result
from .running import open_run

__all__ = ["Comparison", "ConditionComparison", "ModeComparison", "compare"]


class ModeComparison(NamedTuple):
    """One response mode in two runs."""

    both: int  #: realisations that have the mode in both runs
    first_only: int  #: in the first run only
    second_only: int  #: in the second run only
    neither: int  #: in none
    difference: float  #: of the probabilities, first minus second
    score: Tuple[float, float]  #: interval of the difference: Tango's
    exact: Tuple[float, float]  #: exact interval of the difference
    p_value: float  #: exact McNemar test of whether the difference is 0
    mid_p: float  #: the same with mid-p
    variance_reduction: Optional[float]  #: by common random numbers; None where no two realisations differ


class ConditionComparison:
    """One condition in two runs."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.parameters: Dict[str, Any] = dict(data["parameters"])  #: swept values of the first run by JSON pointer
        self.confidence: float = data["confidence"]  #: of the intervals
        self.realisations: int = data["realisations"]  #: that both runs have
        self.changed: int = data["changed"]["count"]  #: of these, with another response mode
        self.changed_interval: Tuple[float, float] = tuple(data["changed"]["interval"])  #: of their share: Clopper-Pearson
        #: by name, those that occurred in either run
        self.modes: Dict[str, ModeComparison] = {name: _mode(mode) for name, mode in data["modes"].items()}

    def __repr__(self) -> str:
        return f"<rocking.ConditionComparison: {self.changed} of {self.realisations} changed>"


class Comparison:
    """Two runs, compared realisation by realisation."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.data: Mapping[str, Any] = data  #: as in ``rocking.comparison/1``
        self.settings: List[str] = data["settings"]  #: differences between the experiments, in words
        self.tests: int = data["tests"]  #: number of p-values, which is needed to judge a single one
        self.conditions: List[ConditionComparison] = [ConditionComparison(each) for each in data["conditions"]]

    def __repr__(self) -> str:
        return f"<rocking.Comparison of {len(self.conditions)} condition(s)>"


def compare(
    first: Union[Result, str, "os.PathLike[str]"], second: Union[Result, str, "os.PathLike[str]"]
) -> Comparison:
    """Compare two runs of the same seed, pairwise: what a setting changes.

    first, second: a Result, or the folder of a run. The runs have the same seed and number of conditions; they may
    differ in anything else. Realisations that only one run has are left out. Intervals have the confidence of the first
    run. Raises InputError if the seeds or the numbers of conditions differ, OSError or StoreError as open_run().

    >>> import rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 20, "sampled_periods": 20}, "realisations": 10, "seed": "0x1"}
    >>> found = rocking.compare(rocking.run(slab), rocking.run({**slab, "restitution": 0.5}))
    >>> found.settings
    ['/restitution is 0.9, not 0.5']
    >>> found.conditions[0].realisations
    10
    """
    one, other = (each if isinstance(each, Result) else open_run(each) for each in (first, second))
    text = _core.compare(one.experiment._core, one._core, other.experiment._core, other._core)
    return Comparison(json.loads(text))


def _mode(data: Mapping[str, Any]) -> ModeComparison:
    return ModeComparison(
        both=data["both"],
        first_only=data["first_only"],
        second_only=data["second_only"],
        neither=data["neither"],
        difference=data["difference"],
        score=tuple(data["score"]),
        exact=tuple(data["exact"]),
        p_value=data["mcnemar_p_value"],
        mid_p=data["mcnemar_mid_p"],
        variance_reduction=data["variance_reduction"],
    )
