"""Builds the Python module with CMake.

ROCKING_BUILD_FOLDER names a configured build folder, in which it is then built; what that folder installs of the program
goes into the wheel, too. By default the module is built in a folder of its own, for the library of the same revision where
one is installed (CMAKE_PREFIX_PATH names its prefix). CMAKE_ARGS, separated by blanks, go to CMake, for example
-DROCKING_ARCHITECTURE=x86-64.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

TOP = Path(__file__).resolve().parent
BUILD_FOLDER = os.environ.get("ROCKING_BUILD_FOLDER")


def version():
    return re.search(r"project\(rocking VERSION (\S+)", (TOP / "CMakeLists.txt").read_text())[1]


def program():
    """Folders of a prefix, each with the files that the build folder installs there, without the library in C++."""
    if BUILD_FOLDER is None:
        return []
    prefix = Path(BUILD_FOLDER) / "wheel/prefix"
    shutil.rmtree(prefix.parent, ignore_errors=True)
    command = ["cmake", "--install", BUILD_FOLDER, "--prefix", prefix, "--strip"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    folders = {}
    for file in [prefix / "bin/rocking", *(prefix / "share").rglob("*")]:
        if file.is_file():
            folders.setdefault(str(file.parent.relative_to(prefix)), []).append(str(file))
    return list(folders.items())


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        target = Path(self.get_ext_fullpath(extension.name)).resolve()
        target.parent.mkdir(parents=True, exist_ok=True)
        folder = BUILD_FOLDER
        if folder is None:
            folder = Path(self.build_temp).resolve()
            options = ["PROGRAM", "TESTS", "INSTALL"]
            command = ["cmake", "-S", TOP, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON"]
            command += [f"-DROCKING_{option}=OFF" for option in options]
            command += ["-DROCKING_USE_INSTALLED=ON", "-DROCKING_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}"]
            subprocess.run(command + os.environ.get("CMAKE_ARGS", "").split(), check=True)
        jobs = str(self.parallel or os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", folder, "--target", "rocking_python", "-j", jobs], check=True)
        package = Path(folder) / "python/rocking"
        (built,) = package.glob("_core*.so")
        subprocess.run(["strip", "-o", target, built], check=True)
        for made in ("documents.py", "studies.py"):
            shutil.copyfile(package / made, target.parent / made)


(TOP / "build").mkdir(exist_ok=True)
options = {"egg_info": {"egg_base": "build"}}
if BUILD_FOLDER is not None:
    options["build"] = {"build_base": f"{BUILD_FOLDER}/wheel"}
setup(
    version=version(),
    ext_modules=[Extension("rocking._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    data_files=program(),
    options=options,
)
