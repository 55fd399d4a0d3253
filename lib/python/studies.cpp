#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "module.hpp"
#include "rocking/rocking.hpp"
#include "watched.hpp"

/// Studies of experiments. Each returns the text of its document.
namespace rocking::python {
namespace {

namespace py = pybind11;

using Ends = std::pair<std::optional<double>, std::optional<double>>;

/// `range` of the branches; None: the branches are not followed.
std::string orbits_text_of(const Experiment& experiment, int longest, std::optional<Ends> range,
                           std::vector<std::string> second, Ends span, unsigned threads, py::object on_progress) {
  OrbitsRequest request{.longest = longest, .branches = range.has_value(), .second = std::move(second)};
  if (range) std::tie(request.from, request.to) = *range;
  std::tie(request.second_from, request.second_to) = span;
  return watch(threads, std::move(on_progress), [&](const Execution& execution) {
    return orbits_text(experiment, orbits(experiment, request, execution));
  });
}

std::string bifurcation_text_of(const Experiment& experiment, std::uint64_t realisation, unsigned threads,
                                py::object on_progress) {
  return watch(threads, std::move(on_progress), [&](const Execution& execution) {
    return bifurcation_text(experiment, realisation, bifurcation(experiment, realisation, execution));
  });
}

std::string fragility_text_of(const Experiment& experiment, const RunResult& run, std::vector<double> peak_tilts,
                              const std::optional<std::string>& hazard, std::optional<double> years,
                              std::optional<std::string> imt, const std::optional<std::string>& metadata,
                              bool incremental, unsigned threads, py::object on_progress) {
  FragilityQuestion question{.peak_tilts = std::move(peak_tilts), .incremental = incremental};
  return watch(threads, std::move(on_progress), [&](const Execution& execution) {
    if (hazard) question.hazard = hazard_curve(*hazard, {.years = years, .measure = std::move(imt)});
    if (metadata) question.metadata = record_metadata(*metadata);
    return fragility_text(fragility(experiment, run, question, execution));
  });
}

std::string rare_text_of(const Experiment& experiment, double relative_error, std::optional<double> peak_tilt,
                         std::size_t particles, std::optional<double> seconds, unsigned threads,
                         py::object on_progress) {
  RareRequest request{.question = {.event = {.peak_tilt = peak_tilt}, .relative_error = relative_error},
                      .particles = particles};
  request.seconds = seconds;
  request.elapsed_seconds = seconds_from_now();
  return watch(threads, std::move(on_progress), [&](const Execution& execution) {
    return rare_probabilities_text(experiment, request, rare_probabilities(experiment, request, execution));
  });
}

std::string infer_text_of(const Experiment& experiment, const std::string& tests,
                          const std::optional<std::string>& candidates, std::uint64_t next_tests,
                          const std::string& folder, std::optional<double> seconds, unsigned threads,
                          py::object on_progress) {
  InferRequest request{.tests = {}, .next_tests = next_tests, .folder = folder};
  request.seconds = seconds;
  request.elapsed_seconds = seconds_from_now();
  return watch(threads, std::move(on_progress), [&](const Execution& execution) {
    check_infer(experiment);
    request.tests = counted_tests(experiment, tests, candidates, folder);
    return infer_unknowns_text(experiment, request, infer_unknowns(experiment, request, execution));
  });
}

double seconds_of_this_thread() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Cost cost_of(const Experiment& experiment, double seconds, std::optional<std::uint64_t> sample,
             std::vector<double> tolerances, unsigned threads, py::object on_progress) {
  const CostRequest request{.elapsed_seconds = seconds_from_now(),
                            .processor_seconds = seconds_of_this_thread,
                            .seconds = seconds,
                            .sample = sample,
                            .tolerances = std::move(tolerances)};
  return watch(threads, std::move(on_progress),
               [&](const Execution& execution) { return cost(experiment, request, execution); });
}

std::string motion_text_of(std::vector<std::string> files, std::optional<std::string> vertical, std::string format,
                           std::optional<std::string> units, std::optional<double> time_step,
                           std::vector<std::string> columns, double gravity, double damping,
                           std::vector<double> periods, bool series, std::optional<std::pair<double, double>> block) {
  GroundMotionRequest request{.files = std::move(files),
                              .vertical = std::move(vertical),
                              .format = std::move(format),
                              .units = std::move(units),
                              .time_step = time_step,
                              .columns = std::move(columns),
                              .series = series,
                              .question = {.gravity = gravity, .damping = damping, .periods = std::move(periods)}};
  if (block) request.question.block = dynamics::Block{block->first, block->second, gravity};
  return motion_text(request, motion(request));
}

FluctuationLaw fluctuation_law_named(const std::string& name) {
  const auto place = std::ranges::find(fluctuation_law_names, name);
  if (place == fluctuation_law_names.end()) {
    throw py::value_error("law: \"" + name + "\" is none; they are normal, lognormal, uniform");
  }
  return static_cast<FluctuationLaw>(place - fluctuation_law_names.begin());
}

}  // namespace

void add_studies(py::module_& module) {
  module.def("orbits", &orbits_text_of);
  module.def("bifurcation", &bifurcation_text_of);
  module.def("fragility", &fragility_text_of);
  module.def("rare", &rare_text_of);
  module.def("infer", &infer_text_of);
  py::class_<Cost>(module, "Cost")
      .def("text", [](const Cost& found, const Experiment& experiment, std::string machine, std::string start,
                      double duration, unsigned threads) {
        return cost_text(
            experiment, found,
            {.machine = std::move(machine), .start = std::move(start), .duration_s = duration, .threads = threads});
      });
  module.def("cost", &cost_of);
  module.def(
      "compare",
      [](const Experiment& experiment, const RunResult& run, const Experiment& other_experiment,
         const RunResult& other_run) {
        return compare_text(compare({experiment, run}, {other_experiment, other_run}));
      },
      py::call_guard<py::gil_scoped_release>());
  module.def("motion", &motion_text_of, py::call_guard<py::gil_scoped_release>());
  module.def(
      "check_normal",
      [](std::uint64_t n, double mean, double sigma, const std::string& law, std::uint64_t seed,
         const std::string& sampler) {
        const SamplerQuestion question{.n = n,
                                       .law = {.mean = mean, .sigma = sigma},
                                       .distribution = fluctuation_law_named(law),
                                       .seed = seed,
                                       .sampler = sampler};
        return check_normal_text(question, check_normal(question));
      },
      py::call_guard<py::gil_scoped_release>());
}

}  // namespace rocking::python
