"""One realisation in detail."""

from __future__ import annotations

import functools
import os
from typing import TYPE_CHECKING, Any, Optional, Tuple, Union, cast

import numpy as np

from . import _core, documents
from .experiments import ExperimentLike, experiment
from .fields import dataset, interface
from .results import Result
from .running import open_run

if TYPE_CHECKING:
    import numpy.typing as npt
    import pandas
    import xarray

__all__ = ["CONTACTS", "EVENTS", "TERMINATIONS", "Trajectory", "trajectory"]

#: Names of the contact states, by the number in the arrays.
CONTACTS = _core.contacts
#: Names of the kinds of events, by the number in the arrays.
EVENTS = _core.events
#: Names of the ways in which a realisation ends, by the number in the arrays.
TERMINATIONS = _core.terminations


class Trajectory:
    """One realisation: structured arrays, read only.

    States are Theta (tilt over psi), Theta', X (slip over R) and V; times are tau = p t. Beside them stand the same in SI
    units, as ``rocking trajectory --format csv --units si`` names them: time_s, tilt_rad, tilt_rate_rad_s, slip_m,
    slip_rate_m_s.
    """

    def __init__(self, core: _core.Trajectory, condition: int, realisation: int) -> None:
        self._core = core
        self.condition = condition  #: number of the condition, from 0
        self.realisation = realisation  #: number of the realisation, from 0

    __dir__ = interface

    @functools.cached_property
    def strobe(self) -> npt.NDArray[Any]:
        """At each excitation period: period, tilt, tilt_rate, slip, slip_rate, contact (place in CONTACTS), SI units."""
        return _joined(self._core.strobe, self._in_si[0])

    @functools.cached_property
    def events(self) -> npt.NDArray[Any]:
        """tau, kind (place in EVENTS), the state after the event, and both in SI units."""
        return _joined(self._core.events, self._in_si[1])

    @functools.cached_property
    def history(self) -> npt.NDArray[Any]:
        """tau, state, contact, base_acceleration [g], and time and state in SI units; empty unless asked for."""
        return _joined(self._core.history, self._in_si[2])

    @functools.cached_property
    def _in_si(self) -> Tuple[npt.NDArray[Any], ...]:
        return self._core.in_si()

    def __repr__(self) -> str:
        place = f"condition {self.condition}, realisation {self.realisation}"
        length = f"{len(self.strobe)} periods, {len(self.events)} events, {self.termination}"
        return f"<rocking.Trajectory of {place}: {length}>"

    @property
    def period_length(self) -> float:
        """Normalised time from one strobe point to the next, 2 pi/Omega_h."""
        return self._core.period_length

    @property
    def block(self) -> documents.Block:
        """The block of this realisation."""
        return self._facts.block

    @property
    def peaks(self) -> documents.Peaks:
        """Largest tilt, tilt_rate and slip, and the slip at the end."""
        return cast("documents.Peaks", self._facts.peaks)

    @property
    def energy(self) -> documents.EnergyBalance:
        """Energy balance, over m R^2 p^2."""
        return self._facts.energy

    @property
    def validity(self) -> documents.TrajectoryValidity:
        """Departures from the model."""
        return cast("documents.TrajectoryValidity", self._facts.validity)

    @property
    def termination(self) -> str:
        """Why it ended: ``reached_horizon``, ``overturned``, ``painleve`` or ``stopped``."""
        return self._facts.termination

    @property
    def mode(self) -> Optional[str]:
        """Response mode that a run gives this realisation; None with a number of periods."""
        return self._facts.mode

    @property
    def backed_by(self) -> Optional[str]:
        """What backs a label (m,n): ``orbit``, ``points`` or ``clouds``; None of others."""
        return self._facts.backed_by

    @functools.cached_property
    def _facts(self) -> documents.TrajectoryReport:
        return documents.TrajectoryReport(self._core.facts(self.condition, self.realisation))

    def text(self, format: str = "json", units: str = "normalised") -> str:
        """As ``rocking trajectory`` prints it: ``json`` or ``csv``, in ``normalised`` or ``si`` units."""
        if format not in ("json", "csv"):
            raise ValueError(f"format = {format!r}: must be 'json' or 'csv'")
        if units not in ("normalised", "si"):
            raise ValueError(f"units = {units!r}: must be 'normalised' or 'si'")
        return _core.trajectory_text(self._core, self.condition, self.realisation, units == "si", format == "csv")

    def to_pandas(self, rows: str = "strobe") -> "pandas.DataFrame":
        """``strobe``, ``events`` or ``history`` as a table, with all columns and the names of contacts and events."""
        import pandas

        if rows not in ("strobe", "events", "history"):
            raise ValueError(f"rows = {rows!r}: must be 'strobe', 'events' or 'history'")
        table = pandas.DataFrame(getattr(self, rows))
        for column, names in (("contact", CONTACTS), ("kind", EVENTS)):
            if column in table:
                table[column] = pandas.Categorical.from_codes(table[column], names)
        return table

    def to_xarray(self, rows: str = "strobe") -> "xarray.Dataset":
        """The same along ``period`` or ``tau``, with names of contacts and events."""
        table = self.to_pandas(rows)
        place = "period" if rows == "strobe" else "tau"
        names = {name: np.asarray(table[name], dtype=str) for name in ("contact", "kind") if name in table}
        variables = {name: ((place,), names.get(name, table[name].to_numpy())) for name in table if name != place}
        facts = {"condition": self.condition, "realisation": self.realisation, "termination": self.termination}
        return dataset(variables, {place: table[place].to_numpy()}, {**facts, "period_length": self.period_length})

    def __reduce__(self) -> Tuple[Any, ...]:
        return type(self), (self._core, self.condition, self.realisation)


def _joined(rows: npt.NDArray[Any], in_si: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Both as one structured array."""
    columns = {name: each[name] for each in (rows, in_si) for name in each.dtype.names or ()}
    joined = np.empty(len(rows), dtype=[(name, column.dtype) for name, column in columns.items()])
    for name, column in columns.items():
        joined[name] = column
    joined.flags.writeable = False
    return joined


def trajectory(
    source: Union[Result, ExperimentLike],
    *,
    condition: int = 0,
    realisation: int = 0,
    periods: Optional[int] = None,
    samples: int = 0,
    seed: Union[int, str, None] = None,
) -> Trajectory:
    """Simulate one realisation and return its states and events.

    source: an experiment; or a Result or the folder of a run, whose realisation is checked against its digest. periods:
    excitation periods; default: all of the horizon. samples: states of the history in a period; 0: none. seed: replaces
    that of an experiment. Raises InputError if there is no such condition or realisation or a number is out of range, and
    DifferentBits if a realisation of a run has another result now.

    >>> import rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0}, "restitution": 0.9}
    >>> motion = rocking.trajectory(slab, periods=3)
    >>> motion.strobe["period"]
    array([1, 2, 3])
    >>> rocking.EVENTS[motion.events["kind"][0]]
    'lift'
    """
    extent = (condition, realisation, periods, samples)
    run = open_run(source) if isinstance(source, (str, os.PathLike)) and os.path.isdir(source) else source
    if not isinstance(run, Result):
        return Trajectory(_core.trajectory(experiment(run, seed=seed)._core, *extent), condition, realisation)
    if seed is not None:
        raise TypeError("seed replaces that of an experiment, not of a run")
    return Trajectory(_core.replay(run.experiment._core, run._core, *extent), condition, realisation)
