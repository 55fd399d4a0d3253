#pragma once

#include <pybind11/pybind11.h>

/// Parts of the module rocking._core.
namespace rocking::python {

/// Trajectories as structured arrays.
void add_arrays(pybind11::module_& module);

/// Runs, which Ctrl-C stops, and their results.
void add_runs(pybind11::module_& module);

}  // namespace rocking::python
