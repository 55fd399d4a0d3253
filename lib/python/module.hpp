#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <pybind11/pybind11.h>

#include "rocking/rocking.hpp"

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

/// A hazard curve as Python gives it: name, text (none: of the file of this name), years, measure, site, statistic.
using GivenHazard = std::tuple<std::string, std::optional<std::string>, std::optional<double>,
                               std::optional<std::string>, std::vector<double>, std::optional<std::string>>;
[[nodiscard]] std::optional<HazardCurve> curve_of(const std::optional<GivenHazard>& given);

/// Studies of experiments, of recorded ground motions and of random numbers.
void add_studies(pybind11::module_& module);

}  // namespace rocking::python
