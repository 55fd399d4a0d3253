#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
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

/// Times and states in SI units: of strobe points, events and history.
py::tuple arrays_in_si(const Trajectory& trajectory) {
  const TrajectoryInSi rows = in_si(trajectory);
  const auto array = [](const std::vector<StateInSi>& states) {
    return py::array_t<StateInSi>(static_cast<py::ssize_t>(states.size()), states.data());
  };
  return py::make_tuple(array(rows.strobe), array(rows.events), array(rows.history));
}

/// JSON text of the trajectory without its states and events.
std::string facts_of(const Trajectory& trajectory, std::uint64_t condition, std::uint64_t realisation) {
  Trajectory facts = trajectory;
  facts.strobe.clear();
  facts.events.clear();
  facts.history.clear();
  return trajectory_text({.condition = condition, .realisation = realisation}, facts, TrajectoryUnits::normalised);
}

/// Calls use(member) for each member of a trajectory, and of its outline; one that is not named here does not compile.
template <class Kept, class Use>
void for_each_member(Kept& trajectory, Use&& use) {
  auto& [block, outline, period, strobe, events, history, samples, losses, first_loss, before_fall, peaks, sides,
         contradictions, energy, termination, label] = trajectory;
  auto& [rectangles, base, centre_x, centre_height, is_given, open_side] = outline;
  const auto each = [&use](auto&... members) { (use(members), ...); };
  each(block, rectangles, base, centre_x, centre_height, is_given, open_side, period, strobe, events, history, samples,
       losses, first_loss, before_fall, peaks, sides, contradictions, energy, termination, label);
}

template <class Value>
constexpr bool is_list = false;
template <class Row>
constexpr bool is_list<std::vector<Row>> = true;

/// What pickle keeps: the version, and the bytes of each member.
py::tuple state_of(const Trajectory& trajectory) {
  py::list state;
  state.append(version());
  for_each_member(trajectory, [&state]<class Member>(const Member& member) {
    if constexpr (is_list<Member>) {
      state.append(
          py::bytes(reinterpret_cast<const char*>(member.data()), member.size() * sizeof(typename Member::value_type)));
    } else {
      static_assert(std::is_trivially_copyable_v<Member>);
      state.append(py::bytes(reinterpret_cast<const char*>(&member), sizeof(Member)));
    }
  });
  return py::tuple(state);
}

std::shared_ptr<Trajectory> trajectory_of_state(const py::tuple& state) {
  auto trajectory = std::make_shared<Trajectory>();
  std::size_t next = 0;
  const auto refuse = [] { throw py::value_error("the trajectory was pickled by another version of rocking"); };
  if (state.empty() || state[next++].cast<std::string>() != version()) refuse();
  for_each_member(*trajectory, [&]<class Member>(Member& member) {
    if (next == state.size()) refuse();
    const auto bytes = state[next++].cast<std::string>();
    if constexpr (is_list<Member>) {
      constexpr std::size_t size = sizeof(typename Member::value_type);
      if (bytes.size() % size != 0) refuse();
      member.resize(bytes.size() / size);
      if (!bytes.empty()) std::memcpy(member.data(), bytes.data(), bytes.size());
    } else {
      if (bytes.size() != sizeof(Member)) refuse();
      std::memcpy(&member, bytes.data(), sizeof(Member));
    }
  });
  return trajectory;
}

}  // namespace

void add_arrays(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(TrajectorySample, period, tilt, tilt_rate, slip, slip_rate, contact);
  PYBIND11_NUMPY_DTYPE(TrajectoryEvent, tau, kind, tilt, tilt_rate, slip, slip_rate);
  PYBIND11_NUMPY_DTYPE(HistorySample, tau, tilt, tilt_rate, slip, slip_rate, contact, base_acceleration);
  PYBIND11_NUMPY_DTYPE(StateInSi, time_s, tilt_rad, tilt_rate_rad_s, slip_m, slip_rate_m_s);
  py::class_<Trajectory, std::shared_ptr<Trajectory>>(module, "Trajectory")
      .def_property_readonly("strobe",
                             [](const py::object& self) { return rows(self.cast<const Trajectory&>().strobe, self); })
      .def_property_readonly("events",
                             [](const py::object& self) { return rows(self.cast<const Trajectory&>().events, self); })
      .def_property_readonly("history",
                             [](const py::object& self) { return rows(self.cast<const Trajectory&>().history, self); })
      .def_readonly("period_length", &Trajectory::period_length)
      .def("in_si", &arrays_in_si)
      .def("facts", &facts_of)
      .def(py::pickle(&state_of, &trajectory_of_state));
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
