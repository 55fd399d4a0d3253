"""Ground motions and their intensity measures."""

from __future__ import annotations

import json
import os
from typing import Any, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from .findings import Findings

__all__ = ["GroundMotion", "motion"]

_SPECTRUM = np.dtype([(name, float) for name in ("period_s", "sa_g", "sv_m_s", "sd_m", "psa_g", "psv_m_s")])


class GroundMotion:
    """A file with recorded accelerations: what was read, and its intensity measures."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.data: Mapping[str, Any] = data  #: as in ``rocking.motion/1``
        self.file: str = data["file"]
        self.format: str = data["format"]  #: ``columns``, ``peer_at2``, ``esm_asc``
        self.unit: str = data["unit"]  #: of the file
        self.samples: int = data["samples"]
        self.time_step_s: Optional[float] = data["time_step_s"]  #: None where it is not even
        self.duration_s: float = data["duration_s"]
        self.warnings: List[str] = data["warnings"]
        self.pga_g: float = data["pga_g"]  #: largest acceleration
        self.pgv_m_s: float = data["pgv_m_s"]  #: largest velocity
        self.pgd_m: float = data["pgd_m"]  #: largest displacement
        self.arias_m_s: float = data["arias_m_s"]  #: Arias intensity
        self.cav_m_s: float = data["cav_m_s"]  #: cumulative absolute velocity
        self.significant_duration_s: float = data["significant_duration_s"]  #: 5 to 95 % of the Arias intensity
        #: least scale at which the block rocks; None without a block, or where no scale lifts it
        self.uplift_scale: Optional[float] = data.get("uplift_scale")
        #: response spectrum: acceleration (absolute), velocity and displacement (relative), pseudo-spectra
        self.spectrum: np.ndarray = np.array(
            [tuple(point[name] for name in _SPECTRUM.names) for point in data["spectrum"]], dtype=_SPECTRUM
        )

    def __repr__(self) -> str:
        return f"<rocking.GroundMotion {self.file!r}, PGA {self.pga_g:.4g} g>"


def motion(
    files: Union[str, os.PathLike, Sequence[Union[str, os.PathLike]]],
    *,
    vertical: Union[str, os.PathLike] = "",
    format: str = "auto",
    units: str = "",
    time_step: float = 0.0,
    gravity: float = 9.81,
    damping: float = 0.05,
    periods: Sequence[float] = (0.1, 0.2, 0.3, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 5.0),
    block: Optional[Tuple[float, float]] = None,
    series: bool = False,
) -> Findings[GroundMotion]:
    """Read ground motions; a GroundMotion for each file.

    vertical: file with the vertical component of a single file. format: ``auto``, ``columns``, ``peer_at2``,
    ``esm_asc``. units: ``g``, ``m/s2``, ``cm/s2``, ``mm/s2``, ``mg``, ``%g``, ``ft/s2``, ``in/s2``; by default those of
    the file, or m/s2. time_step: of columns without times [s]. gravity: what 1 g is [m/s^2]. damping, periods [s]: of the response spectrum. block: width and height [m]
    of a block whose least scale of uplift is wanted. series: also the motions sample by sample, in ``data`` of the list,
    which draw() needs. Raises InputError with file, line and value of each fault.

    >>> import os, rocking, tempfile
    >>> path = os.path.join(tempfile.mkdtemp(), "pulse.txt")
    >>> with open(path, "w") as file:
    ...     _ = file.write("0 0\\n0.5 4.905\\n1 0\\n")
    >>> record = rocking.motion(path, units="m/s2", block=(1.0, 4.0))[0]
    >>> record.pga_g, record.uplift_scale
    (0.5, 0.5)
    """
    names = [files] if isinstance(files, (str, os.PathLike)) else list(files)
    if block is not None:
        width, height = block
        block = (float(width), float(height))
    text = _core.motion(
        [os.fspath(name) for name in names],
        os.fspath(vertical),
        format,
        units,
        float(time_step),
        float(gravity),
        float(damping),
        [float(period) for period in periods],
        bool(series),
        block,
    )
    data = json.loads(text)
    return Findings([GroundMotion(found) for found in data["motions"]], data)
