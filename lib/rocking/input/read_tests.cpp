#include "rocking/input/read_tests.hpp"

#include <algorithm>
#include <charconv>
#include <functional>
#include <numeric>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/base/utf8.hpp"
#include "rocking/input/condition_family.hpp"
#include "rocking/input/csv_table.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

/// Of the value in a problem, which is JSON, what stands in the file.
std::string as_written(const std::string& value) {
  const Json json = Json::parse(value, nullptr, false);
  return json.is_string() ? json.get<std::string>() : value;
}

/// Equal numbers may be written in different ways.
bool are_equal(const std::vector<Parameter>& a, const std::vector<Parameter>& b) {
  return std::ranges::equal(a, b, [](const Parameter& one, const Parameter& other) {
    return one.value == other.value || json_of(one.value) == json_of(other.value);
  });
}

/// All combinations of the ends of the unknowns, and a point between them that no whole number is.
std::vector<std::vector<Parameter>> samples(const std::vector<Unknown>& unknowns) {
  std::vector<std::vector<Parameter>> all;
  for (unsigned corner = 0; corner < (1U << unknowns.size()); ++corner) {
    std::vector<Parameter> at;
    for (std::size_t k = 0; k < unknowns.size(); ++k) {
      at.push_back({unknowns[k].pointer, (corner >> k) & 1U ? unknowns[k].to : unknowns[k].from});
    }
    all.push_back(std::move(at));
  }
  all.emplace_back();
  for (const Unknown& unknown : unknowns) {
    const double between = std::lerp(unknown.from, unknown.to, 0.381966);
    all.back().push_back({unknown.pointer, between});
  }
  return all;
}

std::string setting_in_words(const std::vector<Parameter>& values) {
  std::string words;
  for (const Parameter& each : values)
    words += (words.empty() ? "" : ", ") + each.pointer + " = " + json_text_of(each.value);
  return words;
}

/// That of the sweep for the same value; empty: it has none.
std::string name_in_sweep(const Experiment& experiment, const Parameter& tested) {
  for (const Condition& condition : experiment.conditions) {
    const auto swept = std::ranges::find(condition.parameters, tested);
    if (swept != condition.parameters.end()) return swept->name;
  }
  return "";
}

class TestReader {
 public:
  TestReader(const std::string& name, const Experiment& experiment, const std::filesystem::path& folder)
      : experiment_(&experiment),
        condition_at_(ConditionMaker(experiment, seen_from(folder))),
        lines_(name, problems_) {}

  /// `has_counts`: of tests; else of candidates.
  void read(std::string_view text, bool has_counts) {
    if (text.size() > most_tests_bytes) lines_.reject_file("is longer than 1 MB", "give one line for each condition");
    text = without_byte_order_mark(text);
    check_unknowns();
    CsvTable rows(text, lines_);
    if (rows.next()) {
      columns_ = read_test_columns(rows.fields(), *experiment_, lines_);
      check_columns(has_counts);
    }
    for (bool goes_on = !lines_.any(); goes_on && rows.next(); goes_on = conditions_.size() <= most_tested_conditions) {
      read_condition(rows.fields(), has_counts);
    }
    if (conditions_.size() > most_tested_conditions) {
      lines_.reject_file("has more than " + std::to_string(most_tested_conditions) + " conditions", "omit some");
    }
    if (!lines_.any() && conditions_.empty()) {
      lines_.reject_file("has no conditions", "write the names of the columns, and a line for each condition");
    }
    if (!problems_.empty()) throw base::InputError(std::move(problems_));
  }

  [[nodiscard]] std::vector<ModeGroup>& groups() { return columns_.groups; }
  [[nodiscard]] std::vector<TestedCondition>& conditions() { return conditions_; }

 private:
  void check_columns(bool has_counts) {
    if (has_counts && columns_.groups.empty() && !lines_.any()) {
      lines_.reject_file("has no column of a response mode", "add columns such as \"(1,1)\" with the counts of tests");
    }
    if (!has_counts && !columns_.groups.empty()) {
      lines_.reject_line(columns_.groups.front().name, "is a column of counts",
                         "give the parameters of candidates alone");
    }
  }

  void read_condition(const std::vector<std::string>& fields, bool has_counts) {
    TestedCondition condition;
    std::string parameters;
    for (std::size_t i = 0; i < columns_.parameters.size(); ++i) {
      condition.parameters.push_back({columns_.parameters[i], value_of(fields[i])});
      condition.parameters.back().name = name_in_sweep(*experiment_, condition.parameters.back());
      parameters += (i == 0 ? "" : ", ") + fields[i];
    }
    for (std::size_t i = columns_.parameters.size(); i < fields.size(); ++i)
      condition.counts.push_back(count(fields[i]));
    const auto same = std::ranges::find_if(
        conditions_, [&](const TestedCondition& other) { return are_equal(other.parameters, condition.parameters); });
    if (same != conditions_.end()) {
      lines_.reject_line(
          parameters,
          "stands in line " +
              std::to_string(lines_of_conditions_[static_cast<std::size_t>(same - conditions_.begin())]) + " too",
          has_counts ? "add up the counts in one line" : "omit one of them");
    }
    if (has_counts && std::accumulate(condition.counts.begin(), condition.counts.end(), std::uint64_t{0}) == 0) {
      lines_.reject_line(parameters, "has no tests", "omit the line, or give the condition among the candidates");
    }
    if (!lines_.any()) check_values(condition.parameters);
    conditions_.push_back(std::move(condition));
    lines_of_conditions_.push_back(lines_.line());
  }

  /// The field as a JSON value: a number, `true`, an object; else text.
  SweptValue value_of(std::string_view field) {
    const bool is_number = is_number_field(field);
    if (is_number && field.starts_with('+')) field.remove_prefix(1);
    try {
      return swept_value(parse_json(field));
    } catch (const base::InputError& error) {
      const bool is_json = is_number || field.starts_with('{') || field.starts_with('[') || field.starts_with('"');
      if (is_json) lines_.reject_line(field, error.problems().front().reason, error.problems().front().remedy);
    }
    if (field.empty()) lines_.reject_line(field, "is an empty field", "give a value, or omit the column");
    if (base::is_utf8(field)) return std::string(field);
    lines_.reject_line(field, "is not text in UTF-8", "convert the file to UTF-8");
    return {};
  }

  std::uint64_t count(const std::string& field) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error == std::errc() && end == field.data() + field.size() && value <= most_tests) return value;
    lines_.reject_line(field, "is not a number of tests", "give a whole number, 0 where there was none");
    return 0;
  }

  void check_unknowns() const {
    for (const std::vector<Parameter>& at : samples(experiment_->unknowns)) {
      try {
        static_cast<void>(condition_at_(at));
      } catch (const base::InputError& error) {
        const base::Problem& first = error.problems().front();
        throw base::InputError({"/unknown", setting_in_words(at), "is not allowed: " + first.place + ' ' + first.reason,
                                "change \"from\" or \"to\""});
      }
    }
  }

  /// Whether the experiment allows them, wherever the unknowns are.
  void check_values(const std::vector<Parameter>& values) {
    for (const std::vector<Parameter>& at : samples(experiment_->unknowns)) {
      std::vector<Parameter> all = values;
      all.insert(all.end(), at.begin(), at.end());
      try {
        static_cast<void>(condition_at_(all));
      } catch (const base::InputError& error) {
        const base::Problem& first = error.problems().front();
        lines_.reject_line(as_written(first.value),
                           first.place + " " + first.reason + " (with " + setting_in_words(at) + ")", first.remedy);
        return;
      }
    }
  }

  const Experiment* experiment_;
  std::function<Condition(const std::vector<Parameter>&)> condition_at_;
  Problems problems_;
  LineProblems lines_;
  TestColumns columns_;
  std::vector<TestedCondition> conditions_;
  std::vector<std::size_t> lines_of_conditions_;
};

/// The group of all modes that no other has comes last.
void put_others_last(CountedTests& tests) {
  const auto others = std::ranges::find_if(tests.groups, [](const ModeGroup& group) { return group.modes.empty(); });
  const auto place = others - tests.groups.begin();
  if (others == tests.groups.end()) {
    tests.groups.push_back({.name = "other", .modes = {}});
    for (TestedCondition& condition : tests.conditions) condition.counts.push_back(0);
    return;
  }
  std::rotate(others, others + 1, tests.groups.end());
  for (TestedCondition& condition : tests.conditions) {
    std::rotate(condition.counts.begin() + place, condition.counts.begin() + place + 1, condition.counts.end());
  }
}

}  // namespace

CountedTests read_tests(std::string_view text, const std::string& name, const Experiment& experiment,
                        const std::filesystem::path& folder) {
  TestReader reader(name, experiment, folder);
  reader.read(text, true);
  CountedTests tests{.groups = std::move(reader.groups()), .conditions = std::move(reader.conditions())};
  put_others_last(tests);
  return tests;
}

void read_candidates(std::string_view text, const std::string& name, const Experiment& experiment,
                     const std::filesystem::path& folder, CountedTests& tests) {
  TestReader reader(name, experiment, folder);
  reader.read(text, false);
  tests.candidates = std::move(reader.conditions());
}

}  // namespace rocking
