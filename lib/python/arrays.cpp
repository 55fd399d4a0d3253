#include <memory>

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

py::dict peaks_of(const PeakValues& peaks) {
  py::dict dict;
  dict["tilt"] = peaks.tilt;
  dict["tilt_rate"] = peaks.tilt_rate;
  dict["slip"] = peaks.slip;
  dict["slip_m"] = peaks.slip_m;
  dict["final_slip"] = peaks.final_slip;
  dict["final_slip_m"] = peaks.final_slip_m;
  return dict;
}

py::dict energy_of(const EnergyAccount& energy) {
  py::dict dict;
  dict["at_start"] = energy.at_start;
  dict["at_end"] = energy.at_end;
  dict["base_work"] = energy.base_work;
  dict["friction_work"] = energy.friction_work;
  dict["lost_in_impacts"] = energy.lost_in_impacts;
  dict["gained_in_impacts"] = energy.gained_in_impacts;
  dict["unaccounted"] = energy.unaccounted();
  return dict;
}

py::dict block_of(const dynamics::Block& block) {
  const dynamics::Geometry geometry = dynamics::geometry_of(block);
  py::dict dict;
  dict["width_m"] = block.width;
  dict["height_m"] = block.height;
  dict["gravity_m_s2"] = block.gravity;
  dict["shape_angle_rad"] = geometry.shape_angle;
  dict["half_diagonal_m"] = geometry.half_diagonal;
  dict["frequency_parameter_rad_s"] = geometry.frequency_parameter;
  return dict;
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
      .def_readonly("losses_of_contact", &Trajectory::losses_of_contact)
      .def_readonly("first_loss_of_contact", &Trajectory::first_loss_of_contact)
      .def_readonly("contradictions", &Trajectory::contradictions)
      .def_property_readonly("block", [](const Trajectory& trajectory) { return block_of(trajectory.block); })
      .def_property_readonly("peaks", [](const Trajectory& trajectory) { return peaks_of(trajectory.peaks); })
      .def_property_readonly("energy", [](const Trajectory& trajectory) { return energy_of(trajectory.energy); })
      .def_property_readonly("termination", [](const Trajectory& trajectory) {
        return std::string(dynamics::to_string(trajectory.termination));
      });
  // (trajectory or None, whether Ctrl-C stopped it)
  module.def("trajectory", [](const Experiment& experiment, std::uint64_t condition, std::uint64_t realisation,
                              std::int64_t periods, int samples) {
    return watched_trajectory([&](const Execution& execution) {
      return trajectory(
          experiment,
          {.condition = condition, .realisation = realisation, .periods = periods, .samples_per_period = samples},
          execution);
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
