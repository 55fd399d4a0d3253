#include "rocking/base/number_text.hpp"
#include "rocking/input/fixed_fields.hpp"
#include "rocking/input/header_words.hpp"
#include "rocking/input/record_channels.hpp"

namespace rocking {
namespace {

constexpr std::string_view remedy_of_csmip = "give the file as CSMIP or the CESMD distributes it";

bool is_uncorrected(std::string_view line) { return begins_with_word(line, "uncorrected"); }

/// Blocks of one component each. V1: 13 lines of text, 7 of whole numbers, 7 of numbers, and a line that says what follows, or
/// pairs of a time and an acceleration in g/10. V2: 25, 7 and 13 lines, and accelerations, velocities and displacements, a
/// line above each.
class CsmipReader final : public ChannelReader {
 public:
  using ChannelReader::ChannelReader;

 private:
  [[nodiscard]] bool begins(std::string_view line) const override { return is_line_of_csmip_header(line); }

  [[nodiscard]] std::optional<RecordChannel> block(std::string_view first, std::string_view& text) override {
    const bool is_volume_one = is_uncorrected(first);
    const std::size_t of_text = is_volume_one ? 13 : 25, of_numbers = is_volume_one ? 14 : 20;
    component_.clear();
    peak_ = {};
    declared_ = {};
    step_ = {};
    tenths_of_g_ = false;
    for (std::size_t i = 1; i < of_text && !text.empty(); ++i) read_line(problems_.next_line(text), is_volume_one);
    static_cast<void>(take_lines(text, of_numbers, problems_));
    const std::string_view below = text.substr(0, text.find('\n'));
    if (!word_place(below, "points") && is_volume_one && tenths_of_g_) return pairs(text);
    auto found = even(problems_.next_line(text), is_volume_one ? 9 : 10, text);
    if (found) take_integrals(text);
    return found;
  }

  [[nodiscard]] std::string instead() const override {
    return "has no component of accelerations in the format of CSMIP";
  }

  void read_line(std::string_view line, bool is_volume_one) {
    if (begins_with_word(line, "chan")) {
      line = line.substr(std::min(line.find(':'), line.size()));
      line = trimmed(line.substr(std::min<std::size_t>(1, line.size())));
      component_ = line.substr(0, std::min(line.find("  "), line.find('(')));
      component_ = std::string(trimmed(component_));
      if (const auto degrees = word_place(component_, "deg"))
        component_ = std::string(trimmed(component_.substr(0, *degrees)));
    }
    const auto peak = is_volume_one ? number_behind(line, "max") : number_behind(line, "peak acceleration");
    if (peak) peak_ = *peak;
    // The header of a corrected record also has the raw number of points.
    if (const auto count = number_behind(line, "of points"); count && is_volume_one) declared_ = *count;
    const bool is_count = !is_volume_one && word_place(line, "points of") && is_number_field(first_word(line));
    if (is_count) declared_ = first_word(line);
    if (const auto step = number_after(line, "equally-spaced intervals of")) step_ = *step;
    if (word_place(line, "units") && word_place(line, "g/10")) tenths_of_g_ = true;
  }

  /// The number behind `=` after a word: `MAX  =  -.200 G`.
  static std::optional<std::string_view> number_behind(std::string_view line, std::string_view word) {
    const auto place = word_place(line, word);
    if (!place) return std::nullopt;
    line.remove_prefix(*place + word.size());
    line = trimmed(line);
    if (!line.starts_with('=')) return std::nullopt;
    line = trimmed(line.substr(1));
    line = line.substr(0, line.find_first_of(" \t\r,"));
    return is_number_field(line) ? std::optional(line) : std::nullopt;
  }

  std::optional<RecordChannel> pairs(std::string_view& text) {
    const auto count = checked_count(declared_, problems_);
    if (!count) return std::nullopt;
    EvenHeader header{.declared = *count, .unit = RecordUnit::g, .factor = 0.1, .field_width = 7};
    header.columns = 2;
    header.column = 1;
    header.has_times = true;
    header.peak = header_peak(peak_, RecordUnit::g, how_.gravity);
    return channel(component_, header, 5, text);
  }

  static std::string_view first_word(std::string_view line) {
    line = trimmed(line);
    return line.substr(0, line.find(' '));
  }

  static FieldFormat format_in(std::string_view line, std::size_t width) {
    return field_format_in(line).value_or(FieldFormat{.count = 8, .width = width});
  }

  /// Velocities and displacements: ` 7500 points of veloc data equally spaced at  .010 sec, in cm/sec.  (8f10.7)`.
  void take_integrals(std::string_view& text) {
    const auto are_next = [&text] {
      const std::string_view line = text.substr(0, text.find('\n'));
      return word_place(line, "points") && (word_place(line, "veloc") || word_place(line, "displ"));
    };
    while (!problems_.any() && are_next()) {
      const std::string_view line = problems_.next_line(text);
      const auto count = checked_count(first_word(line), problems_);
      if (count) static_cast<void>(take_numbers(*count, format_in(line, 10).count, text));
    }
  }

  /// `line`: ` 7500 points of accel data equally spaced at  .010 sec, in cm/sec2. (8f10.6)`, or
  /// ` 13200 Accelerogram points at 200 pts/sec in units of g .      Format: (8f9.6)`.
  std::optional<RecordChannel> even(std::string_view line, std::size_t width, std::string_view& text) {
    const bool speaks_of_accelerations =
        word_place(line, "accel") || word_place(line, "accelerogram") || word_place(line, "acceleration");
    const auto at = number_after(line, "at");
    const auto unit = unit_in(line);
    if (!speaks_of_accelerations || !word_place(line, "points") || !at || !unit) {
      problems_.reject_line(line, "does not say how many accelerations follow, at which step and in which unit",
                            std::string(remedy_of_csmip));
      return std::nullopt;
    }
    const auto count = checked_count(first_word(line), problems_);
    const bool is_rate = word_place(line, "pts") || word_place(line, "samples");
    const auto number = is_rate ? problems_.number(*at) : std::nullopt;
    const auto step = checked_time_step(number ? base::shortest(1.0 / *number) : *at, 1.0, std::nullopt, problems_);
    if (!count || !step) return std::nullopt;
    if (!declared_.empty()) expect_said(declared_, {first_word(line)});
    if (!step_.empty()) expect_said(step_, {base::shortest(*step)});
    const FieldFormat format = format_in(line, width);
    EvenHeader header{.time_step = *step, .declared = *count, .unit = *unit, .field_width = format.width};
    header.peak = header_peak(peak_, header.unit, how_.gravity);
    return channel(component_, header, format.count, text);
  }

  static std::optional<RecordUnit> unit_in(std::string_view line) {
    for (const auto& stated : {units_stated(line), units_among_words(line)}) {
      for (const StatedUnit& found : stated) {
        if (found.unit.kind == UnitKind::acceleration) return found.unit.acceleration;
      }
    }
    return std::nullopt;
  }

  std::string component_;
  std::string_view peak_;
  std::string_view declared_;
  std::string_view step_;
  bool tenths_of_g_ = false;
};

}  // namespace

bool is_line_of_csmip_header(std::string_view line) {
  return !is_line_of_geonet_header(line) &&
         (begins_with_word(line, "uncorrected accelerogram data") || begins_with_word(line, "corrected accelerogram"));
}

std::optional<GroundMotion> read_csmip(std::string_view text, const GroundMotionReading& how, Problems& problems) {
  return CsmipReader(how, problems).read(text);
}

}  // namespace rocking
