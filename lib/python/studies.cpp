#include <ctime>
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

double seconds_of_this_thread() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::string answer_of(const std::string& study, const std::string& question, const Experiment* experiment,
                      const std::string& files, const std::vector<std::pair<Experiment, RunResult>>& runs,
                      unsigned threads, std::string machine, std::string start, py::object on_progress) {
  StudySubject subject{.files = files};
  if (experiment != nullptr) subject.experiment = *experiment;
  for (const auto& [of_run, run] : runs) subject.runs.push_back({of_run, run});
  const Clocks clocks{.elapsed_seconds = seconds_from_now(), .processor_seconds = seconds_of_this_thread};
  const Provenance provenance{.machine = std::move(machine), .start = std::move(start), .threads = threads};
  return watch(threads, std::move(on_progress), [&](const Execution& execution) {
    return answer(study, question, subject, clocks, execution, provenance);
  });
}

}  // namespace

void add_studies(py::module_& module) { module.def("answer", &answer_of); }

}  // namespace rocking::python
