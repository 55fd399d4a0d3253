#include <algorithm>
#include <array>
#include <vector>

#include "rocking/base/number_text.hpp"
#include "rocking/input/even_samples.hpp"
#include "rocking/input/fixed_fields.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/input/record_formats.hpp"

namespace rocking {
namespace {

/// Reads 11 lines of text, 6 of 8 whole numbers in ten characters, 10 of 5 numbers in fifteen characters, comments, and the
/// samples, 8 a line in ten characters.
class SmcReader {
 public:
  SmcReader(const GroundMotionReading& how, Problems& problems) : how_(how), problems_(how.name, problems) {}

  std::optional<GroundMotion> read(std::string_view text) {
    text = without_byte_order_mark(text);
    const std::string_view kind = trimmed(problems_.next_line(text));
    if (kind.find("ACCELEROGRAM") == std::string_view::npos) {
      problems_.reject_line(kind, "is no accelerogram", "give the file whose first line is 2 CORRECTED ACCELEROGRAM");
      return std::nullopt;
    }
    for (int i = 1; i < 11; ++i) static_cast<void>(problems_.next_line(text));
    const std::vector<double> whole = numbers(text, 6, {8, 10}), real = numbers(text, 10, {5, 15});
    if (problems_.any()) return std::nullopt;
    // Without a rate the samples are pairs of a time and an acceleration, as digitised from film.
    const bool has_times = real[1] == real[0] && kind.find("UNCORRECTED") != std::string_view::npos;
    if (!has_times && (real[1] == real[0] || !(real[1] > 0.0))) {
      problems_.reject_file("states no sampling rate", remedy);
    }
    if (!(whole[16] > 0.0 && whole[16] < 1e9)) problems_.reject_file("states no number of samples", remedy);
    if (has_times) expect_no_step(how_.time_step, problems_);
    if (problems_.any()) return std::nullopt;
    const auto step = has_times ? std::optional(0.0)
                                : checked_time_step(base::shortest(1.0 / real[1]), 1.0, how_.time_step, problems_);
    expect_asked_unit(RecordUnit::cm_s2, how_.unit, problems_);
    if (!step || problems_.any()) return std::nullopt;
    for (double comments = 0.0; comments < whole[15] && text.starts_with('|'); ++comments) {
      static_cast<void>(problems_.next_line(text));
    }
    const std::size_t columns = has_times ? 2 : 1;
    const EvenHeader header{.time_step = *step,
                            .declared = static_cast<std::size_t>(whole[16]) / columns,
                            .unit = RecordUnit::cm_s2,
                            .field_width = 10,
                            .columns = columns,
                            .column = columns - 1,
                            .has_times = has_times,
                            .peak = peak_of(real)};
    // Lines behind the declared numbers hold what was left in a buffer.
    std::string_view beyond = text;
    LineProblems counted = problems_;
    const std::string_view samples = take_lines(beyond, lines_of(static_cast<std::size_t>(whole[16]), 8), counted);
    auto motion = read_even_samples(samples, header, how_.gravity, problems_);
    if (motion) motion->component = component_of(whole[12], whole[13], whole[0]);
    if (motion && beyond.find_first_not_of(std::string_view(" \t\r\n\0", 5)) != std::string_view::npos) {
      motion->warnings.push_back("contains lines behind the samples that its header declares; they are not read");
    }
    return motion;
  }

 private:
  static constexpr const char* remedy = "give the file as the USGS distributes it";

  std::vector<double> numbers(std::string_view& text, std::size_t lines, FieldFormat format) {
    std::vector<double> values;
    for (std::size_t i = 0; i < lines && !problems_.enough(); ++i) {
      for (const std::string_view field : take_fields(text, 1, format, problems_)) {
        values.push_back(field.empty() ? 0.0 : problems_.number(field).value_or(0.0));
      }
    }
    return values;
  }

  /// Of the largest and the smallest acceleration, which the header gives, the larger one.
  [[nodiscard]] std::optional<HeaderPeak> peak_of(const std::vector<double>& real) const {
    std::optional<HeaderPeak> peak;
    for (const double value : {real[29], real[31]}) {
      const auto found = header_peak(base::shortest(value), RecordUnit::cm_s2, how_.gravity);
      if (found && (!peak || found->m_s2 > peak->m_s2)) peak = found;
    }
    return peak;
  }

  /// `vertical`, `horizontal`: degrees from above, and from north.
  static std::string component_of(double vertical, double horizontal, double absent) {
    if (vertical == 0.0 || vertical == 180.0 || horizontal >= 500.0) return "UP";
    return horizontal == absent ? "" : base::shortest(horizontal);
  }

  const GroundMotionReading& how_;
  LineProblems problems_;
};

}  // namespace

bool is_line_of_smc_header(std::string_view line) {
  line = trimmed(line);
  constexpr std::array<std::string_view, 4> kinds{"1 UNCORRECTED ACCELEROGRAM", "2 CORRECTED ACCELEROGRAM",
                                                  "3 VELOCITY", "4 DISPLACEMENT"};
  return std::ranges::find(kinds, line) != kinds.end();
}

std::optional<GroundMotion> read_smc(std::string_view text, const GroundMotionReading& how, Problems& problems) {
  return SmcReader(how, problems).read(text);
}

}  // namespace rocking
