#include <algorithm>
#include <array>
#include <vector>

#include "rocking/base/number_text.hpp"
#include "rocking/input/even_samples.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/input/record_formats.hpp"

namespace rocking {
namespace {

constexpr std::string_view blanks_in_smc = " \t\r";

std::string_view trimmed_smc(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks_in_smc), text.size()));
  return text.substr(0, text.find_last_not_of(blanks_in_smc) + 1);
}

/// A text in which fields of ten characters that touch are separated.
std::string parted_fields(std::string_view text) {
  constexpr std::size_t width = 10;
  std::string parted;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    line = line.substr(0, line.find_last_not_of(blanks_in_smc) + 1);
    for (std::size_t i = 0; i < line.size(); i += width) parted += std::string(line.substr(i, width)) + ' ';
    parted += '\n';
  }
  return parted;
}

/// Reads 11 lines of text, 6 of 8 whole numbers in ten characters, 10 of 5 numbers in fifteen characters, comments, and the
/// samples, 8 a line in ten characters.
class SmcReader {
 public:
  SmcReader(const GroundMotionReading& how, Problems& problems) : how_(how), problems_(how.name, problems) {}

  std::optional<GroundMotion> read(std::string_view text) {
    text = without_byte_order_mark(text);
    const std::string_view kind = trimmed_smc(problems_.next_line(text));
    if (kind.find("ACCELEROGRAM") == std::string_view::npos) {
      problems_.reject_line(kind, "is no accelerogram", "give the file whose first line is 2 CORRECTED ACCELEROGRAM");
      return std::nullopt;
    }
    for (int i = 1; i < 11; ++i) static_cast<void>(problems_.next_line(text));
    const std::vector<double> whole = numbers(text, 6, 8, 10), real = numbers(text, 10, 5, 15);
    if (problems_.any()) return std::nullopt;
    const double absent = real[0];
    if (real[1] == absent || !(real[1] > 0.0)) problems_.reject_file("states no sampling rate", remedy);
    if (!(whole[16] > 0.0 && whole[16] < 1e9)) problems_.reject_file("states no number of samples", remedy);
    if (problems_.any()) return std::nullopt;
    const auto step = checked_time_step(base::shortest(1.0 / real[1]), 1.0, how_.time_step, problems_);
    expect_asked_unit(RecordUnit::cm_s2, how_.unit, problems_);
    if (!step || problems_.any()) return std::nullopt;
    for (double comments = 0.0; comments < whole[15] && text.starts_with('|'); ++comments) {
      static_cast<void>(problems_.next_line(text));
    }
    const EvenHeader header{
        .time_step = *step, .declared = static_cast<std::size_t>(whole[16]), .unit = RecordUnit::cm_s2};
    auto motion = read_even_samples(parted_fields(text), header, how_.gravity, problems_);
    if (motion) motion->component = component_of(whole[12], whole[13], whole[0]);
    return motion;
  }

 private:
  static constexpr const char* remedy = "give the file as the USGS distributes it";

  std::vector<double> numbers(std::string_view& text, std::size_t lines, std::size_t count, std::size_t width) {
    std::vector<double> values(lines * count, 0.0);
    for (std::size_t i = 0; i < lines && !problems_.enough(); ++i) {
      const std::string_view line = problems_.next_line(text);
      for (std::size_t k = 0; k < count; ++k) {
        const std::string_view field = trimmed_smc(line.substr(std::min(k * width, line.size()), width));
        if (!field.empty()) values[i * count + k] = problems_.number(field).value_or(0.0);
      }
    }
    return values;
  }

  /// `vertical`, `horizontal`: degrees from above, and from north.
  static std::string component_of(double vertical, double horizontal, double absent) {
    if (vertical == 0.0 || vertical == 180.0 || horizontal >= 500.0) return horizontal == absent ? "" : "UP";
    return horizontal == absent ? "" : base::shortest(horizontal);
  }

  const GroundMotionReading& how_;
  LineProblems problems_;
};

}  // namespace

bool is_line_of_smc_header(std::string_view line) {
  line = trimmed_smc(line);
  constexpr std::array<std::string_view, 4> kinds{"1 UNCORRECTED ACCELEROGRAM", "2 CORRECTED ACCELEROGRAM",
                                                  "3 VELOCITY", "4 DISPLACEMENT"};
  return std::ranges::find(kinds, line) != kinds.end();
}

std::optional<GroundMotion> read_smc(std::string_view text, const GroundMotionReading& how, Problems& problems) {
  return SmcReader(how, problems).read(text);
}

}  // namespace rocking
