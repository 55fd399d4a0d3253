#pragma once

#include <pybind11/pybind11.h>

/// Parts of the module rocking._core.
namespace rocking::python {

/// Trajectories as structured arrays.
void add_arrays(pybind11::module_& module);

/// Checks of runs and of the machine.
void add_checks(pybind11::module_& module);

/// Pages and figures, in a library that has them (ROCKING_HAS_PAGES).
void add_pages(pybind11::module_& module);

/// Runs, which Ctrl-C stops, and their results.
void add_runs(pybind11::module_& module);

/// Studies of experiments, of recorded ground motions and of random numbers.
void add_studies(pybind11::module_& module);

}  // namespace rocking::python
