#include <algorithm>
#include <array>
#include <span>

#include "rocking/input/fixed_fields.hpp"
#include "rocking/input/header_words.hpp"
#include "rocking/input/record_channels.hpp"

namespace rocking {
namespace {

constexpr std::string_view remedy_of_geonet = "give the file as GeoNet distributes it";
constexpr std::string_view unit_of_geonet = "mm/s/s";

/// Blocks of 16 lines of text, 10 of 10 numbers, and the samples, in fields of eight characters; in a V2A file velocities
/// and displacements follow, as many as the header says.
class GeonetReader final : public ChannelReader {
 public:
  using ChannelReader::ChannelReader;

 private:
  [[nodiscard]] bool begins(std::string_view line) const override { return is_line_of_geonet_header(line); }

  [[nodiscard]] std::optional<RecordChannel> block(std::string_view first, std::string_view& text) override {
    const bool is_corrected = begins_with_word(first, "corrected");
    std::array<std::string_view, 16> lines{first};
    for (std::size_t i = 1; i < lines.size(); ++i) lines[i] = problems_.next_line(text);
    if (!is_corrected && lines[10].find(unit_of_geonet) == std::string_view::npos) {
      problems_.reject_file("states no accelerations in mm/s/s in the header of a component",
                            std::string(remedy_of_geonet));
      return std::nullopt;
    }
    const Numbers numbers{take_fields(text, 10, {.count = 10, .width = 8}, problems_)};
    const auto step = checked_time_step(numbers.at(6, 5), 1.0, std::nullopt, problems_);
    const auto count = checked_count(numbers.at(3, is_corrected ? 3 : 0), problems_);
    if (!step || !count) return std::nullopt;
    EvenHeader header{.time_step = *step, .declared = *count, .unit = RecordUnit::mm_s2, .field_width = 8};
    header.peak = header_peak(numbers.at(7, is_corrected ? 5 : 0), header.unit, how_.gravity);
    // `Raw readings in units of 1.00 mm/s/s  at intervals of 0.005 s`
    const auto factor = is_corrected ? std::nullopt : number_after(lines[10], "of");
    if (factor) header.factor = problems_.number(*factor).value_or(1.0);
    compare(lines, numbers, is_corrected);
    compare_duration(numbers, header);
    auto found = channel(component_in_line(lines[12]), header, 10, text);
    found.origin = record_in(first);
    for (std::size_t i = 4; i < 6 && is_corrected; ++i) {
      const auto others = checked_count(numbers.at(3, i), problems_);
      static_cast<void>(take_numbers(others.value_or(0), 10, text));
    }
    return found;
  }

  [[nodiscard]] std::string instead() const override { return "has no component in GeoNet's format"; }

  struct Numbers {
    std::vector<std::string_view> fields;
    [[nodiscard]] std::string_view at(std::size_t line, std::size_t column) const { return fields[line * 10 + column]; }
  };

  /// What the text of the header says, `Number of points  26385    Duration 131.92 s`, with its numbers. Of a corrected
  /// component it may be about the raw readings.
  void compare(std::span<const std::string_view> lines, const Numbers& numbers, bool is_corrected) {
    const std::size_t own = is_corrected ? 3 : 0, other = is_corrected ? 0 : 3;
    for (const std::string_view line : lines) {
      expect_said(number_after(line, "number of points"), {numbers.at(3, own), numbers.at(3, other)});
      expect_said(number_after(line, "at intervals of"), {numbers.at(6, 5), numbers.at(6, 4)});
    }
  }

  void compare_duration(const Numbers& numbers, const EvenHeader& header) {
    const std::string_view duration = numbers.at(6, 3);
    if (duration.find_first_of("123456789") != std::string_view::npos) expect_duration(duration, header, 0.01);
  }

  /// Of `Corrected accelerogram 20110221_235142_HSES_20 GNS Science` the third word: time of the earthquake and station, alike
  /// in both volumes.
  static std::string record_in(std::string_view line) {
    std::vector<std::string_view> words;
    split_fields(line, words);
    constexpr std::ptrdiff_t separators = 2;
    const bool is_code = words.size() > 2 && std::ranges::count(words[2], '_') >= separators;
    return is_code ? std::string(words[2]) : std::string();
  }

  /// `Component S90E  Longitudinal Accelerometer Axis`.
  static std::string component_in_line(std::string_view line) {
    line = trimmed(line);
    if (!begins_with_word(line, "component")) return {};
    line = trimmed(line.substr(std::string_view("component").size()));
    return std::string(line.substr(0, line.find(' ')));
  }
};

}  // namespace

bool is_line_of_geonet_header(std::string_view line) {
  const bool is_of_geonet =
      line.find("GNS") != std::string_view::npos || line.find("Nuclear Sciences") != std::string_view::npos;
  return is_of_geonet && word_place(line, "accelerogram") &&
         (begins_with_word(line, "corrected") || begins_with_word(line, "uncorrected"));
}

std::optional<GroundMotion> read_geonet(std::string_view text, const GroundMotionReading& how, Problems& problems) {
  return GeonetReader(how, problems).read(text);
}

}  // namespace rocking
