#include "rocking/input/read_tests.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/input/sweep.hpp"
#include "rocking/text/spelling.hpp"

namespace rocking {
namespace {

class ColumnReader {
 public:
  ColumnReader(const Experiment& experiment, LineProblems& problems)
      : experiment_(&experiment), places_(swept_places(Json::parse(experiment.canonical_text))), problems_(&problems) {}

  TestColumns read(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      if (const auto pointer = parameter_named(name)) {
        add_parameter(name, *pointer);
      } else if (auto modes = modes_named(name)) {
        columns_.groups.push_back({.name = name, .modes = *std::move(modes)});
      }
    }
    refuse_missing_parameters();
    return std::move(columns_);
  }

 private:
  /// Absent where the name is that of response modes.
  std::optional<std::string> parameter_named(const std::string& name) {
    if (name.starts_with('/')) {
      if (std::ranges::find(places_, name) != places_.end()) return name;
      const auto nearest = nearest_word(name, places_);
      problems_->reject_line(name, "is not a value of the experiment that a sweep may change",
                             nearest ? "did you mean \"" + *nearest + "\"?" : "give a place of the experiment file");
      return name;
    }
    std::vector<std::string> found;
    for (const std::string& place : places_) {
      if (last_key(place) == name) found.push_back(place);
    }
    // What the experiment sweeps is meant where several have the name.
    for (const Parameter& swept : experiment_->conditions.front().parameters) {
      if (last_key(swept.pointer) == name) found = {swept.pointer};
    }
    if (found.size() > 1) {
      problems_->reject_line(name, "is the last key of several places of the experiment",
                             "write the whole pointer, " + found[0] + " or " + found[1]);
    }
    if (found.empty()) return std::nullopt;
    return found.front();
  }

  void add_parameter(const std::string& name, const std::string& pointer) {
    if (!columns_.groups.empty()) {
      problems_->reject_line(name, "stands after a column of counts", "write the parameters before the response modes");
    }
    const auto overlaps = [&pointer](const std::string& other) {
      return is_within(pointer, other) || is_within(other, pointer);
    };
    if (std::ranges::any_of(columns_.parameters, overlaps)) {
      problems_->reject_line(name, "is set by another column too", "keep one of them");
    }
    if (std::ranges::any_of(experiment_->unknowns, overlaps, &Unknown::pointer)) {
      problems_->reject_line(name, "is an unknown of the experiment", "omit the column, or the unknown");
    }
    columns_.parameters.push_back(pointer);
  }

  /// Absent where the name, which is reported, is not that of response modes.
  std::optional<std::vector<section::ResponseMode>> modes_named(const std::string& name) {
    std::vector<section::ResponseMode> modes;
    try {
      modes = modes_in_group(name, "");
    } catch (const base::InputError& error) {
      const base::Problem& problem = error.problems().front();
      const auto nearest = nearest_word(problem.value, known_words());
      problems_->reject_line(
          problem.value, "is neither a value of the experiment nor a response mode",
          nearest && *nearest != problem.value ? "did you mean \"" + *nearest + "\"?" : problem.remedy);
      return std::nullopt;
    }
    for (auto mode = modes.begin(); mode != modes.end(); ++mode) {
      if (std::find(modes.begin(), mode, *mode) == mode) continue;
      problems_->reject_line(name, "names a response mode twice", "write it once");
      return std::nullopt;
    }
    const auto is_seen = [this](const section::ResponseMode& mode) {
      return std::ranges::any_of(columns_.groups, [&mode](const ModeGroup& group) {
        return std::ranges::find(group.modes, mode) != group.modes.end();
      });
    };
    const bool has_other =
        std::ranges::any_of(columns_.groups, [](const ModeGroup& group) { return group.modes.empty(); });
    if (std::ranges::any_of(modes, is_seen) || (modes.empty() && has_other)) {
      problems_->reject_line(name, "has a mode that stands in an earlier column", "keep one of them");
    }
    return modes;
  }

  /// Names that a column may have, but for modes that are named by numbers.
  [[nodiscard]] std::vector<std::string> known_words() const {
    using Kind = section::ResponseKind;
    std::vector<std::string> words{"other"};
    for (int kind = static_cast<int>(Kind::periodic) + 1; kind <= static_cast<int>(Kind::unresolved); ++kind) {
      words.push_back(to_string(section::ResponseMode{.kind = static_cast<Kind>(kind)}));
    }
    for (const std::string& place : places_) words.push_back(last_key(place));
    return words;
  }

  void refuse_missing_parameters() {
    for (const Parameter& swept : experiment_->conditions.front().parameters) {
      if (std::ranges::find(columns_.parameters, swept.pointer) != columns_.parameters.end()) continue;
      problems_->reject_line(swept.pointer, "is swept by the experiment and has no column",
                             "add a column with its value in each condition, or omit the sweep");
    }
  }

  const Experiment* experiment_;
  std::vector<std::string> places_;
  LineProblems* problems_;
  TestColumns columns_;
};

}  // namespace

TestColumns read_test_columns(const std::vector<std::string>& names, const Experiment& experiment,
                              LineProblems& problems) {
  if (names.size() > most_test_columns) {
    problems.reject_line(std::to_string(names.size()) + " columns", "are too many",
                         "give at most " + std::to_string(most_test_columns));
    return {};
  }
  return ColumnReader(experiment, problems).read(names);
}

}  // namespace rocking
