#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "module.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/rocking.hpp"
#include "watched.hpp"

namespace rocking::python {
namespace {

namespace py = pybind11;

/// ((checked, different, findings) or None, whether Ctrl-C stopped it).
py::tuple verify_watched(const Experiment& experiment, const RunResult& run, std::optional<std::uint64_t> sample,
                         unsigned threads, py::object on_progress) {
  Watched<RunCheck> watched(std::move(on_progress));
  const auto found = watched.run({.threads = threads}, [&](const Execution& execution) {
    return verify({experiment, run}, sample, execution);
  });
  py::object answer = py::none();
  if (found) answer = py::make_tuple(found->checked, found->different, found->findings);
  return py::make_tuple(std::move(answer), watched.was_interrupted());
}

/// The same of a report without its store.
py::tuple verify_report_watched(const std::string& report, const std::string& files, unsigned threads,
                                py::object on_progress) {
  Watched<RunCheck> watched(std::move(on_progress));
  const auto found = watched.run({.threads = threads},
                                 [&](const Execution& execution) { return verify_report(report, files, execution); });
  py::object answer = py::none();
  if (found) answer = py::make_tuple(found->checked, found->different, found->findings);
  return py::make_tuple(std::move(answer), watched.was_interrupted());
}

/// (JSON text or None, whether Ctrl-C stopped it).
py::tuple rare_watched(const Experiment& experiment, double relative_error, std::optional<double> peak_tilt,
                       std::size_t particles, bool by_energy, std::optional<double> seconds, unsigned threads,
                       py::object on_progress) {
  RareRequest request{.question = {.event = {.peak_tilt = peak_tilt}, .relative_error = relative_error},
                      .particles = particles,
                      .score = by_energy ? rare::Score::energy : rare::Score::tilt};
  request.seconds = seconds;
  request.elapsed_seconds = [start = std::chrono::steady_clock::now()] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  Watched<std::string> watched(std::move(on_progress));
  auto text = watched.run({.threads = threads}, [&](const Execution& execution) {
    return rare_text(experiment, request, rare_probabilities(experiment, request, execution));
  });
  return py::make_tuple(std::move(text), watched.was_interrupted());
}

py::dict build_facts() {
  const base::BuildInfo build = base::build_info();
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
  module.def("verify", &verify_watched);
  module.def("verify_report", &verify_report_watched);
  module.def("rare", &rare_watched);
  module.def("report_faults", [](const std::string& report, const Experiment& experiment, const RunResult& run) {
    const py::gil_scoped_release release;
    return report_faults(report, {experiment, run});
  });
  module.def("replay", [](const Experiment& experiment, const RunResult& run, std::uint64_t condition,
                          std::uint64_t realisation, std::int64_t periods, int samples) {
    return watched_trajectory([&](const Execution& execution) {
      return replay(
          {experiment, run},
          {.condition = condition, .realisation = realisation, .periods = periods, .samples_per_period = samples},
          execution);
    });
  });
  module.def(
      "check_normal", [](std::uint64_t n, double mean, double sigma, std::uint64_t seed, const std::string& sampler) {
        const py::gil_scoped_release release;
        const SamplerQuestion question{.n = n, .law = {.mean = mean, .sigma = sigma}, .seed = seed, .sampler = sampler};
        return check_normal_text(question, check_normal(question));
      });
  module.def("build_info", &build_facts);
  module.def("check_arithmetic", &arithmetic);
}

}  // namespace rocking::python
