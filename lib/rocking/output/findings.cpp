#include "rocking/output/findings.hpp"

#include <algorithm>
#include <cstddef>

#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/overview.hpp"
#include "rocking/scene/restitution.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

/// Realisations with some property, of all conditions.
struct AllCases {
  std::uint64_t count = 0;
  std::string first;  ///< empty if there is none
};

AllCases cases_of(const Report& report, Cases Validity::*kind) {
  AllCases all;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const Cases& cases = report.conditions[i].result.validity.*kind;
    if (cases.count > 0 && all.count == 0) {
      all.first = "--condition " + std::to_string(i) + " --realisation " + std::to_string(cases.first.front());
    }
    all.count += cases.count;
  }
  return all;
}

struct Kind {
  Cases Validity::*cases;
  const char* name;
  const char* none;  ///< the text if there is none
  const char* some;  ///< after the number if there are some
  Rating rating;     ///< if there are some
};

constexpr std::array kinds_of_cases{
    Kind{&Validity::contradictions, "sticking and slipping",
         "at every instant one of the two was consistent with the equations",
         " had an instant at which neither is consistent with the equations", Rating::look},
    Kind{&Validity::in_transient, "settled at the horizon", "every response had settled at the horizon",
         " had not settled at the horizon", Rating::look},
    Kind{&Validity::past_balance, "beyond the balance point", "|Theta| was below 1 throughout", " passed |Theta| = 1",
         Rating::note}};

Finding finding_of(const Report& report, const Kind& kind) {
  const AllCases cases = cases_of(report, kind.cases);
  if (cases.count == 0) return {.name = kind.name, .rating = Rating::fine, .text = kind.none};
  return {.name = kind.name,
          .rating = kind.rating,
          .text = counted(cases.count, "realisation") + kind.some,
          .place = cases.first};
}

/// A loss of contact in the final fall of a block that overturns cannot change its response; one before it can.
Finding contact(const Report& report) {
  const AllCases all = cases_of(report, &Validity::left_ground);
  const AllCases before = cases_of(report, &Validity::left_ground_before_fall);
  const char* name = "contact with the base";
  if (before.count > 0) {
    return {.name = name,
            .text = counted(before.count, "realisation") +
                    " lost contact with the base (normal force of zero or less) before any final fall; the model does "
                    "not hold there",
            .remedy = "do not rely on the response modes of these realisations",
            .place = before.first};
  }
  if (all.count == 0) return {.name = name, .rating = Rating::fine, .text = "the normal force was positive throughout"};
  return {.name = name,
          .rating = Rating::fine,
          .text = counted(all.count, "realisation") + " lost contact only in the final fall of a block that overturned",
          .place = all.first};
}

Finding answers(const Report& report) {
  const AllCases painleve = cases_of(report, &Validity::painleve), stopped = cases_of(report, &Validity::stopped);
  const std::uint64_t ended = painleve.count + stopped.count;
  Finding found{.name = "end of the realisations", .place = stopped.count > 0 ? stopped.first : painleve.first};
  std::uint64_t unknown = 0;
  for (const ReportedCondition& condition : report.conditions) unknown += condition.result.without_answer();
  const std::string causes = painleve.count > 0 ? ", " + std::to_string(painleve.count) + " by Painleve's paradox" : "";
  if (ended == 0) {
    found.rating = Rating::fine;
    found.text = "every realisation reached its horizon or overturned";
  } else if (unknown == 0) {
    found.rating = Rating::note;
    found.text = counted(ended, "realisation") + " ended before their horizon, classified" + causes;
  } else {
    found.text = std::to_string(unknown) + " of " + counted(realisations_of(report), "realisation") +
                 " ended before their horizon without an answer" + causes +
                 ": whether they overturn is not known. They are unresolved, and the upper end of each interval counts "
                 "them as well";
    found.remedy =
        "against a budget of steps: less slip in a cell of friction or in a period (larger "
        "/fluctuation/friction/refresh_slip_m)";
  }
  return found;
}

Finding late_settling(const Report& report) {
  Finding found{.name = std::string(late_settling_check), .rating = Rating::fine, .text = "no response"};
  const AllCases late = cases_of(report, &Validity::settled_late);
  if (late.count == 0) return found;
  double least_held = 1.0;
  for (const ReportedCondition& each : report.conditions) {
    least_held = std::min(least_held, each.result.validity.least_held);
  }
  found.rating = Rating::note;
  found.text = counted(late.count, "realisation") + ", classified by the last " + significant(100.0 * least_held, 3) +
               " % of their sampled periods or more";
  found.place = late.first;
  return found;
}

std::optional<Finding> restitution(const Report& report) {
  RateRatios ratios;
  for (const ReportedCondition& condition : report.conditions) ratios.add(condition.asked.scene);
  if (!ratios.doubt()) return std::nullopt;
  return Finding{.name = "restitution", .text = ratios.text(), .place = "/restitution"};
}

/// That the balance was the end of motions: "until": "balance".
std::optional<Finding> end_at_balance(const Report& report) {
  const auto asks = [](const ReportedCondition& each) { return each.asked.horizon.until == MotionEnd::balance; };
  const AllCases ended = cases_of(report, &Validity::past_balance);
  if (ended.count == 0 || std::ranges::none_of(report.conditions, asks)) return std::nullopt;
  return Finding{.name = "end at the balance",
                 .rating = Rating::note,
                 .text = counted(ended.count, "realisation") +
                         " ended at |Theta| = 1, as overturned; a base that moves on may bring such a block back",
                 .remedy = "to see how many overturn, omit \"until\"",
                 .place = ended.first};
}

std::optional<Finding> reading(const std::vector<UsedGroundMotion>& motions) {
  Finding found{.name = "reading of the ground motions"};
  std::size_t number = 0;
  for (const UsedGroundMotion& used : motions) {
    if (used.facts.warnings.empty() || ++number > 1) continue;
    found.text = used.facts.file + ": " + used.facts.warnings.front();
    if (used.facts.warnings.size() > 1) found.text += "; and more";
  }
  if (number == 0) return std::nullopt;
  if (number > 1) found.text += "; and " + counted(number - 1, "further file") + ", as report.json tells";
  return found;
}

}  // namespace

std::optional<Finding> left_out_records(const std::vector<std::string>& names) {
  if (names.empty()) return std::nullopt;
  std::string text = counted(names.size(), "record") + " of the suite could not be read and " +
                     (names.size() == 1 ? "was" : "were") + " left out:";
  for (const std::string& name : names) text += (&name == names.data() ? " " : ", ") + name;
  return Finding{.name = "records of the suite", .text = text + ". The probabilities are those of the others"};
}

std::string in_words(const Finding& finding) {
  const auto& [name, rating, text, remedy, place] = finding;
  const bool is_key = place.starts_with('/');
  return (is_key ? place + ": " : "") + text + (place.empty() || is_key ? "" : " (" + place + ')') +
         (remedy.empty() ? "" : "; " + remedy);
}

std::string in_words(const std::optional<Finding>& finding) { return finding ? in_words(*finding) : ""; }

std::string warning_lines(const std::vector<Finding>& findings) {
  std::string lines;
  for (const Finding& each : findings) {
    if (each.rating == Rating::look) lines += "warning: " + in_words(each) + '\n';
  }
  return lines;
}

std::vector<Finding> findings_of(const Report& report) {
  std::vector<Finding> findings = precision_findings(report);
  findings.insert(findings.end(), {contact(report), answers(report)});
  for (const Kind& kind : kinds_of_cases) findings.push_back(finding_of(report, kind));
  findings.push_back(late_settling(report));
  findings.push_back(clamped_numbers(report));
  for (auto& found : {left_out_records(report.left_out), far_scaled(report.ground_motions),
                      reading(report.ground_motions), restitution(report), end_at_balance(report)}) {
    if (found) findings.push_back(*found);
  }
  return findings;
}

template <>
struct TypeOf<Rating> : OnlyType<NamedType<Rating, rating_names>> {};

const StructType& fields_of(const Finding*) {
  static const StructType fields{
      "Finding",
      field<&Finding::name>("name", "what was looked at"),
      field<&Finding::rating>("rating", "whether it needs a look"),
      field<&Finding::text>("text", "what was found"),
      field<&Finding::remedy>("remedy", "what to do, or empty"),
      field<&Finding::place>("place",
                             "JSON pointer, or flags of `rocking trajectory` for the first such realisation, or empty"),
  };
  return fields;
}

}  // namespace rocking
