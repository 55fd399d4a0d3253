"""Pages, figures and tables."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

from . import _core
from .experiments import ExperimentLike, experiment
from .fields import Document, interface
from .hazards import asked_hazard
from .results import Result
from .running import open_run, processors
from .tables import Given, told_by_row
from .trajectories import Trajectory

__all__ = ["Written", "draw", "write_figures", "write_page", "write_sheet", "write_tables", "write_trajectory_page"]

_Path = Union[str, "os.PathLike[str]"]
_COLUMNS: Dict[Tuple[str, Optional[str]], int] = {  # numbers of the core, by style and width
    ("screen", None): 0,
    ("journal", None): 1,
    ("journal", "single"): 1,
    ("journal", "double"): 2,
}


class Written(NamedTuple):
    """What was written."""

    files: List[Path]
    not_drawn: List[str]  #: reasons why pictures are missing: gnuplot is not installed, or failed

    __dir__ = interface


def write_page(
    source: Union[Result, _Path],
    file: _Path,
    *,
    hazard: Optional[Given] = None,
    years: Optional[float] = None,
    imt: Optional[str] = None,
    site: Sequence[float] = (),
    statistic: Optional[str] = None,
) -> Written:
    """Write the page of a complete run: one HTML file without external resources, as the program's ``report.html``.

    source: a Result, or the folder of a run. hazard, years, imt, site, statistic: a hazard curve, as of hazard(); the page
    of a suite then tells its annual rates. Runs gnuplot for the pictures; without it the page has none for printing,
    and ``not_drawn`` says so. Raises ValueError if the run is not complete, OSError where the file cannot be written.

    >>> import os, tempfile, rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 20, "sampled_periods": 20}}
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     written = rocking.write_page(rocking.run(slab), os.path.join(folder, "report.html"))
    >>> [file.name for file in written.files]
    ['report.html']
    """
    result = _complete(source)
    where = os.fspath(file)
    with told_by_row(["hazard"]):
        curve = None if hazard is None else asked_hazard(hazard, years, imt, site, statistic)
        return _call("write_page", result.experiment._core, result._core, where, *result._provenance, curve)


def write_figures(
    source: Union[Result, _Path],
    folder: _Path,
    *,
    style: str = "screen",
    width: Optional[str] = None,
    pictures: Sequence[str] = (),
    hazard: Optional[Given] = None,
    years: Optional[float] = None,
    imt: Optional[str] = None,
    site: Sequence[float] = (),
    statistic: Optional[str] = None,
) -> Written:
    """Draw the figures of a complete run in a folder: numbers (tsv) and pictures.

    source: a Result, or the folder of a run. style: ``screen`` or ``journal`` (8 points, no titles). width: of the column
    of a journal, ``single`` (84 mm) or ``double`` (174 mm). pictures: of ``svg``, ``png``, ``pdf`` and ``gp``, gnuplot's
    script; default: svg, or pdf for a journal. hazard, years, imt, site, statistic, errors: as write_page(). Raises
    InputError for another kind of picture.

    >>> import tempfile, rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 5, "sampled_periods": 15}, "realisations": 10, "seed": "0x1"}
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     written = rocking.write_figures(rocking.run(slab), folder, style="journal", pictures=["gp"])
    >>> "scene.gp" in [file.name for file in written.files]
    True
    """
    result = _complete(source)
    with told_by_row(["hazard"]):
        curve = None if hazard is None else asked_hazard(hazard, years, imt, site, statistic)
        cores = result.experiment._core, result._core
        return _call("write_figures", *cores, os.fspath(folder), _number_of(style, width), list(pictures), curve)


def write_sheet(
    source: Union[Result, _Path],
    file: _Path,
    *,
    hazard: Given,
    years: Optional[float] = None,
    imt: Optional[str] = None,
    site: Sequence[float] = (),
    statistic: Optional[str] = None,
    project: str = "",
    date: str = "",
) -> Written:
    """Write the answer about a suite of ground motions as one page of A4, as ``rocking fragility --sheet`` does.

    source: a Result, or the folder of a run. file: ends with ``.html`` or ``.pdf``; the latter needs WeasyPrint, without
    which no file is written and ``not_drawn`` says so. hazard, years, imt, site, statistic: a hazard curve, as of
    hazard(). project, date: stated on the sheet, which otherwise has lines to write them on. Raises InputError if the run
    has no suite, otherwise errors as write_page().

    >>> import json, math, os, tempfile, rocking
    >>> suite = {"format": "rocking.experiment/1", "block": {"width_m": 0.35, "height_m": 1.6},
    ...     "excitation": {"kind": "recorded", "suite": "*.txt", "format": "columns", "units": "m/s2"},
    ...     "sweep": [{"parameter": "/excitation/pga_g", "values": [0.3, 0.6, 0.9]}]}
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     files = {f"{k}.txt": "".join(f"{0.02 * i} {math.sin(0.04 * k * i)}\\n" for i in range(200)) for k in (2, 3, 4)}
    ...     files |= {"hazard.csv": "pga_g, annual_rate\\n0.1, 1e-2\\n2, 1e-5\\n", "suite.json": json.dumps(suite)}
    ...     for name, text in files.items():
    ...         with open(os.path.join(folder, name), "w") as file:
    ...             _ = file.write(text)
    ...     result = rocking.run(os.path.join(folder, "suite.json"))
    ...     sheet, hazard = os.path.join(folder, "sheet.html"), os.path.join(folder, "hazard.csv")
    ...     [path.name for path in rocking.write_sheet(result, sheet, hazard=hazard).files]
    ['sheet.html']
    """
    result = _complete(source)
    with told_by_row(["hazard"]):
        curve = asked_hazard(hazard, years, imt, site, statistic)
        cores = result.experiment._core, result._core
        return _call("write_sheet", *cores, os.fspath(file), project, date, processors(), curve)


def write_tables(source: Union[Result, _Path], folder: _Path) -> Written:
    """Write the tables of a complete run in CSV and LaTeX: modes.csv, modes.tex, non_recurrence.csv and others.

    source: a Result, or the folder of a run. Errors as write_page().

    >>> import tempfile, rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
    ...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
    ...     "horizon": {"transient_periods": 5, "sampled_periods": 15}, "realisations": 10, "seed": "0x1"}
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     [file.name for file in rocking.write_tables(rocking.run(slab), folder).files]
    ['modes.csv', 'modes.tex', 'non_recurrence.csv', 'quantiles.csv']
    """
    result = _complete(source)
    return _call("write_tables", result.experiment._core, result._core, os.fspath(folder))


def write_trajectory_page(
    source: ExperimentLike,
    file: _Path,
    *,
    condition: int = 0,
    realisation: int = 0,
    periods: Optional[int] = None,
    samples: Optional[int] = None,
    seed: Union[int, str, None] = None,
) -> Path:
    """Write the page of one realisation, in which the block moves: as ``rocking trajectory --html``. Returns the file.

    periods: excitation periods; default: all of the horizon. samples: in a period; default: as many as the eye needs.
    Raises InputError as trajectory(), and if the block overturns before two samples; OSError where the file cannot be
    written.

    >>> import os, tempfile, rocking
    >>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    ...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0}, "restitution": 0.9}
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     rocking.write_trajectory_page(slab, os.path.join(folder, "motion.html"), periods=5).stat().st_size > 1000
    True
    """
    if samples is not None and samples < 1:
        raise ValueError(f"samples = {samples}: must be at least 1")
    checked = experiment(source, seed=seed)
    extent = (condition, realisation, periods, samples or 0)
    return _call("write_trajectory_page", checked._core, *extent, os.fspath(file)).files[0]


def draw(
    *sources: Any,
    folder: _Path,
    from_: float = 0,
    to: Optional[float] = None,
    style: str = "screen",
    width: Optional[str] = None,
    pictures: Sequence[str] = (),
) -> Written:
    """Draw what a study has found, in a folder: as ``rocking report`` draws what the program printed.

    sources: results of trajectory() with ``samples``, bifurcation(), orbits() with branches, threshold() over another
    number, cost(), fragility(), rare(), infer(), motion() with ``series``, check_normal(), or paths of files that the program wrote. from_, to: the first
    and the last excitation period of trajectories that is shown. style, width, pictures: as write_figures(). Raises InputError for a source that is
    none of these.

    >>> import tempfile, rocking
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     written = rocking.draw(rocking.check_normal(100), folder=folder)
    >>> "normal_histogram.tsv" in [file.name for file in written.files]
    True
    """
    texts = [_document_of(source, number) for number, source in enumerate(sources)]
    return _call("draw", texts, os.fspath(folder), _number_of(style, width), list(pictures), float(from_), to)


def _complete(source: Union[Result, _Path]) -> Result:
    result = source if isinstance(source, Result) else open_run(source)
    result._expect_complete()
    return result


def _number_of(style: str, width: Optional[str]) -> int:
    if (style, width) not in _COLUMNS:
        raise ValueError(f"style = {style!r}, width = {width!r}: must be screen; or journal, single or double")
    return _COLUMNS[style, width]


def _document_of(source: Any, number: int) -> Tuple[str, str]:
    if isinstance(source, (str, os.PathLike)):
        path = os.fspath(source)
        with open(path, encoding="utf-8") as file:
            return path, file.read()
    if isinstance(source, Trajectory):
        return f"source {number}", source.text()
    if isinstance(source, Document):
        return f"source {number}", source.json
    raise TypeError(f"source {number} is a {type(source).__name__}: must be what a study returned, or a file")


def _call(name: str, *arguments: Any) -> Written:
    function = getattr(_core, name, None)
    if function is None:
        raise NotImplementedError(f"{name}: this module was built without fmt (Debian: libfmt-dev)")
    files, not_drawn = function(*arguments)
    return Written([Path(file) for file in files], not_drawn)
