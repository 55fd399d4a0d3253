#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "module.hpp"
#include "rocking/rocking.hpp"
#include "watched.hpp"

namespace rocking::python {
namespace {

namespace py = pybind11;

py::tuple checked(const RunCheck& found) { return py::make_tuple(found.checked, found.different, found.findings); }

py::dict build_facts() {
  const base::BuildInfo build = build_info();
  py::dict facts;
  facts["version"] = std::string(build.version);
  facts["revision"] = std::string(build.revision);
  facts["compiler"] = std::string(build.compiler);
  facts["flags"] = std::string(build.flags);
  facts["build_type"] = std::string(build.build_type);
  return facts;
}

py::list arithmetic() {
  py::list list;
  for (const base::ArithmeticCheck& check : check_arithmetic()) {
    list.append(py::make_tuple(std::string(check.name), check.passed));
  }
  return list;
}

}  // namespace

void add_checks(py::module_& module) {
  module.def("verify", [](const Experiment& experiment, const RunResult& run, std::optional<std::uint64_t> sample,
                          unsigned threads, py::object on_progress) {
    return checked(watch(threads, std::move(on_progress), [&](const Execution& execution) {
      return verify({experiment, run}, sample, execution);
    }));
  });
  module.def("verify_folder", [](const std::string& folder, std::optional<std::uint64_t> sample, unsigned threads,
                                 py::object on_progress) {
    return checked(watch(threads, std::move(on_progress), [&](const Execution& execution) {
      return verify(std::filesystem::path(folder), sample, execution);
    }));
  });
  module.def("replay", [](const Experiment& experiment, const RunResult& run, std::uint64_t condition,
                          std::uint64_t realisation, std::optional<std::int64_t> periods, int samples) {
    return watch(1, py::none(), [&](const Execution& execution) {
      const TrajectoryRequest request{
          .condition = condition, .realisation = realisation, .periods = periods, .samples_per_period = samples};
      return std::make_shared<Trajectory>(replay({experiment, run}, request, execution));
    });
  });
  module.def("build_info", &build_facts);
  module.def("check_arithmetic", &arithmetic);
}

}  // namespace rocking::python
