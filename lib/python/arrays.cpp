#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "module.hpp"
#include "rocking/rocking.hpp"
#include "watched.hpp"

namespace rocking::python {
namespace {

namespace py = pybind11;

/// An array over the rows of a trajectory, without a copy; `owner` keeps them alive. Read only.
template <class Row>
py::array rows(const std::vector<Row>& rows, const py::object& owner) {
  py::array array(py::dtype::of<Row>(), {rows.size()}, {sizeof(Row)}, rows.data(), owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// JSON text of the trajectory without its states and events.
std::string facts_of(const Trajectory& trajectory, std::uint64_t condition, std::uint64_t realisation) {
  Trajectory facts = trajectory;
  facts.strobe.clear();
  facts.events.clear();
  facts.history.clear();
  return trajectory_text({.condition = condition, .realisation = realisation}, facts, TrajectoryUnits::normalised);
}

}  // namespace

void add_arrays(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(TrajectorySample, period, tilt, tilt_rate, slip, slip_rate, contact);
  PYBIND11_NUMPY_DTYPE(TrajectoryEvent, tau, kind, tilt, tilt_rate, slip, slip_rate);
  PYBIND11_NUMPY_DTYPE(HistorySample, tau, tilt, tilt_rate, slip, slip_rate, contact, base_acceleration);
  py::class_<Trajectory, std::shared_ptr<Trajectory>>(module, "Trajectory")
      .def_property_readonly("strobe",
                             [](const py::object& self) { return rows(self.cast<const Trajectory&>().strobe, self); })
      .def_property_readonly("events",
                             [](const py::object& self) { return rows(self.cast<const Trajectory&>().events, self); })
      .def_property_readonly("history",
                             [](const py::object& self) { return rows(self.cast<const Trajectory&>().history, self); })
      .def_readonly("period_length", &Trajectory::period_length)
      .def("facts", &facts_of);
  module.def("trajectory", [](const Experiment& experiment, std::uint64_t condition, std::uint64_t realisation,
                              std::optional<std::int64_t> periods, int samples) {
    return watch(1, py::none(), [&](const Execution& execution) {
      const TrajectoryRequest request{
          .condition = condition, .realisation = realisation, .periods = periods, .samples_per_period = samples};
      return std::make_shared<Trajectory>(trajectory(experiment, request, execution));
    });
  });
  module.def(
      "trajectory_text",
      [](const Trajectory& trajectory, std::uint64_t condition, std::uint64_t realisation, bool si, bool as_table) {
        const TrajectoryRequest request{.condition = condition, .realisation = realisation};
        const TrajectoryUnits units = si ? TrajectoryUnits::si : TrajectoryUnits::normalised;
        return as_table ? trajectory_csv(request, trajectory, units) : trajectory_text(request, trajectory, units);
      },
      py::call_guard<py::gil_scoped_release>());
}

}  // namespace rocking::python
