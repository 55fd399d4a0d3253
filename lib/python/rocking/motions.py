"""Ground motions and their intensity measures."""

from __future__ import annotations

import os
from typing import Optional, Sequence, Tuple, Union

from . import _core, documents

__all__ = ["motion"]

_Path = Union[str, "os.PathLike[str]"]


def motion(
    files: Union[_Path, Sequence[_Path]],
    *,
    vertical: Optional[_Path] = None,
    format: str = "auto",
    units: Optional[str] = None,
    time_step: Optional[float] = None,
    columns: Sequence[str] = (),
    gravity: float = 9.81,
    damping: float = 0.05,
    periods: Sequence[float] = (0.1, 0.2, 0.3, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 5.0),
    block: Optional[Tuple[float, float]] = None,
    series: bool = False,
) -> documents.GroundMotions:
    """Read ground motions: what was read of each file, and its intensity measures.

    vertical: file with the vertical component of a single file. format: ``auto``, ``columns``, ``peer_at2``,
    ``esm_asc``. units: ``g``, ``m/s2``, ``cm/s2``, ``mm/s2``, ``mg``, ``%g``, ``ft/s2``, ``in/s2``; by default those of
    the file, or m/s2. time_step: of columns without times [s]. columns: what the columns of a file
    of numbers are, each ``time``, ``horizontal``, ``vertical`` or ``other``; needed where there are more than a time and
    an acceleration, or a header. gravity: what 1 g is [m/s^2]. damping, periods [s]: of the
    response spectrum. block: width and height [m] of a block whose least scale of uplift is wanted. series: also the
    motions sample by sample, which draw() needs. Raises InputError with file, line and value of each fault.

    >>> import os, rocking, tempfile
    >>> path = os.path.join(tempfile.mkdtemp(), "pulse.txt")
    >>> with open(path, "w") as file:
    ...     _ = file.write("0 0\\n0.5 4.905\\n1 0\\n")
    >>> record = rocking.motion(path, units="m/s2", block=(1.0, 4.0)).motions[0]
    >>> record.pga_g, record.uplift_scale
    (0.5, 0.5)
    """
    names = [files] if isinstance(files, (str, os.PathLike)) else list(files)
    if block is not None:
        width, height = block
        block = (float(width), float(height))
    text = _core.motion(
        [os.fspath(name) for name in names],
        None if vertical is None else os.fspath(vertical),
        format,
        units,
        None if time_step is None else float(time_step),
        list(columns),
        float(gravity),
        float(damping),
        [float(period) for period in periods],
        bool(series),
        block,
    )
    return documents.GroundMotions(text)
