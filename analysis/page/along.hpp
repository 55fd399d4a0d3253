#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "analysis/page/words.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/report.hpp"

/// Sentences about conditions along a sweep.
namespace rocking::analysis {

/// Largest number of combinations of the other swept parameters for which the answer has its own sentences, and of
/// stretches of the shown parameter in each of them.
inline constexpr std::size_t most_answers = 6;
inline constexpr std::size_t most_stretches = 6;

/// Neighbouring conditions of a slice; places in it, both included.
struct Range {
  std::size_t first, last;
};

/// The conditions of a slice, with their names as positions along the sweep.
class Along {
 public:
  Along(const Report& report, const SweepView& view, const Slice& slice)
      : report_(&report), slice_(&slice), entry_(view.entry) {}

  [[nodiscard]] std::size_t size() const { return slice_->conditions.size(); }
  [[nodiscard]] const ReportedCondition& at(std::size_t place) const {
    return report_->conditions[slice_->conditions[place]];
  }
  /// `A_h = 4.5`, as HTML.
  [[nodiscard]] std::string name(std::size_t place) const { return place_html(at(place).asked.parameters[entry_]); }
  /// The value only, where the quantity has been named.
  [[nodiscard]] std::string value(std::size_t place) const {
    return place_value_html(at(place).asked.parameters[entry_]);
  }
  [[nodiscard]] std::string name(const Range& range) const {
    if (range.first == range.last) return name(range.first);
    return name(range.first) + " to " + value(range.last);
  }

  /// Neighbouring conditions for which `kind` has the same value.
  template <class Kind>
  [[nodiscard]] std::vector<Range> ranges(const Kind& kind) const {
    std::vector<Range> found;
    for (std::size_t i = 0; i < size(); ++i) {
      if (i > 0 && kind(at(i)) == kind(at(i - 1))) {
        found.back().last = i;
      } else {
        found.push_back({.first = i, .last = i});
      }
    }
    return found;
  }

 private:
  const Report* report_;
  const Slice* slice_;
  std::size_t entry_;
};

/// Whether each slice has its own sentence.
[[nodiscard]] bool has_few_slices(const SweepView& view);

/// HTML: a sentence for each slice, after its name.
[[nodiscard]] std::string by_slice(const Report& report, const SweepView& view,
                                   const std::function<std::string(const Along&)>& sentence);

/// `33.6 % [31.5, 35.7]`.
[[nodiscard]] std::string probability_at(const ReportedCondition& condition, const section::ResponseMode& mode);

/// `, 48 of 300000 realisations`.
[[nodiscard]] std::string count_at(const ReportedCondition& condition, const section::ResponseMode& mode);

}  // namespace rocking::analysis
