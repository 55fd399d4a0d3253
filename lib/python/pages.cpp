#include "rocking/pages.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "module.hpp"
#include "rocking/rocking.hpp"
#include "watched.hpp"

namespace rocking::python {
namespace {

namespace py = pybind11;

/// (paths, reasons).
template <class Write>
py::tuple write_watched(const Write& write, unsigned threads = 1) {
  const Written written = watch(threads, py::none(), write);
  std::vector<std::string> files;
  for (const auto& file : written.files) files.push_back(file.string());
  return py::make_tuple(std::move(files), written.not_drawn);
}

}  // namespace

void add_pages(py::module_& module) {
  module.def(
      "write_page", [](const Experiment& experiment, const RunResult& run, const std::string& file, std::string machine,
                       std::string start, double duration, unsigned threads, const std::optional<GivenHazard>& hazard) {
        const Provenance provenance{
            .machine = std::move(machine), .start = std::move(start), .duration_s = duration, .threads = threads};
        return write_watched([&](const Execution& execution) {
          return write_page({experiment, run}, file, provenance, execution, curve_of(hazard));
        });
      });
  module.def(
      "write_trajectory_page", [](const Experiment& experiment, std::uint64_t condition, std::uint64_t realisation,
                                  std::optional<std::int64_t> periods, int samples, const std::string& file) {
        const TrajectoryRequest request{
            .condition = condition, .realisation = realisation, .periods = periods, .samples_per_period = samples};
        return write_watched([&](const Execution& execution) {
          write_trajectory_page(experiment, request, file, execution);
          return Written{.files = {file}, .not_drawn = {}};
        });
      });
  module.def("write_figures",
             [](const Experiment& experiment, const RunResult& run, const std::string& folder, int column,
                std::vector<std::string> pictures, const std::optional<GivenHazard>& hazard) {
               return write_watched([&](const Execution& execution) {
                 return write_figures({experiment, run}, folder,
                                      {.column = static_cast<Column>(column), .pictures = std::move(pictures)},
                                      execution, curve_of(hazard));
               });
             });
  module.def("write_sheet",
             [](const Experiment& experiment, const RunResult& run, const std::string& file, const std::string& project,
                const std::string& date, unsigned threads, const std::optional<GivenHazard>& hazard) {
               const auto write = [&](const Execution& execution) {
                 const FragilityQuestion question{.hazard = curve_of(hazard)};
                 const RunFragility found = fragility(experiment, run, question, execution);
                 const SheetNotes notes{.command = "rocking.write_sheet", .project = project, .date = date};
                 return write_sheet({experiment, run}, found, question.hazard.value(), file, notes, execution);
               };
               return write_watched(write, threads);
             });
  module.def("write_tables", [](const Experiment& experiment, const RunResult& run, const std::string& folder) {
    return write_watched([&](const Execution&) { return write_tables({experiment, run}, folder); });
  });
  module.def("draw", [](const std::vector<std::pair<std::string, std::string>>& sources, const std::string& folder,
                        int column, std::vector<std::string> pictures, double from, std::optional<double> to) {
    std::vector<StudyText> texts;
    for (const auto& [name, text] : sources) texts.push_back({.name = name, .text = text});
    return write_watched([&](const Execution& execution) {
      return draw(texts, folder, {.column = static_cast<Column>(column), .pictures = std::move(pictures)}, execution,
                  {.from = from, .to = to});
    });
  });
}

}  // namespace rocking::python
