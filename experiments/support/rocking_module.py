"""The Python module `rocking` for the scripts of experiments/: `from rocking_module import rocking`.

The one that is installed or on PYTHONPATH, else that of build/release. Without it the script ends and says how to build
it."""

import importlib
import sys
from pathlib import Path

_TOP = Path(__file__).resolve().parents[2]
_BUILT = _TOP / "build/release/python"


def _loaded():
    module = importlib.import_module("rocking")
    for name in ("clopper_pearson", "wilson", "colour"):
        getattr(module, name)  # an older module, or another one of this name, lacks them
    return module


def _module():
    try:
        return _loaded()
    except (ImportError, AttributeError) as error:
        reason = error
    for name in [name for name in sys.modules if name.split(".")[0] == "rocking"]:
        del sys.modules[name]
    if (_BUILT / "rocking").is_dir():
        sys.path.insert(0, str(_BUILT))
        try:
            return _loaded()
        except (ImportError, AttributeError) as error:
            reason = error
    sys.exit(
        f"{sys.argv[0]}: needs the Python module `rocking`, which {sys.executable} cannot load "
        f"({reason.__cause__ or reason}). To build it in {_TOP}, with Debian's python3-dev, pybind11-dev and python3-numpy:\n"
        "    cmake --preset release && cmake --build build/release --target rocking_python\n"
        "Then run this script with the Python for which it was built: build/release/python/python3")


rocking = _module()
