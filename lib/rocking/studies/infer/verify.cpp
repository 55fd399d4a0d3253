#include <algorithm>
#include <utility>

#include "rocking/api/refuse.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/api/system_facts.hpp"
#include "rocking/input/report_claims.hpp"
#include "rocking/output/report_differences.hpp"
#include "rocking/studies/infer/infer.hpp"
#include "rocking/studies/infer/study.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/locate.hpp"

namespace rocking {
namespace {

constexpr std::uint64_t points_without_sample = 8;

/// `number` of the indices below `size`, evenly spaced.
std::vector<std::size_t> evenly_spaced(std::size_t size, std::size_t number) {
  number = std::min(number, size);
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < number; ++i) indices.push_back(i * size / number);
  return indices;
}

InferReport infer_report_in(const std::string& text, const std::filesystem::path& file) {
  try {
    return infer_document().read_unchecked(parse_json(text));
  } catch (const base::InputError& error) {
    throw located(error, text, file.string());
  }
}

RunCheck check_of(const InferReport& claimed, const std::string& text, const std::filesystem::path& folder,
                  std::uint64_t sample, const Execution& execution) {
  const Surroundings surroundings = seen_near(folder);
  const std::optional<Experiment> experiment = stated_experiment(claimed.input, surroundings);
  RunCheck check;
  if (!experiment) {
    check.findings = {std::string(wrong_digest_of_experiment)};
    return check;
  }
  if (claimed.unknowns.size() != experiment->unknowns.size()) {
    check.findings = {"/unknowns does not have one entry for each unknown of the experiment"};
    return check;
  }
  check_infer(*experiment);
  const CountedTests tests = tests_of(claimed);
  const OptionsOfExecution asked(execution);
  InferSimulation simulation(*experiment, tests, surroundings, asked.options());
  const std::vector<std::size_t> indices = evenly_spaced(claimed.design.size(), sample);
  std::vector<std::vector<double>> places;
  for (const std::size_t i : indices) places.push_back(claimed.design[i].at);
  CountsAtPoints counts;
  if (!places.empty()) counts = simulation.counts_at(places);
  std::vector<infer::DesignPoint> design = claimed.design;
  for (std::size_t k = 0; k < indices.size(); ++k) {
    infer::DesignPoint& point = design[indices[k]];
    check.different += point.counts != counts[k] ? 1 : 0;
    point.counts = std::move(counts[k]);
  }
  check.checked = indices.size();
  const InferenceSetting setting = inference_setting(*experiment, tests, claimed.next_tests, simulation);
  const Inference right = inference_from(setting, std::move(design), claimed.end,
                                         {.threads = asked.options().threads, .stop = asked.stop()});
  check.findings =
      report_differences(text, infer_document().text(infer_report(*experiment, tests, claimed.next_tests, right)));
  return check;
}

}  // namespace

RunCheck verify_infer(const std::filesystem::path& folder, std::optional<std::uint64_t> sample,
                      const Execution& execution) {
  if (sample == 0) refuse("sample", "0", "must be at least 1");
  const std::filesystem::path file = folder / "infer.json";
  const std::string text = read_file(file);
  return check_of(infer_report_in(text, file), text, folder, sample.value_or(points_without_sample), execution);
}

}  // namespace rocking
