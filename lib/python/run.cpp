#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "module.hpp"
#include "rocking/rocking.hpp"
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
  std::int8_t overturned_side;  ///< 1: left, -1: right, 0: it did not overturn
  double margin;
  double peak_tilt;
  double peak_tilt_rate;
  double peak_slip;
  double peak_slip_m;
  double final_slip;
  double final_slip_m;
};

/// In the order of tables: those that a condition lists, or of an incomplete run those that occurred.
std::vector<section::ResponseMode> modes_of(const RunResult& run) {
  std::set<section::ResponseMode> modes;
  if (run.result) {
    for (const ConditionResult& condition : run.result->conditions) {
      for (const auto& [mode, probability] : condition.modes) modes.insert(mode);
    }
  } else {
    for (const auto& counts : run.counts) {
      for (const auto& [mode, count] : counts) modes.insert(mode);
    }
  }
  return {modes.begin(), modes.end()};
}

std::size_t place_of(const section::ResponseMode& mode, const std::vector<section::ResponseMode>& modes) {
  return static_cast<std::size_t>(std::ranges::lower_bound(modes, mode) - modes.begin());
}

std::vector<std::string> names_of(const RunResult& run) {
  std::vector<std::string> names;
  for (const section::ResponseMode& mode : modes_of(run)) names.push_back(name_of(mode));
  return names;
}

/// Shape (conditions, modes).
py::array_t<std::int64_t> counts_of(const RunResult& run) {
  const std::vector<section::ResponseMode> modes = modes_of(run);
  py::array_t<std::int64_t> table({run.counts.size(), modes.size()});
  std::fill_n(table.mutable_data(), table.size(), 0);
  for (std::size_t i = 0; i < run.counts.size(); ++i) {
    for (const auto& [mode, count] : run.counts[i]) {
      table.mutable_at(i, place_of(mode, modes)) = static_cast<std::int64_t>(count);
    }
  }
  return table;
}

/// Shape (conditions, modes, 2): the intervals of the program's table, NaN for a mode that the condition does not list.
/// Precondition: the run is complete.
py::array_t<double> intervals_of(const RunResult& run) {
  const std::vector<section::ResponseMode> modes = modes_of(run);
  py::array_t<double> table({run.counts.size(), modes.size(), std::size_t{2}});
  std::fill_n(table.mutable_data(), table.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < run.result->conditions.size(); ++i) {
    for (const auto& [mode, probability] : run.result->conditions[i].modes) {
      const auto& interval = probability.anytime ? *probability.anytime : probability.simultaneous;
      const std::size_t place = place_of(mode, modes);
      table.mutable_at(i, place, 0) = interval.low;
      table.mutable_at(i, place, 1) = interval.high;
    }
  }
  return table;
}

std::int8_t sign_of(const std::optional<dynamics::Side>& side) {
  if (!side) return 0;
  return *side == dynamics::Side::left ? 1 : -1;
}

/// Array of rows, whose modes are places in the list of names. It takes the rows over.
py::array rows_of(const RunResult& run) {
  auto rows = std::make_unique<std::vector<RealisationRow>>();
  const std::vector<section::ResponseMode> modes = modes_of(run);
  for (const RunRealisation& row : realisations_of(run)) {
    if (!std::ranges::binary_search(modes, row.mode)) continue;  // beyond the realisations of the experiment
    rows->push_back({.condition = row.key.condition,
                     .realisation = row.key.realisation,
                     .mode = static_cast<std::int32_t>(place_of(row.mode, modes)),
                     .termination = static_cast<std::uint8_t>(row.termination),
                     .left_ground = row.left_ground,
                     .past_balance = row.was_past_balance,
                     .overturned_side = sign_of(row.overturned_side),
                     .margin = row.margin,
                     .peak_tilt = row.peaks.tilt,
                     .peak_tilt_rate = row.peaks.tilt_rate,
                     .peak_slip = row.peaks.slip,
                     .peak_slip_m = row.peaks.slip_m,
                     .final_slip = row.peaks.final_slip,
                     .final_slip_m = row.peaks.final_slip_m});
  }
  const py::capsule owner(rows.get(), [](void* held) { delete static_cast<std::vector<RealisationRow>*>(held); });
  const std::vector<RealisationRow>& kept = *rows.release();
  return py::array(py::dtype::of<RealisationRow>(), {kept.size()}, {sizeof(RealisationRow)}, kept.data(), owner);
}

/// (run, whether Ctrl-C stopped it).
py::tuple run_watched(const Experiment& experiment, unsigned threads, const std::string& folder,
                      const std::string& files, std::optional<std::pair<std::uint64_t, std::uint64_t>> shard,
                      bool repair, std::optional<double> max_time, py::object on_progress) {
  Watched<RunResult> watched(std::move(on_progress), max_time);
  Execution asked{.threads = threads, .folder = folder, .repair = repair, .files = files};
  if (shard) asked.shard = Shard{.part = shard->first, .parts = shard->second};
  auto result = watched.run(std::move(asked), [&](const Execution& execution) { return run(experiment, execution); });
  return py::make_tuple(std::move(result), watched.was_interrupted());
}

/// (experiment, run, whether Ctrl-C stopped it).
py::tuple resume_watched(const std::string& folder, std::optional<std::string> realisations,
                         const std::vector<double>& levels, unsigned threads, std::optional<double> max_time,
                         py::object on_progress) {
  Watched<StoredRun> watched(std::move(on_progress), max_time);
  auto stored = watched.run({.threads = threads}, [&](const Execution& execution) {
    return resume(folder, {.realisations = std::move(realisations), .levels = levels}, execution);
  });
  return py::make_tuple(std::move(stored->experiment), std::move(stored->run), watched.was_interrupted());
}

/// (words, JSON text).
std::pair<std::string, std::string> plan_watched(const Experiment& experiment, unsigned threads,
                                                 std::optional<std::pair<std::uint64_t, std::uint64_t>> shard,
                                                 bool timed) {
  return watch(threads, py::none(), [&](Execution execution) {
    if (shard) execution.shard = Shard{.part = shard->first, .parts = shard->second};
    if (!timed) execution.elapsed_seconds = {};
    const Plan planned = plan(experiment, execution);
    return std::pair(describe(planned), describe_as_json(planned));
  });
}

}  // namespace

void add_runs(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(RealisationRow, condition, realisation, mode, termination, left_ground, past_balance,
                       overturned_side, margin, peak_tilt, peak_tilt_rate, peak_slip, peak_slip_m, final_slip,
                       final_slip_m);
  py::class_<RunResult>(module, "Run")
      .def_readonly("done", &RunResult::done)
      .def_readonly("all", &RunResult::all)
      .def_property_readonly("damaged_file",
                             [](const RunResult& run) {
                               return run.damaged_file ? std::optional(run.damaged_file->string()) : std::nullopt;
                             })
      .def_property_readonly("is_complete", &RunResult::is_complete)
      .def("modes", &names_of)
      .def("counts", &counts_of)
      .def("intervals", &intervals_of)
      .def("rows", &rows_of)
      .def("digest", &digest_of)
      .def("bytes", [](const RunResult& run) { return py::bytes(bytes_of(run)); })
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
  module.def("resume", &resume_watched);
  module.def("run_of", [](const Experiment& experiment, const std::string& bytes,
                          const std::optional<std::string>& damaged_file) {
    const py::gil_scoped_release release;
    RunResult run = run_of(experiment, bytes);
    if (damaged_file) run.damaged_file = *damaged_file;
    return run;
  });
  module.def("plan", &plan_watched);
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
