#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "module.hpp"
#include "rocking/rocking.hpp"
#include "rocking/store/store.hpp"
#include "watched.hpp"

namespace rocking::python {
namespace {

namespace py = pybind11;

/// A stored realisation, as a row of an array.
struct RealisationRow {
  std::uint64_t condition;
  std::uint64_t realisation;
  std::int32_t mode;  ///< place in the list of names
  std::uint8_t termination;
  bool left_ground;
  bool past_balance;
  double margin;
  double peak_tilt;
  double peak_tilt_rate;
  double peak_slip;
  double peak_slip_m;
  double final_slip;
  double final_slip_m;
};

/// (names of the modes, array of rows); the array takes the rows over.
py::tuple rows_of(const RunResult& run) {
  auto rows = std::make_unique<std::vector<RealisationRow>>();
  std::map<section::ResponseMode, std::int32_t> places;
  for (const auto& counts : run.counts) {
    for (const auto& [mode, count] : counts) places.emplace(mode, 0);
  }
  py::list names;
  for (auto& [mode, place] : places) {
    place = static_cast<std::int32_t>(names.size());
    names.append(name_of(mode));
  }
  run.store->for_each([&](const RealisationKey& key, const Summary& summary) {
    const auto place = places.find(summary.mode);
    if (place == places.end()) return;  // beyond the realisations of the experiment
    const PeakValues& peaks = summary.peaks;
    rows->push_back({.condition = key.condition,
                     .realisation = key.realisation,
                     .mode = place->second,
                     .termination = static_cast<std::uint8_t>(summary.termination),
                     .left_ground = summary.left_ground,
                     .past_balance = summary.was_past_balance,
                     .margin = summary.margin,
                     .peak_tilt = peaks.tilt,
                     .peak_tilt_rate = peaks.tilt_rate,
                     .peak_slip = peaks.slip,
                     .peak_slip_m = peaks.slip_m,
                     .final_slip = peaks.final_slip,
                     .final_slip_m = peaks.final_slip_m});
  });
  const py::capsule owner(rows.get(), [](void* held) { delete static_cast<std::vector<RealisationRow>*>(held); });
  const std::vector<RealisationRow>& kept = *rows.release();
  return py::make_tuple(
      names, py::array(py::dtype::of<RealisationRow>(), {kept.size()}, {sizeof(RealisationRow)}, kept.data(), owner));
}

py::list counts_of(const RunResult& run) {
  py::list list;
  for (const auto& counts : run.counts) {
    py::dict dict;
    for (const auto& [mode, count] : counts) dict[py::str(name_of(mode))] = count;
    list.append(dict);
  }
  return list;
}

py::tuple numbers(const stats::Interval& interval) { return py::make_tuple(interval.low, interval.high); }

/// For each condition, for each listed mode: (name, successes, trials, estimate, interval), where the interval is the
/// one of the program's table.
py::list estimates_of(const RunResult& run) {
  py::list conditions;
  if (!run.result) return conditions;
  for (const ConditionResult& condition : run.result->conditions) {
    py::list modes;
    for (const auto& [mode, probability] : condition.modes) {
      const auto& interval = probability.anytime ? *probability.anytime : probability.simultaneous;
      modes.append(py::make_tuple(name_of(mode), probability.counts.successes, probability.counts.trials,
                                  probability.estimate, numbers(interval)));
    }
    conditions.append(modes);
  }
  return conditions;
}

/// (run, whether Ctrl-C stopped it).
py::tuple run_watched(const Experiment& experiment, unsigned threads, const std::string& folder,
                      const std::string& files, std::optional<std::pair<std::uint64_t, std::uint64_t>> shard,
                      py::object on_progress) {
  Watched<RunResult> watched(std::move(on_progress));
  Execution asked{.threads = threads, .folder = folder, .files = files};
  if (shard) asked.shard = Shard{.part = shard->first, .parts = shard->second};
  auto result = watched.run(std::move(asked), [&](const Execution& execution) { return run(experiment, execution); });
  return py::make_tuple(std::move(result), watched.was_interrupted());
}

/// (JSON text or None, whether Ctrl-C stopped it). `range` of the branches; None: the branches are not followed.
py::tuple orbits_watched(const Experiment& experiment, int longest,
                         std::optional<std::pair<std::optional<double>, std::optional<double>>> range,
                         std::vector<std::string> second, std::pair<std::optional<double>, std::optional<double>> span,
                         unsigned threads, py::object on_progress) {
  OrbitsRequest request{.longest = longest, .branches = range.has_value(), .second = std::move(second)};
  if (range) std::tie(request.from, request.to) = *range;
  std::tie(request.second_from, request.second_to) = span;
  Watched<std::string> watched(std::move(on_progress));
  auto text = watched.run({.threads = threads}, [&](const Execution& execution) {
    return orbits_text(experiment, orbit_study(experiment, request, execution));
  });
  return py::make_tuple(std::move(text), watched.was_interrupted());
}

/// (JSON text or None, whether Ctrl-C stopped it).
py::tuple bifurcation_watched(const Experiment& experiment, std::uint64_t realisation, unsigned threads,
                              py::object on_progress) {
  Watched<std::string> watched(std::move(on_progress));
  auto text = watched.run({.threads = threads},
                          [&](const Execution& execution) { return bifurcation(experiment, realisation, execution); });
  return py::make_tuple(std::move(text), watched.was_interrupted());
}

/// (JSON text or None, whether Ctrl-C stopped it).
py::tuple fragility_watched(const Experiment& experiment, const RunResult& run, std::vector<double> peak_tilts,
                            const std::optional<std::string>& hazard, bool incremental, unsigned threads,
                            py::object on_progress) {
  Watched<std::string> watched(std::move(on_progress));
  auto text = watched.run({.threads = threads}, [&](const Execution& execution) {
    FragilityQuestion question{.peak_tilts = std::move(peak_tilts), .incremental = incremental};
    if (hazard) question.hazard = hazard_curve(*hazard);
    return fragility(experiment, run, question, execution);
  });
  return py::make_tuple(std::move(text), watched.was_interrupted());
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double seconds_of_this_thread() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// ((words, JSON text) or None, whether Ctrl-C stopped it).
py::tuple plan_watched(const Experiment& experiment, unsigned threads,
                       std::optional<std::pair<std::uint64_t, std::uint64_t>> shard, bool timed) {
  Watched<std::pair<std::string, std::string>> watched(py::none{});
  Execution asked{.threads = threads};
  if (shard) asked.shard = Shard{.part = shard->first, .parts = shard->second};
  std::function<double()> clock;
  if (timed) clock = [start = std::chrono::steady_clock::now()] { return seconds_since(start); };
  const auto found = watched.run(std::move(asked), [&](const Execution& execution) {
    const Plan planned = plan(experiment, clock, execution);
    return std::pair(describe(planned), describe_as_json(planned));
  });
  return py::make_tuple(found, watched.was_interrupted());
}

/// (cost or None, whether Ctrl-C stopped it).
py::tuple cost_watched(const Experiment& experiment, double seconds, std::optional<std::uint64_t> sample,
                       std::vector<double> tolerances, unsigned threads, py::object on_progress) {
  const auto start = std::chrono::steady_clock::now();
  const CostRequest request{.elapsed_seconds = [start] { return seconds_since(start); },
                            .processor_seconds = seconds_of_this_thread,
                            .seconds = seconds,
                            .sample = sample,
                            .tolerances = std::move(tolerances)};
  Watched<Cost> watched(std::move(on_progress));
  auto found = watched.run({.threads = threads},
                           [&](const Execution& execution) { return cost(experiment, request, execution); });
  return py::make_tuple(std::move(found), watched.was_interrupted());
}

}  // namespace

void add_runs(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(RealisationRow, condition, realisation, mode, termination, left_ground, past_balance, margin,
                       peak_tilt, peak_tilt_rate, peak_slip, peak_slip_m, final_slip, final_slip_m);
  py::class_<RunResult>(module, "Run")
      .def_readonly("done", &RunResult::done)
      .def_readonly("all", &RunResult::all)
      .def_property_readonly("is_complete", &RunResult::is_complete)
      .def_property_readonly("counts", &counts_of)
      .def_property_readonly("estimates", &estimates_of)
      .def("rows", &rows_of)
      .def("digest", &digest_of)
      .def("table", [](const RunResult& run, const Experiment& experiment,
                       std::size_t width) { return table(experiment, run, width); })
      .def("report", [](const RunResult& run, const Experiment& experiment, std::string machine, std::string start,
                        double duration, unsigned threads) {
        const py::gil_scoped_release release;
        return report(
            experiment, run,
            {.machine = std::move(machine), .start = std::move(start), .duration_s = duration, .threads = threads});
      });
  module.def("run", &run_watched);
  module.def("plan", &plan_watched);
  module.def("orbits", &orbits_watched);
  module.def("bifurcation", &bifurcation_watched);
  py::class_<Cost>(module, "Cost")
      .def("text", [](const Cost& found, const Experiment& experiment, std::string machine, std::string start,
                      double duration, unsigned threads) {
        return cost_text(
            experiment, found,
            {.machine = std::move(machine), .start = std::move(start), .duration_s = duration, .threads = threads});
      });
  module.def("cost", &cost_watched);
  module.def("compare", [](const Experiment& experiment, const RunResult& run, const Experiment& other_experiment,
                           const RunResult& other_run) {
    const py::gil_scoped_release release;
    return comparison_text(compare({experiment, run}, {other_experiment, other_run}));
  });
  module.def("motion", [](std::vector<std::string> files, std::string vertical, std::string format, std::string units,
                          double time_step, double gravity, double damping, std::vector<double> periods, bool series,
                          std::optional<std::pair<double, double>> block) {
    const py::gil_scoped_release release;
    GroundMotionRequest request{.files = std::move(files),
                                .vertical = std::move(vertical),
                                .format = std::move(format),
                                .units = std::move(units),
                                .time_step = time_step,
                                .series = series,
                                .question = {.gravity = gravity, .damping = damping, .periods = std::move(periods)}};
    if (block) request.question.block = dynamics::Block{block->first, block->second, gravity};
    return motion(request);
  });
  module.def("fragility", &fragility_watched);
  module.def("open_run", [](const std::string& folder) {
    StoredRun stored = [&] {
      const py::gil_scoped_release release;
      return open_run(folder);
    }();
    return py::make_tuple(std::move(stored.experiment), std::move(stored.run));
  });
  module.def("merge", [](const std::string& folder, const std::vector<std::string>& parts) {
    StoredRun stored = [&] {
      const py::gil_scoped_release release;
      return merge(folder, {parts.begin(), parts.end()});
    }();
    return py::make_tuple(std::move(stored.experiment), std::move(stored.run));
  });
}

}  // namespace rocking::python
