#include <algorithm>

#include "rocking/output/parameter_text.hpp"
#include "rocking/output/response_event_text.hpp"
#include "rocking/studies/threshold/study.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::Cell;

/// Digits that the accuracy of an edge leaves, at most `most`.
int digits_of(double accuracy, int most) {
  int digits = 1;
  for (double unit = 0.1; digits < most && unit > accuracy; unit *= 0.1) ++digits;
  return digits;
}

/// Writes the answer about one condition.
class Sentence {
 public:
  explicit Sentence(const ThresholdQuestion& question)
      : question_(&question), digits_(digits_of(question.accuracy, 6)) {}

  [[nodiscard]] std::string of(const ThresholdBands& found) const {
    const std::string event = does(question_->event);
    if (found.bands.empty()) return "never " + event + " " + range();
    std::string text = event + " from " + number(found.bands.front()[0]) + " on";
    if (found.begins_inside()) text += ", where the range begins";
    const std::vector<std::string> gaps = standing(found);
    if (!gaps.empty()) text += question_->event.is_overturning() ? ", stands again " : ", not ";
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      text += (i == 0 ? "" : i + 1 == gaps.size() ? " and " : ", ") + gaps[i];
    }
    return text;
  }

  [[nodiscard]] std::string number(double value) const { return significant(value, digits_); }

  /// `for amplitude from 1 to 10`.
  [[nodiscard]] std::string range() const {
    return "for " + last_key(question_->of) + " from " + significant(*question_->from, 6) + " to " +
           significant(*question_->to, 6);
  }

 private:
  /// Where the block stands above the threshold: `from 6.743 to 7.493`.
  [[nodiscard]] std::vector<std::string> standing(const ThresholdBands& found) const {
    std::vector<std::string> parts;
    for (const auto& [low, high] : found.gaps()) parts.push_back("from " + number(low) + " to " + number(high));
    if (!found.ends_inside()) parts.push_back("from " + number(found.edges.back().stands.value) + " on");
    return parts;
  }

  const ThresholdQuestion* question_;
  int digits_;
};

/// The least threshold, and how many conditions have none or begin within a band.
std::string answer_of(const ThresholdStudy& study) {
  const Sentence sentence(study.question);
  if (study.conditions.size() == 1) return sentence.of(study.conditions.front().found);
  const std::string all = counted(study.conditions.size(), "combination");
  const ThresholdOfCondition* least = nullptr;
  std::size_t none = 0, inside = 0;
  for (const ThresholdOfCondition& condition : study.conditions) {
    inside += condition.found.begins_inside() ? 1 : 0;
    if (condition.found.bands.empty()) {
      ++none;
    } else if (least == nullptr || condition.found.bands.front()[0] < least->found.bands.front()[0]) {
      least = &condition;
    }
  }
  const std::string event = does(study.question.event);
  if (least == nullptr) return "never " + event + ' ' + sentence.range() + ", in all " + all;
  std::string text = event + " from " + sentence.number(least->found.bands.front()[0]) + " on at " +
                     values_of(least->parameters) + ", the least of " + all;
  if (inside > 0) text += "; in " + std::to_string(inside) + " the range begins inside a band";
  if (none > 0) text += "; never " + sentence.range() + " in " + std::to_string(none);
  return text;
}

/// The value, and the impacts on its two sides; nothing where a band begins or ends with the range.
look::Row end_cells(const ThresholdEdge* edge, double value, int digits) {
  if (edge == nullptr) return {look::number(value, digits), Cell(), Cell()};
  return {look::number(value, digits), look::whole(edge->happens.impacts), look::whole(edge->stands.impacts)};
}

void add_bands(const ThresholdOfCondition& condition, int digits, look::Table& table) {
  const ThresholdBands& found = condition.found;
  if (found.bands.empty()) {
    table.rows.push_back(row_of(condition.parameters, {"never", Cell(), Cell(), Cell(), Cell(), Cell()}));
  }
  const std::size_t first = found.begins_inside() ? 1 : 0;  // without an edge
  for (std::size_t i = 0; i < found.bands.size(); ++i) {
    const auto edge = [&](std::size_t end) -> const ThresholdEdge* {
      const std::size_t place = 2 * i + end;
      return place < first || place - first >= found.edges.size() ? nullptr : &found.edges[place - first];
    };
    look::Row cells = end_cells(edge(0), found.bands[i][0], digits);
    look::append(cells, end_cells(edge(1), found.bands[i][1], digits));
    table.rows.push_back(row_of(condition.parameters, cells));
  }
}

std::string notes_of(const ThresholdStudy& study) {
  const ThresholdQuestion& question = study.question;
  const double step = (*question.to - *question.from) / static_cast<double>(question.steps);
  std::size_t without = 0;
  for (const ThresholdOfCondition& condition : study.conditions) without += condition.found.without_answer.size();
  std::string text = "from, to: ends of a band of " + question.of + ", ";
  text += question.accuracy > 0.0 ? "to " + significant(question.accuracy, 2) + " of their value"
                                  : std::string("to neighbouring doubles");
  text +=
      "; impacts: inside, until the fall or the horizon;\nbelow, above: impacts just outside; -: the range ends "
      "there\nscanned in " +
      counted(question.steps, "step") + " of " + significant(step, 6) +
      ": a band or a gap that is narrower may be missed\n";
  if (without == 0) return text;
  return text + "at " + counted(without, "value") +
         " of the scan the motion ended without an answer, and is counted as standing\n";
}

}  // namespace

std::string threshold_table(const ThresholdStudy& study, Extent extent) {
  look::Table table =
      table_of(study.conditions.front().parameters, {"from", "impacts", "below", "to", "impacts", "above"});
  table.absent = "-";
  for (const ThresholdOfCondition& condition : study.conditions) {
    add_bands(condition, digits_of(study.question.accuracy, 10), table);
  }
  if (extent == Extent::one_screen && table.rows.size() > most_screen_rows) {
    table.notes = counted(table.rows.size() - most_screen_rows, "more row") + ": --all, and the file\n";
    table.rows.resize(most_screen_rows);
  }
  table.notes += notes_of(study);
  return answer_of(study) + "\n\n" + to_terminal(table);
}

}  // namespace rocking
