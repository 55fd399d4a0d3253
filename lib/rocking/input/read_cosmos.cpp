#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "rocking/base/number_text.hpp"
#include "rocking/input/fixed_fields.hpp"
#include "rocking/input/header_words.hpp"
#include "rocking/input/record_channels.hpp"

namespace rocking {
namespace {

constexpr std::string_view remedy_of_cosmos = "give the file as the Strong-Motion Virtual Data Center distributes it";

/// The table of directions of the format, beyond azimuths.
constexpr std::array<std::pair<int, std::string_view>, 9> directions_of_cosmos{{{400, "Up"},
                                                                                {401, "Down"},
                                                                                {402, "Vertical"},
                                                                                {500, "radial"},
                                                                                {501, "transverse"},
                                                                                {600, "longitudinal"},
                                                                                {601, "tangential"},
                                                                                {700, "H1"},
                                                                                {701, "H2"}}};

/// What stands behind `key` in a line, up to the next blank or bracket.
std::string_view word_behind(std::string_view line, std::string_view key) {
  const std::size_t place = line.find(key);
  if (place == std::string_view::npos) return {};
  line = trimmed(line.substr(place + key.size()));
  return line.substr(0, line.find_first_of(" (\t\r"));
}

/// Blocks of lines of text, whole numbers, numbers, comments and samples; a line above each says how many there are.
class CosmosReader final : public ChannelReader {
 public:
  using ChannelReader::ChannelReader;

 private:
  [[nodiscard]] bool begins(std::string_view line) const override { return is_line_of_cosmos_header(line); }

  [[nodiscard]] std::optional<RecordChannel> block(std::string_view first, std::string_view& text) override {
    skip_text(text, "integer-header");
    const auto whole = numbers_of(text, "integer-header");
    const auto real = numbers_of(text, "real-header");
    if (whole.size() < 54 || real.size() < 64) {
      if (!problems_.any())
        problems_.reject_line(first, "begins a component without a whole header", std::string(remedy_of_cosmos));
      return std::nullopt;
    }
    std::string_view channel_code;
    std::string_view line = problems_.next_line(text);
    while (!text.empty() && !begins(next_of(text)) && (trimmed(line).starts_with('|') || !word_place(line, "pts"))) {
      if (channel_code.empty()) channel_code = channel_of(word_behind(line, "<SCNL>"));
      line = problems_.next_line(text);
    }
    return samples_of(whole, real, std::string(channel_code), line, text);
  }

  [[nodiscard]] std::string instead() const override {
    return "has no component of accelerations in the format of COSMOS" +
           (instead_.empty() ? std::string() : ", but " + instead_);
  }

  static std::string_view next_of(std::string_view text) { return text.substr(0, text.find('\n')); }

  /// Takes lines off up to one that has `key`, or that begins another component.
  void skip_text(std::string_view& text, std::string_view key) {
    while (!text.empty() && !word_place(next_of(text), key) && !begins(next_of(text))) {
      static_cast<void>(problems_.next_line(text));
    }
  }

  /// The numbers below the next line, which has `key`: ` 100 Real-header values follow on  20 lines, Format= (5F15.6)`. Empty
  /// if it has not, or if there are not as many as it says.
  std::vector<std::string_view> numbers_of(std::string_view& text, std::string_view key) {
    const std::string_view line = next_of(text);
    const auto format = field_format_in(line);
    const auto lines = number_after(line, "on");
    if (!word_place(line, key) || !format || !lines) return {};
    static_cast<void>(problems_.next_line(text));
    const auto count = checked_count(*lines, problems_);
    constexpr std::size_t most = 200;
    if (!count || *count > most) return {};
    std::string_view numbers = take_numbers(*count, 1, text);
    LineProblems counted = problems_;
    std::vector<std::string_view> fields = take_fields(numbers, *count, *format, counted);
    const auto blank = std::ranges::count_if(fields, &std::string_view::empty);
    const std::string_view begin = trimmed(line);
    expect_said(begin.substr(0, begin.find(' ')),
                {base::shortest(static_cast<double>(fields.size()) - static_cast<double>(blank))});
    return fields;
  }

  /// `line`: `  7000  acceleration pts, approx   70 secs, units=cm/sec2(04),Format=(8F10.5)`.
  std::optional<RecordChannel> samples_of(const std::vector<std::string_view>& whole,
                                          const std::vector<std::string_view>& real, std::string channel_code,
                                          std::string_view line, std::string_view& text) {
    const auto format = field_format_in(line);
    const std::string_view begin = trimmed(line);
    const auto count = format ? checked_count(begin.substr(0, begin.find(' ')), problems_) : std::nullopt;
    if (!format || !count) {
      if (!problems_.any())
        problems_.reject_line(line, "does not give the number and the format of the samples",
                              std::string(remedy_of_cosmos));
      return std::nullopt;
    }
    const std::string_view written = word_behind(line, "units=");
    const WrittenUnit unit = unit_written(written);
    if (unit.kind != UnitKind::acceleration) {
      instead_ = written == "counts" ? "raw counts (V0), which need the sensor's calibration"
                                     : "one in the unit " + std::string(written);
      static_cast<void>(take_numbers(*count, format->count, text));
      return std::nullopt;
    }
    const auto step = step_of(real);
    if (!step) return std::nullopt;
    EvenHeader header{.time_step = *step, .declared = *count, .unit = unit.acceleration, .field_width = format->width};
    header.peak = header_peak(real[63], header.unit, how_.gravity);
    constexpr double approximately = 1.0;
    expect_duration(number_after(line, "approx"), header, approximately);
    return channel(component_of(whole[53], std::move(channel_code)), header, format->count, text);
  }

  /// Number 62 in ms; where it is unknown, number 34 in s, which is that of the recorder.
  std::optional<double> step_of(const std::vector<std::string_view>& real) {
    if (is_number_field(real[61]) && !real[61].starts_with('-')) {
      return checked_time_step(real[61], 1000.0, std::nullopt, problems_);
    }
    return checked_time_step(real[33], 1.0, std::nullopt, problems_);
  }

  /// Of `BMR.BNZ.AK.--` the channel.
  static std::string_view channel_of(std::string_view code) {
    const std::size_t begin = code.find('.');
    if (begin == std::string_view::npos) return {};
    code.remove_prefix(begin + 1);
    return code.substr(0, code.find('.'));
  }

  static std::string component_of(std::string_view direction, std::string channel_code) {
    for (const auto& [number, name] : directions_of_cosmos) {
      if (direction == base::shortest(number)) return std::string(name);
    }
    int degrees = 0;
    const char* const behind = direction.data() + direction.size();
    const bool is_azimuth =
        std::from_chars(direction.data(), behind, degrees).ptr == behind && degrees >= 1 && degrees <= 360;
    return is_azimuth || channel_code.empty() ? (is_azimuth ? std::string(direction) : std::string()) : channel_code;
  }

  std::string instead_;  ///< of accelerations
};

}  // namespace

bool is_line_of_cosmos_header(std::string_view line) {
  constexpr std::array<std::string_view, 4> kinds{"acceleration", "velocity", "displacement", "accel"};
  return line.find("(Format v") != std::string_view::npos &&
         std::ranges::any_of(kinds, [line](std::string_view kind) { return word_place(line, kind).has_value(); });
}

std::optional<GroundMotion> read_cosmos(std::string_view text, const GroundMotionReading& how, Problems& problems) {
  return CosmosReader(how, problems).read(text);
}

}  // namespace rocking
