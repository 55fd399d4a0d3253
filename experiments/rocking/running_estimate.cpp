#include "running_estimate.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "rocking/output/mode_table.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::program {
namespace {

constexpr double confidence = 0.95;

std::string name_of(const Condition& condition) {
  const std::string name = values_of(condition.parameters);
  return name.empty() ? "so far" : name;
}

}  // namespace

void RunningEstimate::add(std::size_t condition, const std::vector<Summary>& summaries) {
  condition_ = condition;
  for (const Summary& summary : summaries) ++counts_[condition][summary.mode];
}

std::string RunningEstimate::text() const {
  const auto found = counts_.find(condition_);
  if (found == counts_.end()) return "";
  std::uint64_t number = 0;
  for (const auto& [mode, count] : found->second) number += count;
  const auto& [mode, count] =
      *std::ranges::max_element(found->second, {}, [](const auto& entry) { return entry.second; });
  const stats::Interval interval = stats::wilson({.successes = count, .trials = number}, confidence);
  return fmt::format("{}: {} {} of {}, {} % {}", name_of(experiment_->conditions[condition_]), to_string(mode), count,
                     number, per_cent(static_cast<double>(count) / static_cast<double>(number), 0),
                     per_cent(interval, 0));
}

}  // namespace rocking::program
