#include "rocking/input/record_channels.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rocking/base/number_text.hpp"
#include "rocking/input/fixed_fields.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/input/record_component.hpp"

namespace rocking {
namespace {

constexpr std::string_view restore = "restore the file, or correct the header of the component";

std::size_t numbers_in(std::string_view text) {
  std::vector<std::string_view> fields;
  std::size_t count = 0;
  while (!text.empty()) {
    split_fields(take_line(text), fields);
    count += fields.size();
  }
  return count;
}

class ChannelChoice {
 public:
  ChannelChoice(const std::vector<RecordChannel>& channels, const GroundMotionReading& how, Problems& problems)
      : channels_(channels), how_(how), problems_(how.name, problems) {}

  /// The place of the chosen one; absent, and reported, if it is not clear.
  std::optional<std::size_t> chosen() {
    const bool is_asked = how_.takes_vertical || !how_.component.empty();
    if (channels_.size() == 1 && (how_.takes_vertical || !is_asked)) return 0;
    std::vector<std::size_t> fitting;
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      if (is_asked && fits(i)) fitting.push_back(i);
    }
    if (fitting.size() == 1) return fitting.front();
    if (how_.takes_vertical) {
      problems_.reject_file("holds " + count(fitting.size()) + " vertical components among " + list(),
                            "give a file with one vertical component");
    } else if (is_asked) {
      problems_.reject_file(
          "holds " + count(fitting.size()) + " components of the name \"" + how_.component + "\" among " + list(),
          "choose one of them with \"component\"");
    } else {
      problems_.reject_file("holds " + std::to_string(channels_.size()) + " components: " + list(),
                            "choose one with \"component\": \"" + label(first_horizontal()) +
                                "\"; \"vertical_file\" may be the same file, of which the vertical one is taken");
    }
    return std::nullopt;
  }

  [[nodiscard]] std::string label(std::size_t i) const {
    const std::string& name = channels_[i].component;
    const auto has_name = [&name](const RecordChannel& other) { return is_same_component(other.component, name); };
    return name.empty() || std::ranges::count_if(channels_, has_name) > 1 ? channel_name(i) : name;
  }

 private:
  static std::string channel_name(std::size_t i) { return "channel " + std::to_string(i + 1); }
  static std::string count(std::size_t found) { return found == 0 ? "no" : std::to_string(found); }

  [[nodiscard]] bool fits(std::size_t i) const {
    const std::string& name = channels_[i].component;
    if (how_.takes_vertical) return is_vertical_component(name);
    return is_same_component(how_.component, channel_name(i)) ||
           (!name.empty() && is_same_component(how_.component, name));
  }

  [[nodiscard]] std::size_t first_horizontal() const {
    const auto is_vertical = [](const RecordChannel& channel) { return is_vertical_component(channel.component); };
    const auto found = std::ranges::find_if_not(channels_, is_vertical);
    return found == channels_.end() ? 0 : static_cast<std::size_t>(found - channels_.begin());
  }

  [[nodiscard]] std::string list() const {
    constexpr std::size_t most = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(channels_.size(), most); ++i) {
      const std::string& name = channels_[i].component;
      text += (i == 0 ? "" : ", ") + label(i);
      if (label(i) != name && !name.empty()) text += " (" + name + ')';
    }
    return channels_.size() > most ? text + ", ..." : text;
  }

  const std::vector<RecordChannel>& channels_;
  const GroundMotionReading& how_;
  LineProblems problems_;
};

}  // namespace

std::optional<GroundMotion> read_chosen(const std::vector<RecordChannel>& channels, const GroundMotionReading& how,
                                        Problems& problems) {
  ChannelChoice choice(channels, how, problems);
  const auto place = choice.chosen();
  if (!place) return std::nullopt;
  const RecordChannel& chosen = channels[*place];
  LineProblems lines(how.name, problems, chosen.line);
  expect_asked_unit(chosen.header.unit, how.unit, lines);
  if (chosen.header.has_times) {
    expect_no_step(how.time_step, lines);
  } else {
    expect_asked_step(chosen.header.time_step, how.time_step, lines);
  }
  if (lines.any()) return std::nullopt;
  auto motion = read_even_samples(chosen.samples, chosen.header, how.gravity, lines);
  if (!motion) return std::nullopt;
  motion->component = chosen.component.empty() && channels.size() > 1 ? choice.label(*place) : chosen.component;
  motion->origin = chosen.origin;
  for (std::size_t i = 0; i < channels.size() && channels.size() > 1; ++i) {
    motion->components.push_back(choice.label(i));
  }
  return motion;
}

std::optional<GroundMotion> ChannelReader::read(std::string_view text) {
  text = without_byte_order_mark(text);
  std::vector<RecordChannel> channels;
  while (!text.empty() && !problems_.any()) {
    const std::string_view line = problems_.next_line(text);
    if (begins(line)) {
      if (auto channel = block(line, text)) channels.push_back(*std::move(channel));
    } else if (is_line_of_numbers(line)) {
      problems_.reject_line(trimmed(line), "is a line of numbers outside of the components, as the headers count them",
                            std::string(restore));
    }
  }
  if (channels.empty() && !problems_.any()) problems_.reject_file(instead(), "give the file of accelerations");
  if (problems_.any()) return std::nullopt;
  return read_chosen(channels, how_, found_);
}

RecordChannel ChannelReader::channel(std::string component, const EvenHeader& header, std::size_t per_line,
                                     std::string_view& text) {
  RecordChannel channel{.component = std::move(component), .header = header, .line = problems_.line()};
  const std::size_t declared = header.declared.value_or(0);
  channel.samples = take_numbers(declared, per_line, text);
  const std::size_t numbers = numbers_in(parted_fields(channel.samples, header.field_width));
  const std::size_t found = numbers / header.columns;
  if (!problems_.any() && numbers % header.columns == 0 && std::max(found, declared) - std::min(found, declared) > 1) {
    problems_.reject_file("contains " + std::to_string(found) + " samples of " +
                              (channel.component.empty() ? "a component" : channel.component) +
                              ", but its header declares " + std::to_string(declared),
                          std::string(restore));
  }
  return channel;
}

std::string_view ChannelReader::take_numbers(std::size_t count, std::size_t per_line, std::string_view& text) {
  const std::string_view whole = text;
  std::size_t lines = lines_of(count, per_line);
  for (; lines > 0 && !text.empty() && !problems_.any(); --lines) {
    const std::string_view line = problems_.next_line(text);
    if (is_line_of_numbers(line)) continue;
    problems_.reject_line(trimmed(line),
                          "is no line of numbers, but the header declares " + std::to_string(count) + " numbers here",
                          std::string(restore));
  }
  if (lines > 0 && !problems_.any()) {
    problems_.reject_file("ends too early, but its header declares " + std::to_string(count) + " numbers here",
                          std::string(restore));
  }
  return whole.substr(0, whole.size() - text.size());
}

void ChannelReader::expect_said(std::optional<std::string_view> said, std::initializer_list<std::string_view> given) {
  if (!said) return;
  const auto number = problems_.number(*said);
  const auto is_equal = [&](std::string_view other) {
    return is_number_field(other) && problems_.number(other) == number;
  };
  if (std::ranges::any_of(given, is_equal)) return;
  problems_.reject_line(*said, "stands in the text of the header, but its numbers give " + std::string(*given.begin()),
                        std::string(restore));
}

void ChannelReader::expect_duration(std::optional<std::string_view> said, const EvenHeader& header, double rounding) {
  const auto duration = said ? problems_.number(*said) : std::nullopt;
  if (!duration || !header.declared || header.has_times) return;
  const double of_samples = header.time_step * static_cast<double>(*header.declared);
  if (std::abs(*duration - of_samples) <= rounding + 2.0 * header.time_step) return;
  problems_.reject_line(
      *said, "is the duration in seconds by the header, but its samples last " + base::significant(of_samples, 6),
      std::string(restore));
}

}  // namespace rocking
