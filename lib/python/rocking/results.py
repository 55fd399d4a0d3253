"""Results of runs, as numpy arrays."""

from __future__ import annotations

import functools
import json
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

import numpy as np

from . import _core
from .experiments import Experiment

if TYPE_CHECKING:
    import pandas

__all__ = ["Result"]


class Result:
    """Result of a run. Rows are conditions, columns are response modes.

    Of a run that was stopped, and of a part of a divided run, there are ``done``, ``all``, ``counts`` and
    ``realisations()`` only; the others raise ValueError, because estimates of a part of the realisations are not those of
    the experiment.
    """

    def __init__(self, experiment: Experiment, core: _core.Run, provenance: tuple, folder: Optional[str]) -> None:
        self.experiment: Experiment = experiment
        self.folder: Optional[str] = folder
        self._core = core
        self._occasion = provenance

    @property
    def done(self) -> int:
        """Number of finished realisations."""
        return self._core.done

    @property
    def all(self) -> int:
        """Number of realisations of the experiment; with ``until``, of those that the run needed."""
        return self._core.all

    @property
    def is_complete(self) -> bool:
        """Whether all realisations are done."""
        return self._core.is_complete

    @functools.cached_property
    def modes(self) -> Tuple[str, ...]:
        """Names of the response modes, the columns: ``(1,1)``, ``chaotic``, ``overturned``, ..."""
        if not self.is_complete:
            return tuple(dict.fromkeys(mode for counts in self._core.counts for mode in counts))
        listed: Dict[Tuple[Any, ...], str] = {}
        for condition in self._core.estimates:
            for name, *_ in condition:
                listed[_order(name)] = name
        return tuple(listed[key] for key in sorted(listed))

    @functools.cached_property
    def counts(self) -> np.ndarray:
        """Realisations by mode: integers, shape (conditions, modes)."""
        table = np.zeros((len(self.experiment), len(self.modes)), dtype=np.int64)
        for row, counts in zip(table, self._core.counts):
            for mode, count in counts.items():
                row[self.modes.index(mode)] = count
        return table

    @property
    def trials(self) -> np.ndarray:
        """Finished realisations of each condition."""
        return self.counts.sum(axis=1)

    @property
    def probabilities(self) -> np.ndarray:
        """Shares of the realisations, shape (conditions, modes)."""
        self._expect_complete()
        return self.counts / self.trials[:, np.newaxis]

    @functools.cached_property
    def intervals(self) -> np.ndarray:
        """Ends of the intervals of the program's table, shape (conditions, modes, 2).

        Simultaneous Bonferroni-Clopper-Pearson intervals over all possible modes; with ``until`` the confidence
        sequence, which is valid whenever the run stops. A mode that a condition does not list, because it did not occur
        there, has NaN.
        """
        self._expect_complete()
        table = np.full((len(self.experiment), len(self.modes), 2), np.nan)
        for row, condition in zip(table, self._core.estimates):
            for name, _, _, _, interval in condition:
                row[self.modes.index(name)] = interval
        return table

    @property
    def digest(self) -> str:
        """SHA-256 of the results of all realisations: ``result.digest`` of the program's report."""
        self._expect_complete()
        return self._core.digest()

    def probability(self, mode: str) -> np.ndarray:
        """Probability of one mode in each condition; 0 where it did not occur."""
        if mode not in self.modes:
            self._expect_complete()
            return np.zeros(len(self.experiment))
        return self.probabilities[:, self.modes.index(mode)]

    def parameter(self, pointer: str) -> np.ndarray:
        """The values that the sweep sets at a JSON pointer, such as ``/excitation/amplitude``, by condition."""
        values = [self.experiment.parameters(i) for i in range(len(self.experiment))]
        if pointer not in values[0]:
            raise KeyError(f"{pointer}: the sweep sets {', '.join(values[0]) or 'nothing'}")
        return np.array([value[pointer] for value in values])

    def report(self) -> dict:
        """The whole report (``rocking.report/1``), as the program writes it."""
        self._expect_complete()
        return json.loads(self._core.report(self.experiment._core, *self._occasion))

    def realisations(self) -> np.ndarray:
        """A structured array with a row for each finished realisation.

        Fields: condition, realisation, mode (place in ``realisation_modes``), termination (place in
        ``rocking.TERMINATIONS``), left_ground, past_balance, margin, peak_tilt [-], peak_tilt_rate [-], peak_slip [-],
        peak_slip_m [m], final_slip [-], final_slip_m [m].
        """
        return self._rows[1]

    @property
    def realisation_modes(self) -> List[str]:
        """Names of the modes in ``realisations()``."""
        return self._rows[0]

    @functools.cached_property
    def _rows(self) -> Tuple[List[str], np.ndarray]:
        return self._core.rows()

    def table(self, width: int = 120) -> str:
        """The result in words and columns, as ``rocking run`` prints it in lines of about ``width`` letters.

        >>> import rocking
        >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
        ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0}, "restitution": 0.9,
        ...     "horizon": {"transient_periods": 20, "sampled_periods": 20}}
        >>> "nothing is random" in rocking.run(slab).table()
        True
        """
        self._expect_complete()
        return self._core.table(self.experiment._core, width)

    def to_pandas(self) -> "pandas.DataFrame":
        """A row for each condition and mode: swept parameters, mode, count, realisations, probability, low, high."""
        import pandas

        self._expect_complete()
        rows = []
        for i in range(len(self.experiment)):
            parameters = self.experiment.parameters(i)
            for j, mode in enumerate(self.modes):
                low, high = self.intervals[i, j]
                rows.append(
                    {
                        "condition": i,
                        **parameters,
                        "mode": mode,
                        "count": self.counts[i, j],
                        "realisations": self.trials[i],
                        "probability": self.probabilities[i, j],
                        "low": low,
                        "high": high,
                    }
                )
        return pandas.DataFrame(rows)

    def _expect_complete(self) -> None:
        if self.is_complete:
            return
        if self.done == self.all:
            raise ValueError("one part of a divided run has no estimates; rocking.merge() joins the parts")
        raise ValueError(f"{self.done} of {self.all} realisations are done: the run was stopped, or parts are missing")

    def __repr__(self) -> str:
        state = "" if self.is_complete else f", {self.done} done"
        return f"<rocking.Result of {self.all} realisations of {len(self.experiment)} condition(s){state}>"


def _order(mode: str) -> tuple:
    """Order of the columns: periodic by n, then by m; then the others as in tables."""
    if mode.startswith("("):
        rocks, periods = mode[1:-1].split(",")
        return (0, int(periods), int(rocks))
    return (1, ["chaotic", "overturned", "rest", "unresolved"].index(mode))
