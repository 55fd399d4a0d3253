"""Results of runs, as numpy arrays."""

from __future__ import annotations

import functools
import html
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple

import numpy as np

from . import _core, documents
from .experiments import Experiment
from .fields import dataset, interface, pictures

if TYPE_CHECKING:
    import numpy.typing as npt
    import pandas
    import xarray

__all__ = ["Result"]


Provenance = Tuple[str, str, float, int]  # machine, start, duration [s], threads


class Result:
    """Result of a run. Rows are conditions, columns are response modes.

    Of a run that was stopped or has come to its ``max_time``, and of a part of a divided run, there are ``done``, ``all``, ``counts`` and
    ``realisations()`` only; the others raise ValueError, because estimates of a part of the realisations are not those of
    the experiment.
    """

    def __init__(self, experiment: Experiment, core: _core.Run, provenance: Provenance, folder: Optional[str]) -> None:
        self.experiment: Experiment = experiment
        self.folder: Optional[str] = folder
        self._core = core
        self._provenance = provenance

    __dir__ = interface

    @property
    def done(self) -> int:
        """Number of finished realisations."""
        return self._core.done

    @property
    def all(self) -> int:
        """Number of realisations of the experiment; with ``until``, of those that the run needed."""
        return self._core.all

    @property
    def damaged_file(self) -> Optional[str]:
        """Where the damaged store is that the run has repaired; None if it has not."""
        return self._core.damaged_file

    @property
    def is_complete(self) -> bool:
        """Whether all realisations are done."""
        return self._core.is_complete

    @functools.cached_property
    def modes(self) -> Tuple[str, ...]:
        """Names of the response modes, the columns: ``(1,1)``, ``chaotic``, ``overturned``, ..."""
        return tuple(self._core.modes())

    @functools.cached_property
    def counts(self) -> npt.NDArray[np.int64]:
        """Realisations by mode: shape (conditions, modes)."""
        return self._core.counts()

    @property
    def trials(self) -> npt.NDArray[np.int64]:
        """Finished realisations of each condition."""
        found: npt.NDArray[np.int64] = self.counts.sum(axis=1)
        return found

    @property
    def probabilities(self) -> npt.NDArray[np.float64]:
        """Shares of the realisations, shape (conditions, modes)."""
        self._expect_complete()
        return self.counts / self.trials[:, np.newaxis]

    @functools.cached_property
    def intervals(self) -> npt.NDArray[Any]:
        """Ends of the intervals of the program's table, shape (conditions, modes, 2).

        Simultaneous Bonferroni-Clopper-Pearson intervals over all possible modes; with ``until`` the confidence
        sequence, which is valid whenever the run stops. A mode that a condition does not list, because it did not occur
        there, has NaN.
        """
        self._expect_complete()
        return self._core.intervals()

    @property
    def digest(self) -> str:
        """SHA-256 of the results of all realisations: ``result.digest`` of the program's report."""
        self._expect_complete()
        return self._core.digest()

    def probability(self, mode: str) -> npt.NDArray[Any]:
        """Probability of one mode in each condition; 0 where it did not occur."""
        if mode not in self.modes:
            self._expect_complete()
            return np.zeros(len(self.experiment))
        return self.probabilities[:, self.modes.index(mode)]

    def parameter(self, pointer: str) -> npt.NDArray[Any]:
        """The values that the sweep sets at a JSON pointer, such as ``/excitation/amplitude``, by condition."""
        values = [self.experiment.parameters(i) for i in range(len(self.experiment))]
        if pointer not in values[0]:
            raise KeyError(f"{pointer}: the sweep sets {', '.join(values[0]) or 'nothing'}")
        return np.array([value[pointer] for value in values])

    def report(self) -> documents.Report:
        """The whole report (``rocking.report/1``), as the program writes it."""
        self._expect_complete()
        return documents.Report(self._core.report(self.experiment._core, *self._provenance), self.table())

    def realisations(self) -> npt.NDArray[Any]:
        """A structured array with a row for each finished realisation.

        Fields: condition, realisation, mode (place in ``modes``), termination (place in ``rocking.TERMINATIONS``),
        left_ground, past_balance, overturned_side (1: left, -1: right, 0: none), margin, peak_tilt [-], peak_tilt_rate [-], peak_slip [-], peak_slip_m [m],
        final_slip [-], final_slip_m [m].
        """
        return self._rows

    @functools.cached_property
    def _rows(self) -> npt.NDArray[Any]:
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

    def to_xarray(self) -> "xarray.Dataset":
        """``count``, ``probability``, ``low`` and ``high`` by the swept parameters and ``mode``, and ``realisations``.

        A dimension has the name of its entry of the sweep, the last part of the pointer, or the pointer where two agree.
        """
        self._expect_complete()
        swept = self.experiment.parameters(0)
        ends = [pointer.rsplit("/", 1)[-1] for pointer in swept]
        names = [end if ends.count(end) == 1 and end != "mode" else pointer for end, pointer in zip(ends, swept)]
        shape = self.experiment.shape
        coordinates: Dict[str, Any] = {"mode": list(self.modes)}
        places = np.arange(len(self.experiment)).reshape(shape)
        for axis, (name, pointer) in enumerate(zip(names, swept)):
            along = np.moveaxis(places, axis, 0).reshape(shape[axis], -1)[:, 0]
            values = [self.experiment.parameters(int(i))[pointer] for i in along]
            coordinates[name] = [str(value) if isinstance(value, (dict, list)) else value for value in values]
        place = (*names, "mode")
        low, high = self.intervals[..., 0], self.intervals[..., 1]
        tables = {"count": self.counts, "probability": self.probabilities, "low": low, "high": high}
        variables: Dict[str, Any] = {name: (place, table.reshape(*shape, -1)) for name, table in tables.items()}
        variables["realisations"] = (tuple(names), self.trials.reshape(shape))
        return dataset(variables, coordinates, {"title": self.experiment.title, "digest": self.digest})

    def __reduce__(self) -> Tuple[Any, ...]:
        kept = (self._core.bytes(), self._core.damaged_file)
        return _of_bytes, (self.experiment, *kept, self._provenance, self.folder)

    def __deepcopy__(self, memo: Dict[int, Any]) -> Result:
        return Result(self.experiment, self._core, self._provenance, self.folder)

    def _expect_complete(self) -> None:
        if self.is_complete:
            return
        if self.done == self.all:
            raise ValueError("one part of a divided run has no estimates; rocking.resume() joins the parts")
        raise ValueError(f"{self.done} of {self.all} realisations are done: the run was stopped, or parts are missing")

    def _repr_html_(self) -> str:
        if not self.is_complete:
            return repr(self)
        return f"<pre>{html.escape(self.table())}</pre>" + pictures(
            "write_figures", self.experiment._core, self._core, shown=(None,))

    def __repr__(self) -> str:
        state = "" if self.is_complete else f", {self.done} done"
        return f"<rocking.Result of {self.all} realisations of {len(self.experiment)} condition(s){state}>"


def _of_bytes(
    experiment: Experiment, store: bytes, damaged_file: Optional[str], provenance: Provenance, folder: Optional[str]
) -> Result:
    """A result that was pickled."""
    return Result(experiment, _core.run_of(experiment._core, store, damaged_file), provenance, folder)
