#include "rocking/output/run_table.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "rocking/look/text_table.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using section::ResponseMode;

using Conditions = std::span<const ReportedCondition>;

constexpr ResponseMode overturned{.kind = section::ResponseKind::overturned};
constexpr std::string_view record_pointer = "/excitation/file";

double share_in(const ReportedCondition& condition, const ResponseMode& mode) {
  const Estimate* found = condition.result.estimate_of(mode);
  return found == nullptr ? 0.0 : found->estimate;
}

/// They may have any response.
double share_without_answer(const ReportedCondition& condition) {
  return static_cast<double>(condition.result.without_answer()) / static_cast<double>(condition.result.realisations);
}

bool have_equal_values(const ReportedCondition& a, const ReportedCondition& b, std::size_t entries) {
  for (std::size_t i = 0; i < entries; ++i) {
    if (a.asked.parameters[i].value != b.asked.parameters[i].value) return false;
  }
  return true;
}

/// Ranges of neighbours, and of how many entries of the sweep each has one value.
struct Grouping {
  std::vector<Conditions> ranges;
  std::size_t entries = 0;
  bool has_one_mode = false;  ///< each range has one most frequent response
};

/// Neighbours for which `belong` says so.
template <class Belong>
std::vector<Conditions> ranges_of(Conditions all, Belong&& belong) {
  std::vector<Conditions> ranges;
  for (std::size_t first = 0, i = 1; i <= all.size(); ++i) {
    if (i < all.size() && belong(all[i - 1], all[i])) continue;
    ranges.push_back(all.subspan(first, i - first));
    first = i;
  }
  return ranges;
}

Grouping grouping_of(Conditions all, std::size_t most) {
  const std::size_t entries = all.front().asked.parameters.size();
  std::size_t kept = entries == 0 ? 0 : entries - 1;
  const auto belong = [&kept](const ReportedCondition& a, const ReportedCondition& b) {
    return have_equal_values(a, b, kept);
  };
  const auto have_one_mode = [&](const ReportedCondition& a, const ReportedCondition& b) {
    return belong(a, b) && most_frequent_in(a) == most_frequent_in(b);
  };
  Grouping found{.ranges = ranges_of(all, have_one_mode), .entries = kept, .has_one_mode = true};
  for (; found.ranges.size() > most && kept > 0; --kept) found = {.ranges = ranges_of(all, belong), .entries = kept};
  if (found.ranges.size() <= most) return found;
  found = {};
  const std::size_t length = (all.size() + most - 1) / most;
  for (std::size_t i = 0; i < all.size(); i += length) {
    found.ranges.push_back(all.subspan(i, std::min(length, all.size() - i)));
  }
  return found;
}

/// `12.0`, or `3.1 to 97.0`.
std::string span_in_per_cent(double low, double high) {
  return low == high ? per_cent(low) : per_cent(low) + " to " + per_cent(high);
}

std::string shares_in(Conditions conditions, const ResponseMode& mode) {
  double low = 1.0, high = 0.0;
  for (const ReportedCondition& condition : conditions) {
    const double open = share_without_answer(condition);
    low = std::min(low, share_in(condition, mode) - (mode == ResponseMode{} ? open : 0.0));
    high = std::max(high, share_in(condition, mode) + (mode == ResponseMode{} ? 0.0 : open));
  }
  return span_in_per_cent(low, high);
}

bool may_overturn_in(Conditions conditions) {
  return std::ranges::any_of(conditions, [](const ReportedCondition& each) {
    return share_in(each, overturned) > 0.0 || each.result.without_answer() > 0;
  });
}

}  // namespace

std::string run_summary(const Report& report, std::size_t most) {
  const Conditions conditions = report.conditions;
  const Grouping grouping = grouping_of(conditions, most);
  const std::vector<Parameter>& swept = conditions.front().asked.parameters;
  const bool has_range = grouping.entries < swept.size();
  const bool may_overturn = may_overturn_in(conditions);
  look::Table table = table_of({swept.begin(), swept.begin() + static_cast<std::ptrdiff_t>(grouping.entries)}, {});
  if (has_range) add_columns(table, {last_key(swept[grouping.entries].pointer)});
  add_columns(table, {"conditions", "n"});
  if (grouping.has_one_mode) add_columns(table, {"response", "its share"});
  if (may_overturn) add_columns(table, {"overturned"});
  for (const Conditions own : grouping.ranges) {
    look::Row& row = table.rows.emplace_back();
    for (std::size_t i = 0; i < grouping.entries; ++i) row.emplace_back(short_value(own.front().asked.parameters[i]));
    if (has_range) {
      const std::string from = short_value(own.front().asked.parameters[grouping.entries]);
      const std::string to = short_value(own.back().asked.parameters[grouping.entries]);
      row.emplace_back(from == to ? from : from + " to " + to);
    }
    std::uint64_t realisations = 0;
    for (const ReportedCondition& condition : own) realisations += condition.result.realisations;
    append(row, {look::whole(own.size()), look::whole(realisations)});
    const ResponseMode mode = most_frequent_in(own.front());
    if (grouping.has_one_mode) append(row, {to_string(mode), shares_in(own, mode)});
    if (may_overturn) row.emplace_back(shares_in(own, overturned));
  }
  return to_terminal(table);
}

std::string pooled_summary(const Report& report, std::size_t most) {
  const std::vector<Parameter>& swept = report.conditions.front().asked.parameters;
  const auto record = std::ranges::find(swept, record_pointer, &Parameter::pointer);
  if (record == swept.end()) return {};
  const auto place = static_cast<std::size_t>(record - swept.begin());
  struct Pooled {
    std::vector<Parameter> others;
    std::vector<double> shares;
    double open = 0.0;  ///< sum over the conditions of their shares without an answer
    std::uint64_t realisations = 0;
  };
  std::vector<Pooled> groups;
  for (const ReportedCondition& condition : report.conditions) {
    std::vector<Parameter> others = condition.asked.parameters;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(place));
    auto group = std::ranges::find_if(groups, [&others](const Pooled& known) {
      return std::ranges::equal(known.others, others, {}, &Parameter::value, &Parameter::value);
    });
    if (group == groups.end()) group = groups.insert(groups.end(), {.others = std::move(others), .shares = {}});
    group->shares.push_back(share_in(condition, overturned));
    group->open += share_without_answer(condition);
    group->realisations += condition.result.realisations;
  }
  if (groups.size() > most) return {};
  look::Table table = table_of(groups.front().others, {"records", "n", "overturned", "of a record"});
  for (const Pooled& group : groups) {
    double sum = 0.0;
    for (const double share : group.shares) sum += share;
    const auto [low, high] = std::ranges::minmax(group.shares);
    const auto records = static_cast<double>(group.shares.size());
    table.rows.push_back(row_of(
        group.others, {look::whole(group.shares.size()), look::whole(group.realisations),
                       span_in_per_cent(sum / records, (sum + group.open) / records), span_in_per_cent(low, high)}));
  }
  return to_terminal(table);
}

}  // namespace rocking
