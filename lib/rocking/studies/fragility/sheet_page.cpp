#include "rocking/studies/fragility/sheet.hpp"

#include <cmath>

#include <fmt/format.h>

#include "analysis/page/html.hpp"
#include "analysis/page/sections.hpp"
#include "analysis/page/words.hpp"
#include "analysis/quantity.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/output/alarms.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/studies/fragility/words.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

const std::vector<double> usual_horizons{1.0, 50.0, 475.0};  // [years]
constexpr std::size_t most_records_named = 30;
constexpr std::size_t most_options = 5;

std::string last_part(const std::string& path) { return path.substr(path.rfind('/') + 1); }

/// `5.2 &times; 10<sup>-4</sup>`.
std::string power_of_ten(double value) {
  if (!(value > 0.0)) return "0";
  if (value >= 0.01) return significant(value, 2);
  const std::string text = fmt::format("{:.1e}", value);  // 5.2e-04
  const std::size_t e = text.find('e');
  return fmt::format("{}&nbsp;&times;&nbsp;10<sup>&minus;{}</sup>", text.substr(0, e), std::stoi(text.substr(e + 2)));
}

/// With two digits, also if the second is a zero: `22`, `1.0`, `0.020`.
std::string two_digits(double value) {
  if (value >= 9.95 || !(value > 0.0)) return fmt::format("{:.0f}", value);
  return fmt::format("{:#.2g}", value);
}

/// Of a rate, the probability that the event happens within so many years, in per cent.
std::string within(double years, double rate) { return two_digits(-100.0 * std::expm1(-rate * years)); }

std::string to(const std::string& low, const std::string& high) { return low + " to " + high; }

std::string option_of(const std::vector<Parameter>& parameters) {
  std::string text;
  for (const Parameter& parameter : parameters) {
    text += (text.empty() ? "" : ", ") + place_html(parameter.pointer, json_of(parameter.value));
  }
  return text;
}

/// The block from the front, in millimetres on the paper.
class SheetDrawing {
 public:
  explicit SheetDrawing(const BlockOutline& block)
      : block_(block), wide_(block.right() - block.left()), high_(block.top()) {
    constexpr std::array scales{1.0, 2.0, 5.0, 10.0, 20.0, 25.0, 50.0, 100.0, 200.0, 500.0, 1000.0};
    const auto fits = [&](double scale) { return wide_ <= 0.034 * scale && high_ <= 0.044 * scale; };
    const auto found = std::ranges::find_if(scales, fits);
    scale_ = found == scales.end() ? std::ceil(std::max(wide_ / 0.034, high_ / 0.044)) : *found;
  }

  [[nodiscard]] std::string svg() const {
    std::string parts;
    for (const auto& [left, right, bottom, top] : block_.rectangles) {
      parts += fmt::format(
          "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"#dddddd\" "
          "stroke=\"#000\" stroke-width=\".35\"{}/>\n",
          x(left), y(top), x(right) - x(left), y(bottom) - y(top),
          block_.is_given ? "" : " stroke-dasharray=\"1.5 .7\"");
    }
    if (!block_.is_plain()) {
      parts += fmt::format("<path d=\"M{:.2f} {} H{:.2f}\" stroke=\"#000\" stroke-width=\"1.2\"/>\n", x(0.0), floor,
                           x(block_.base));
    }
    return fmt::format(
        "<svg width=\"62mm\" height=\"53mm\" viewBox=\"0 3 62 53\" role=\"img\" aria-label=\"The block, {0} m wide and "
        "{1} m high, to the scale 1 : {2}\">\n{3}<path d=\"M4 {4} H58\" stroke=\"#000\" "
        "stroke-width=\".5\"/>\n<path d=\"M{5:.2f} {4} L{6:.2f} {7:.2f}{8}\" fill=\"none\" stroke=\"#000\" "
        "stroke-width=\".2\" "
        "stroke-dasharray=\"1 .7\"/>\n<circle cx=\"{6:.2f}\" cy=\"{7:.2f}\" r=\".7\"/>\n{9}\n</svg>",
        significant(wide_, 4), significant(high_, 4), significant(scale_, 4), parts, floor, x(block_.base),
        x(block_.centre_x), y(block_.centre_height), is_even() ? "" : fmt::format(" L{:.2f} {}", x(0.0), floor),
        labels());
  }

 private:
  static constexpr double floor = 47.0;

  [[nodiscard]] double x(double metres) const {
    return 31.0 + 1000.0 * (metres - 0.5 * (block_.left() + block_.right())) / scale_;
  }
  [[nodiscard]] double y(double metres) const { return floor - 1000.0 * metres / scale_; }
  /// Whether both edges are as far from the centre of mass.
  [[nodiscard]] bool is_even() const { return block_.centre_x == 0.5 * block_.base; }

  /// The distance of the edges, or that of each from the centre of mass, and the height: that of the centre of mass where no
  /// other is known.
  [[nodiscard]] std::string labels() const {
    const double left = x(0.0), right = x(block_.base), side = x(block_.left());
    const double high = block_.is_given ? high_ : block_.centre_height;
    const std::string middle = is_even() ? "" : fmt::format(" M{:.2f} 49 V50.4", x(block_.centre_x));
    const std::string width =
        is_even() ? significant(block_.base, 4)
                  : significant(block_.centre_x, 3) + " + " + significant(block_.base - block_.centre_x, 3);
    return fmt::format(
        "<path d=\"M{0:.2f} 49 V50.4 M{1:.2f} 49 V50.4{12} M{0:.2f} 49.7 H{1:.2f} M{2:.2f} {3:.2f} H{4:.2f} M{2:.2f} "
        "{5} "
        "H{4:.2f} M{6:.2f} {3:.2f} V{5}\" fill=\"none\" stroke=\"#000\" stroke-width=\".2\"/>\n<text x=\"{13:.2f}\" "
        "y=\"53\" "
        "font-size=\"2.8\" text-anchor=\"middle\">{7} m</text>\n<text x=\"{8:.2f}\" y=\"{9:.2f}\" font-size=\"2.8\" "
        "text-anchor=\"end\">{10} m</text>\n<text x=\"58\" y=\"55.5\" font-size=\"2.6\" text-anchor=\"end\">scale 1 : "
        "{11}</text>",
        left, right, side - 3.0, y(high), side - 1.6, floor, side - 2.3, width, side - 3.6,
        0.5 * (floor + y(high)) + 1.0, significant(high, 4), significant(scale_, 4), middle, 0.5 * (left + right));
  }

  BlockOutline block_;
  double wide_, high_, scale_ = 1.0;
};

std::string drawing(const Report& run) {
  return SheetDrawing(outline_of(run.conditions.front().asked.scene.block)).svg();
}

/// What the sheet is about.
const ResponseEvent& event_of(const SheetContent& sheet) { return sheet.suites.front().curve.subject.event; }

std::string answer(const SheetContent& sheet) {
  const ReportedSuite& object = sheet.suites.front();
  const AnnualRate& rate = object.rate->chosen;
  const std::string as = object.curve.subject.others.empty() || sheet.suites.size() == 1
                             ? ""
                             : " (" + option_of(object.curve.subject.others) + ")";
  if (!(rate.value > 0.0)) {
    return fmt::format(
        "<p class=\"answer\">The object{} did not {} under any of the records at these levels. Stronger "
        "shaking was not tested: the rate may be up to once in {} years.</p>",
        as, to_do(object.curve.subject.event), years_in_words(1.0 / rate.interval.value().high));
  }
  std::string interval;
  if (rate.interval) {
    const std::string least = years_in_words(1.0 / rate.interval->high);
    interval = fmt::format(
        " ({} % interval: {} years)", significant(100.0 * object.curve.subject.confidence, 4),
        rate.interval->low > 0.0 ? to(least, years_in_words(1.0 / rate.interval->low)) : "at least " + least);
  }
  return fmt::format(
      "<p class=\"answer\">The object{} {} <strong>once in about {} years</strong>{}: with probability "
      "<strong>{} %</strong> within 50 years.</p>",
      as, does(object.curve.subject.event), years_in_words(1.0 / rate.value), interval, within(50.0, rate.value));
}

/// Whether the blocks still stand, where that is asked.
std::string survived(const SheetContent& sheet) {
  if (!sheet.survival) return "";
  std::string words = survival_in_words(*sheet.survival);
  words.front() = 'P';
  std::string text = fmt::format("<p class=\"answer\">{}.</p>\n", escaped(words));
  if (sheet.survival->branches.size() < 2) return text;
  text += "<p class=\"small\">Weights of the hazard curves:";
  for (const SurvivalBranch& branch : sheet.survival->branches) {
    text += fmt::format(" {} {}{}", escaped(last_part(branch.hazard)), two_digits(branch.weight),
                        &branch == &sheet.survival->branches.back() ? ".</p>\n" : ",");
  }
  return text;
}

/// The period of a spectral acceleration, or its range.
std::string periods_sentence(const std::vector<double>& periods) {
  if (periods.empty()) return "";
  const bool is_range = periods.size() > 1;
  return fmt::format(" The spectral acceleration is that at {}T = {}{} s.", is_range ? "periods " : "",
                     significant(periods.front(), 4), is_range ? " to " + significant(periods.back(), 4) : "");
}

std::string motions(const SheetContent& sheet) {
  const std::vector<RecordCurve>& records = sheet.suites.front().curve.records;
  std::string names;
  for (std::size_t i = 0; i < std::min(records.size(), most_records_named); ++i) {
    names += (i == 0 ? "" : ", ") + escaped(last_part(records[i].name));
  }
  if (records.size() > most_records_named) names += fmt::format(", and {} more", records.size() - most_records_named);
  const auto missing = left_out_records(sheet.run.left_out);
  return fmt::format(
             "<h2>Hazard and records</h2>\n<p>{}: {}.{}</p>\n<p class=\"small\">{} records, each scaled to {} levels "
             "from {} to {}: {}.</p>\n",
             escaped(last_part(sheet.hazard.name)), escaped(hazard_in_words(sheet.hazard)),
             periods_sentence(sheet.periods), records.size(), sheet.suites.front().curve.levels.size(),
             significant(sheet.suites.front().curve.levels.front().intensity, 3),
             significant(sheet.suites.front().curve.levels.back().intensity, 3), names) +
         (missing ? fmt::format("<p class=\"small\">{}.</p>\n", escaped(*missing)) : "");
}

std::string curve(const SheetContent& sheet) {
  if (sheet.curve_png.empty()) return "";
  return fmt::format(
      "<h2>Probability of {0}</h2>\n<div class=\"curve\"><img src=\"{1}\" alt=\"Probability of {0} as a function of "
      "the "
      "intensity\"></div>\n",
      words_of(event_of(sheet)), data_address("png", sheet.curve_png));
}

/// A number with its interval below; `falls`: where the number falls with the rate.
template <class Shown>
std::string cell(double value, const std::optional<stats::Interval>& interval, Shown&& shown, bool falls = false) {
  std::string text = shown(value);
  if (interval) {
    const std::string low = shown(interval->low);
    const std::string high = std::isfinite(interval->high) ? shown(interval->high) : "&infin;";
    text += "<br><span class=\"small\">" + (falls ? to(high, low) : to(low, high)) + "</span>";
  }
  return "<td>" + text + "</td>";
}

/// Those that are asked for, or the usual ones [years].
std::vector<double> horizons(const SheetContent& sheet) {
  std::vector<double> years;
  for (const RateInYears& each : sheet.suites.front().rate->chosen.in_years) years.push_back(each.years);
  return years.empty() ? usual_horizons : years;
}

std::string rate_cells(const AnnualRate& rate, const std::vector<double>& horizons) {
  const auto years = [](double value) { return value > 0.0 ? years_in_words(1.0 / value) : std::string("&infin;"); };
  std::string cells = cell(rate.value, rate.interval, power_of_ten) + cell(rate.value, rate.interval, years, true);
  for (const double horizon : horizons) {
    cells += cell(rate.value, rate.interval, [horizon](double value) { return within(horizon, value); });
  }
  return cells;
}

/// The rate of an option as a factor of that of the first one.
std::string factor_cell(const SheetContent& sheet, const ReportedSuite& suite) {
  for (const auto& [run, found] : sheet.comparisons) {
    const bool is_same = option_of(found.option) == option_of(suite.curve.subject.others);
    if (is_same) return found.ratio ? cell(*found.ratio, found.ratio_interval, two_digits) : "<td>unknown</td>";
  }
  return "<td>1</td>";
}

std::string rates(const SheetContent& sheet) {
  const bool has_options = !sheet.comparisons.empty();
  std::string rows, headings;
  for (const double years : horizons(sheet)) {
    headings += fmt::format("<th>in {} {} [%]</th>", significant(years, 6), years == 1.0 ? "year" : "years");
  }
  for (std::size_t i = 0; i < std::min(sheet.suites.size(), most_options); ++i) {
    const ReportedSuite& suite = sheet.suites[i];
    const std::string values = option_of(suite.curve.subject.others);
    rows += "<tr><th>" + (values.empty() ? words_of(event_of(sheet)) : values) + "</th>" +
            rate_cells(suite.rate->chosen, horizons(sheet)) + (has_options ? factor_cell(sheet, suite) : "") +
            "</tr>\n";
  }
  const std::string omitted =
      sheet.suites.size() > most_options
          ? fmt::format("<p class=\"small\">{} more options are in the output of the command.</p>\n",
                        sheet.suites.size() - most_options)
          : "";
  return fmt::format(
             "<h2>Rate</h2>\n<table><thead><tr><th></th><th>per year</th><th>return period "
             "[years]</th>{}{}</tr></thead>\n<tbody>\n{}</tbody></table>\n{}",
             headings, has_options ? "<th>factor</th>" : "", rows,
             has_options
                 ? fmt::format("<p class=\"small\">Factor: rate over that of the first row, with the same records and "
                               "random numbers, by {} as the rates.</p>\n",
                               source_in_words(sheet.comparisons.front().comparison.source))
                 : "") +
         omitted;
}

std::string scale_warning(const SheetContent& sheet) {
  const auto far = far_scaled(sheet.run.ground_motions);
  return far ? fmt::format("<p class=\"warning\">{}.</p>\n", escaped(*far)) : "";
}

/// The part of each rate for which the hazard curve is continued.
std::string extrapolated_hazard(const SheetContent& sheet) {
  std::string text;
  for (std::size_t i = 0; i < std::min(sheet.suites.size(), most_options); ++i) {
    const AnnualRate& rate = sheet.suites[i].rate->chosen;
    const std::string values = option_of(sheet.suites[i].curve.subject.others);
    text +=
        fmt::format("<p{}>{}{}.</p>\n", rate.extrapolated_hazard > most_extrapolated_hazard ? " class=\"warning\"" : "",
                    sheet.suites.size() > 1 ? values + ": " : "", extrapolated_hazard_in_words(rate));
  }
  return text;
}

/// What the rate of an option lacks.
std::string warnings(const ReportedSuite& suite) {
  const SuiteRate& rate = *suite.rate;
  const std::string values = option_of(suite.curve.subject.others);
  const std::string of = values.empty() ? "" : values + ": ";
  std::string text;
  if (!rate.do_estimates_agree()) {
    text += fmt::format(
        "<p class=\"warning\">{}of the rates by law, isotonic and observed shares {}; add the levels "
        "{}.</p>\n",
        of, disagreement_in_words(rate), escaped(added_levels_in_words(rate)));
  }
  if (!rate.is_decided()) {
    text += fmt::format("<p class=\"warning\">{}the levels leave {} undecided; add the levels {}.</p>\n", of,
                        undecided_in_words(rate), escaped(added_levels_in_words(rate)));
  }
  return text;
}

std::string basis(const SheetContent& sheet) {
  const ReportedSuite& object = sheet.suites.front();
  const SuiteRate& rate = *object.rate;
  std::string ways;
  for (const RateEstimate& estimate : rate.estimates) {
    ways += fmt::format("{}{} {}", ways.empty() ? "" : "; ", source_in_words(estimate.source, rate),
                        power_of_ten(estimate.value));
  }
  std::string text = fmt::format("<p>Per year by {}.", ways);
  if (object.curve.outcome == stats::FragilityOutcome::rejected) {
    text += fmt::format(" The lognormal law is rejected (p = {}); the isotonic shares take its place.",
                        significant(object.curve.test->p_value, 2));
  }
  if (rate.leave_one_out) {
    text += fmt::format(" Without any one of the records: {} to {}.", power_of_ten(rate.leave_one_out->low),
                        power_of_ten(rate.leave_one_out->high));
  }
  const auto most = std::ranges::max_element(rate.by_record, {}, &RateOfRecord::share);
  if (most != rate.by_record.end() && most->share > 0.0) {
    text += fmt::format(" The record that contributes most, {}, has {} % of the rate.", escaped(last_part(most->name)),
                        significant(100.0 * most->share, 2));
  }
  return "<h2>What the answer rests on</h2>\n" + text + "</p>\n";
}

/// What limits the answer, beside the hazard and the records.
std::string limits(const SheetContent& sheet) {
  std::string text = extrapolated_hazard(sheet) + scale_warning(sheet);
  for (const ReportedSuite& suite : sheet.suites) text += warnings(suite);
  return text;
}

std::string assumptions(const SheetContent& sheet) {
  const CurveSubject& subject = sheet.suites.front().curve.subject;
  const std::string uplift = subject.least_uplift ? fmt::format("counted from {}, the least that {} the block, on",
                                                                significant(*subject.least_uplift, 3),
                                                                subject.event.is_of_slip() ? "moves" : "lifts")
                                                  : std::string("counted from its first point on");
  return fmt::format(
      "<h2>Assumptions and limits</h2>\n<ol>\n<li>One rigid block on a level, rigid floor, in one vertical "
      "plane; without anchorage, neighbours, twist or flexibility.</li>\n<li>Energy is lost in impacts and by friction "
      "as stated in the question. Give measured values if there are any.</li>\n<li>The hazard curve is taken as exact, "
      "and {}.</li>\n<li>Intervals cover the choice of the records and the random numbers, nothing else. Records that "
      "are scaled far do not become stronger earthquakes.</li>\n<li>Earthquakes follow each other as a Poisson "
      "process. {}</li>\n</ol>\n",
      uplift,
      subject.event.is_overturning() ? "Damage without overturning is not counted."
                                     : "An object that overturns is counted too. Other damage is not.");
}

std::string footer(const SheetContent& sheet) {
  return fmt::format(
      "<footer>Experiment SHA-256 <code>{}</code>; results SHA-256 <code>{}</code>; rocking {}. Made by <code>{}</code>"
      "</footer>\n",
      base::to_hex(sheet.suites.front().run.experiment), base::to_hex(sheet.run.digest), escaped(sheet.program),
      escaped(sheet.command));
}

}  // namespace

std::string sheet_text(const SheetContent& sheet) {
  const std::string title =
      sheet.run.title().empty() ? "How often does it " + to_do(event_of(sheet)) + "?" : sheet.run.title();
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
             "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src {}; img-src data:\">\n"
             "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<h1>{}</h1>\n",
             policy_hash(sheet_style()), escaped(title), sheet_style(), escaped(title)) +
         answer(sheet) + survived(sheet) + "<div class=\"top\">\n<div class=\"object\">\n" + drawing(sheet.run) +
         motions(sheet) + limits(sheet) + "</div>\n<div class=\"question\">\n<h2>Question</h2>\n" +
         question_in_brief(sheet.run) + basis(sheet) + "</div>\n</div>\n" + curve(sheet) + rates(sheet) +
         assumptions(sheet) + footer(sheet) + "</body>\n</html>\n";
}

}  // namespace rocking::analysis
