#include <algorithm>
#include <cmath>

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

int digits_of(const ThresholdQuestion& question, int most) {
  return question.probability ? 3 : digits_of(*question.accuracy, most);
}

/// The value at a side of an edge; of a random scene, `[4.31, 4.4]`, between both.
std::string value_at(const ThresholdEdge& edge, double side, const ThresholdQuestion& question, int digits) {
  if (!question.probability) return significant(side, digits);
  const auto [low, high] = std::minmax(edge.stands.value, edge.happens.value);
  return '[' + significant(low, digits) + ", " + significant(high, digits) + ']';
}

/// Writes the answer about one condition.
class Sentence {
 public:
  explicit Sentence(const ThresholdStudy& study)
      : question_(&study.question),
        event_("the block " + what_happens(study.question, in_degrees(study.question.event, study.balance))),
        digits_(digits_of(study.question, 6)) {}

  [[nodiscard]] std::string of(const ThresholdBands& found) const {
    if (found.bands.empty()) return nowhere();
    std::string text = event_ + " from " + threshold(found) + " on";
    if (found.begins_inside()) text += ", where the range begins";
    const std::vector<std::string> gaps = standing(found);
    const bool stands = question_->event.is_overturning() && !question_->probability;
    if (!gaps.empty()) text += stands ? ", stands again " : ", not ";
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      text += (i == 0 ? "" : i + 1 == gaps.size() ? " and " : ", ") + gaps[i];
    }
    return text;
  }

  /// The same of a study whose least threshold this is.
  [[nodiscard]] std::string of_least(const ThresholdOfCondition& least) const {
    return event_ + " from " + threshold(least.found) + " on at " + values_of(least.parameters);
  }
  [[nodiscard]] std::string nowhere() const { return event_ + " nowhere " + range(); }

  /// Where the first band begins.
  [[nodiscard]] std::string threshold(const ThresholdBands& found) const {
    const double value = found.bands.front()[0];
    return found.begins_inside() ? significant(value, digits_) : side(found.edges.front(), value);
  }

  /// `for amplitude from 1 to 10`.
  [[nodiscard]] std::string range() const {
    return "for " + last_key(question_->of) + " from " + significant(*question_->from, 6) + " to " +
           significant(*question_->to, 6);
  }

 private:
  [[nodiscard]] std::string side(const ThresholdEdge& edge, double value) const {
    return value_at(edge, value, *question_, digits_);
  }

  /// Where the block stands above the threshold: `from 6.743 to 7.493`.
  [[nodiscard]] std::vector<std::string> standing(const ThresholdBands& found) const {
    std::vector<std::string> parts;
    const auto& edges = found.edges;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (edges[i].begins_band()) continue;
      const std::string low = side(edges[i], edges[i].stands.value);
      const bool ends = i + 1 == edges.size();
      parts.push_back("from " + low + (ends ? " on" : " to " + side(edges[i + 1], edges[i + 1].stands.value)));
    }
    return parts;
  }

  const ThresholdQuestion* question_;
  std::string event_;
  int digits_;
};

/// The least threshold, and how many conditions have none or begin within a band.
std::string answer_of(const ThresholdStudy& study) {
  const Sentence sentence(study);
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
  if (least == nullptr) return sentence.nowhere() + ", in all " + all;
  std::string text = sentence.of_least(*least) + ", the least of " + all;
  if (inside > 0) text += "; in " + std::to_string(inside) + " the range begins inside a band";
  if (none > 0) text += "; nowhere " + sentence.range() + " in " + std::to_string(none);
  return text;
}

/// The value, and on its two sides the impacts, or of a random scene the share of the realisations; nothing where a band
/// begins or ends with the range.
look::Row end_cells(const ThresholdEdge* edge, double value, const ThresholdQuestion& question) {
  const int digits = digits_of(question, 10);
  if (edge == nullptr) return {look::number(value, digits), Cell(), Cell()};
  if (!question.probability) {
    return {look::number(value, digits), look::whole(edge->happens.impacts), look::whole(edge->stands.impacts)};
  }
  const auto share = [](const ThresholdPoint& point) {
    return per_cent_of(point.counts.successes, point.counts.trials);
  };
  return {value_at(*edge, value, question, digits), share(edge->happens), share(edge->stands)};
}

void add_bands(const ThresholdOfCondition& condition, const ThresholdQuestion& question, look::Table& table) {
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
    look::Row cells = end_cells(edge(0), found.bands[i][0], question);
    look::append(cells, end_cells(edge(1), found.bands[i][1], question));
    table.rows.push_back(row_of(condition.parameters, cells));
  }
}

/// What the columns say, and how near an end is known.
std::string meaning_of(const ThresholdQuestion& question) {
  if (question.probability) {
    return "from, to: ends of a band of " + question.of +
           ", [95 % interval]; %: of the realisations, at the end of an interval\ninside the band; below, above: at "
           "its other end; -: the range ends there\n";
  }
  return "from, to: ends of a band of " + question.of + ", " +
         (*question.accuracy > 0.0 ? "to " + significant(*question.accuracy, 2) + " of their value"
                                   : std::string("to neighbouring doubles")) +
         "; impacts: inside, until the fall or the horizon;\nbelow, above: impacts just outside; -: the range ends "
         "there\n";
}

/// Edges whose interval is wider than asked for.
std::size_t wide_edges(const ThresholdStudy& study) {
  std::size_t count = 0;
  for (const ThresholdOfCondition& condition : study.conditions) {
    for (const ThresholdEdge& edge : condition.found.edges) {
      const auto [low, high] = std::minmax(edge.stands.value, edge.happens.value);
      count += high - low > *study.question.accuracy * std::max(std::abs(low), std::abs(high)) ? 1 : 0;
    }
  }
  return count;
}

std::string notes_of(const ThresholdStudy& study) {
  const ThresholdQuestion& question = study.question;
  const double step = (*question.to - *question.from) / static_cast<double>(*question.steps);
  std::size_t without = 0;
  for (const ThresholdOfCondition& condition : study.conditions) without += condition.found.without_answer.size();
  std::string text = meaning_of(question) + "scanned in " + counted(*question.steps, "step") + " of " +
                     significant(step, 6) + ": a band or a gap that is narrower may be missed\n";
  if (question.probability) {
    if (const std::size_t wide = wide_edges(study); wide > 0) {
      text += counted(wide, "interval") + " wider than " + significant(*question.accuracy, 2) + " of the value with " +
              std::to_string(question.realisations) + " realisations: --realisations\n";
    }
    if (without > 0) {
      text += "at " + counted(without, "value") + " of the scan the probability was not told from " +
              significant(*question.probability, 3) + ": --realisations\n";
    }
    return text;
  }
  if (without == 0) return text;
  return text + "at " + counted(without, "value") +
         " of the scan the motion ended without an answer, and is counted as standing\n";
}

}  // namespace

std::string what_happens(const ThresholdQuestion& question, const std::string& degrees) {
  const std::string event = does(question.event) + degrees;
  if (!question.probability) return event;
  return event + " with a probability above " + significant(100.0 * *question.probability, 3) + " %";
}

std::string threshold_table(const ThresholdStudy& study, Extent extent) {
  const std::string inside = study.question.probability ? "%" : "impacts";
  look::Table table = table_of(study.conditions.front().parameters, {"from", inside, "below", "to", inside, "above"});
  table.absent = "-";
  for (const ThresholdOfCondition& condition : study.conditions) add_bands(condition, study.question, table);
  if (extent == Extent::one_screen && table.rows.size() > most_screen_rows) {
    table.notes = counted(table.rows.size() - most_screen_rows, "more row") + ": --all, and the file\n";
    table.rows.resize(most_screen_rows);
  }
  table.notes += notes_of(study);
  return answer_of(study) + "\n\n" + to_terminal(table);
}

}  // namespace rocking
