#include <cstddef>
#include <ctime>
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
#include "watched.hpp"

namespace rocking::python {
namespace {

namespace py = pybind11;

double seconds_of_this_thread() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// (JSON text, table, sentence, notices). Runs are (name, experiment, run).
py::tuple answer_of(const std::string& study, const std::string& question, const Experiment* experiment,
                    const std::string& files, const std::vector<std::tuple<std::string, Experiment, RunResult>>& runs,
                    const std::map<std::string, std::string>& texts, const std::string& earlier, unsigned threads,
                    std::string machine, std::string start, py::object on_progress) {
  StudySubject subject{.files = files, .texts = texts, .earlier = earlier};
  if (experiment != nullptr) subject.experiment = *experiment;
  for (const auto& [name, of_run, run] : runs) {
    subject.runs.push_back({of_run, run});
    subject.run_names.push_back(name);
  }
  const Provenance provenance{.machine = std::move(machine), .start = std::move(start), .threads = threads};
  StudyAnswer found = watch(threads, std::move(on_progress), [&](Execution execution) {
    execution.processor_seconds = seconds_of_this_thread;
    return answer(study, question, subject, execution, provenance);
  });
  return py::make_tuple(std::move(found.document), std::move(found.table), std::move(found.sentence),
                        std::move(found.notices));
}

/// (measure, intensities, annual rates, years, statistic, site, points left out).
py::tuple hazard_of(const GivenHazard& given) {
  const HazardCurve curve = curve_of(given).value();
  const auto column = [&curve](double HazardPoint::*number) {
    py::array_t<double> values(static_cast<py::ssize_t>(curve.points.size()));
    for (std::size_t i = 0; i < curve.points.size(); ++i) values.mutable_data()[i] = curve.points[i].*number;
    return values;
  };
  py::object where = py::none();
  if (curve.site) where = py::make_tuple(curve.site->longitude, curve.site->latitude);
  return py::make_tuple(curve.intensity, column(&HazardPoint::intensity), column(&HazardPoint::rate), curve.years,
                        curve.statistic, where, curve.certain);
}

}  // namespace

std::optional<HazardCurve> curve_of(const std::optional<GivenHazard>& given) {
  if (!given) return std::nullopt;
  const auto& [name, text, years, imt, site, statistic] = *given;
  const HazardReading reading{.years = years, .measure = imt, .site = hazard_site(site), .statistic = statistic};
  return text ? hazard_curve_in(*text, name, reading) : hazard_curve(name, reading);
}

void add_studies(py::module_& module) {
  module.def("answer", &answer_of);
  module.def("hazard", &hazard_of);
}

}  // namespace rocking::python
