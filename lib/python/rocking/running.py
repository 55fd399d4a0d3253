"""Runs."""

from __future__ import annotations

import datetime
import json
import os
import platform
import time
from typing import Any, Callable, List, Mapping, Optional, Sequence, Tuple, Union

from . import _core
from .errors import Interrupted
from .experiments import Experiment, ExperimentLike, experiment
from .fields import interface
from .results import Result

__all__ = ["Plan", "Progress", "open_run", "plan", "resume", "run", "show_progress"]

Progress = Callable[[int, int], object]


def show_progress(done: int, all: int) -> None:
    """A bar in a terminal or a notebook, as ``progress=rocking.show_progress``. It ends its line when all is done.

    >>> import rocking
    >>> rocking.show_progress(3, 4); rocking.show_progress(4, 4)  # doctest: +NORMALIZE_WHITESPACE
    [###############     ] 3 of 4 [####################] 4 of 4
    """
    width = 20
    full = width * done // all if all else 0
    print(f"\r[{'#' * full}{' ' * (width - full)}] {done} of {all}", end="\n" if done == all else "", flush=True)


def processors() -> int:
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def now() -> str:
    """This instant, as reports write it."""
    return datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")


def run(
    source: ExperimentLike,
    *,
    seed: Union[int, str, None] = None,
    realisations: Optional[int] = None,
    threads: Optional[int] = None,
    folder: Union[str, "os.PathLike[str]", None] = None,
    skip_unreadable: bool = False,
    shard: Optional[Tuple[int, int]] = None,
    max_time: Optional[float] = None,
    repair: bool = False,
    progress: Optional[Progress] = None,
) -> Result:
    """Simulate all realisations of an experiment and estimate the probability of each response.

    source: a dictionary as in an experiment file, the path of one, or an Experiment.

    seed, realisations: replace those of the source.

    threads: default: one for each processor. Changes the time, never the result.

    folder: keeps the realisations in ``folder/realisations.sqlite``, as the program does; a run that was stopped goes
    on there, and one of fewer realisations is extended, unless its report is there. Default: in memory.

    skip_unreadable: leave out records of a suite that cannot be read; the report names them.

    shard: (i, n) runs the i-th of n parts, from 1; resume() joins their folders. The Result of a part has counts and no
    estimates.

    max_time: stop cleanly after this time [s]. The Result then has what is done; with ``folder``, resume() goes on.

    repair: keep the intact realisations of a damaged store, and run the others again; ``damaged_file`` of the Result is
    where the damaged store is now. Otherwise it raises StoreError.

    progress: called now and then with (finished realisations, all).

    Ctrl-C raises Interrupted, a KeyboardInterrupt with what is done. An exception of ``progress`` stops the run and is
    passed on. Raises InputError with all problems of the experiment, and OSError where a file cannot be used. Other
    Python threads go on meanwhile.

    >>> import rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 20, "sampled_periods": 20}, "realisations": 10, "seed": "0x1"}
    >>> result = rocking.run(slab)
    >>> int(result.counts.sum())
    10
    >>> result.digest == rocking.run(slab, threads=1).digest
    True
    """
    checked = experiment(source, seed=seed, realisations=realisations, skip_unreadable=skip_unreadable)
    asked = _asked(threads)
    where = None if folder is None else os.fspath(folder)
    start, began = now(), time.perf_counter()
    core, interrupted = _core.run(
        checked._core, asked, where or "", checked._files, shard, repair, _limit(max_time), progress
    )
    provenance = (platform.platform(), start, time.perf_counter() - began, asked)
    return _finished(Result(checked, core, provenance, where), interrupted)


def _asked(threads: Optional[int]) -> int:
    if threads is not None and threads < 1:
        raise ValueError(f"threads = {threads}: must be at least 1")
    return processors() if threads is None else threads


def _limit(max_time: Optional[float]) -> Optional[float]:
    if max_time is not None and not max_time > 0:
        raise ValueError(f"max_time = {max_time}: must be above 0 [s]")
    return max_time


def _finished(result: Result, interrupted: bool) -> Result:
    if interrupted and result.done < result.all:
        raise Interrupted(result)
    if interrupted:
        raise KeyboardInterrupt
    return result


class Plan:
    """What a run would do, before it starts."""

    def __init__(self, text: str, data: Mapping[str, Any]) -> None:
        self.text = text  #: in words, as ``rocking run --dry-run`` prints it
        self.data = data  #: as with ``--json``
        self.conditions: int = data["conditions"]
        self.realisations: int = data["realisations"]  #: of all conditions; with ``until`` the largest number
        self.periods: int = data["periods"]  #: of all realisations together
        self.disk_bytes: int = data["disk_bytes"]
        self.memory_bytes: int = data["memory_bytes"]
        self.effects: List[str] = list(data["effects"])  #: what is on beside rocking
        self.seconds: Optional[float] = data.get("seconds")  #: estimate of the time; None where it was not measured

    __dir__ = interface

    def __repr__(self) -> str:
        return f"<rocking.Plan of {self.realisations} realisations of {self.conditions} condition(s)>"


def plan(
    source: ExperimentLike,
    *,
    seed: Union[int, str, None] = None,
    realisations: Optional[int] = None,
    threads: Optional[int] = None,
    skip_unreadable: bool = False,
    shard: Optional[Tuple[int, int]] = None,
    timed: bool = True,
) -> Plan:
    """What run() would do with these arguments: sizes, disk space, memory, time. Writes nothing.

    timed: estimate the time from a sample of the realisations, which takes at most two seconds. Raises InputError with all
    problems of the experiment.

    >>> import rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 20, "sampled_periods": 20}, "realisations": 10, "seed": "0x1"}
    >>> rocking.plan(slab, timed=False).periods
    400
    """
    checked = experiment(source, seed=seed, realisations=realisations, skip_unreadable=skip_unreadable)
    words, text = _core.plan(checked._core, _asked(threads), shard, timed)
    return Plan(words, json.loads(text))


def open_run(folder: Union[str, "os.PathLike[str]"]) -> Result:
    """The run in a folder that ``run(folder=...)`` or the program has filled; it need not be complete.

    A run that is in progress can be looked at: ``done`` is what is stored so far. Raises OSError if there is none,
    StoreError if it is damaged.

    >>> import tempfile, rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 5, "sampled_periods": 15}, "realisations": 10, "seed": "0x1"}
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     digest = rocking.run(slab, folder=folder).digest
    ...     rocking.open_run(folder).digest == digest
    True
    """
    return _stored(os.fspath(folder), *_core.open_run(os.fspath(folder)))


def _stored(folder: str, experiment: _core.Experiment, core: _core.Run) -> Result:
    return Result(Experiment(experiment, folder), core, (platform.platform(), "1970-01-01T00:00:00Z", 0.0, 1), folder)


def resume(
    folder: Union[str, "os.PathLike[str]"],
    shards: Sequence[Union[str, "os.PathLike[str]"]] = (),
    *,
    realisations: Optional[int] = None,
    levels: Sequence[float] = (),
    threads: Optional[int] = None,
    max_time: Optional[float] = None,
    progress: Optional[Progress] = None,
) -> Result:
    """Finish a run that was stopped, extend one, or join its shards. The result has the bits of one run.

    folder: of the run, or for the whole of the shards; that has no run yet. shards: folders that
    ``run(shard=..., folder=...)`` or the program has filled; they may overlap if their common realisations agree. While
    realisations are missing, the Result is not complete. The others are not for shards. realisations: extend the run,
    finished or not, to as many per condition. levels: extend it by these intensities. max_time: stop cleanly after this
    time [s].

    An extended run replaces a complete one when it is complete itself, and its report.json is then gone. A damaged store
    is mended. Raises InputError if the shards are not of one experiment or contradict each other, and nothing is kept then;
    OSError if there is no run, or it cannot be extended so; StoreError as open_run(); Interrupted as run().

    >>> import os, tempfile, rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 20, "sampled_periods": 20}, "realisations": 10, "seed": "0x1"}
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     parts = [os.path.join(folder, str(i)) for i in (1, 2)]
    ...     for i, part in enumerate(parts, 1):
    ...         part_of_it = rocking.run(slab, shard=(i, 2), folder=part)
    ...     whole = rocking.resume(os.path.join(folder, "whole"), parts)
    ...     longer = rocking.resume(os.path.join(folder, "whole"), realisations=20)
    >>> whole.digest == rocking.run(slab).digest, longer.digest == rocking.run(slab, realisations=20).digest
    (True, True)
    """
    where = os.fspath(folder)
    if isinstance(shards, (str, os.PathLike)):
        raise TypeError("shards: give a list of folders")
    if shards:
        if realisations is not None or len(levels) or threads is not None or max_time is not None:
            raise TypeError("realisations, levels, threads and max_time are not for shards: join them first")
        return _stored(where, *_core.merge(where, [os.fspath(part) for part in shards]))
    number = None if realisations is None else str(realisations)
    further = [float(level) for level in levels]
    experiment, core, interrupted = _core.resume(where, number, further, _asked(threads), _limit(max_time), progress)
    return _finished(_stored(where, experiment, core), interrupted)
