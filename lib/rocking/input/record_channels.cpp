#include "rocking/input/record_channels.hpp"

#include <algorithm>
#include <utility>

#include "rocking/input/fixed_fields.hpp"
#include "rocking/input/record_component.hpp"

namespace rocking {
namespace {

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
  for (std::size_t i = 0; i < channels.size() && channels.size() > 1; ++i) {
    motion->components.push_back(choice.label(i));
  }
  return motion;
}

std::optional<GroundMotion> ChannelReader::read(std::string_view text) {
  text = without_byte_order_mark(text);
  std::vector<RecordChannel> channels;
  while (!text.empty() && !problems_.enough()) {
    const std::string_view line = problems_.next_line(text);
    if (!begins(line)) continue;
    if (auto channel = block(line, text)) channels.push_back(*std::move(channel));
  }
  if (channels.empty() && !problems_.any()) problems_.reject_file(instead(), "give the file of accelerations");
  if (problems_.any()) return std::nullopt;
  return read_chosen(channels, how_, found_);
}

RecordChannel ChannelReader::channel(std::string component, const EvenHeader& header, std::size_t per_line,
                                     std::string_view& text) {
  RecordChannel channel{.component = std::move(component), .header = header, .line = problems_.line()};
  channel.samples = take_lines(text, lines_of(header.declared.value_or(0), per_line), problems_);
  return channel;
}

}  // namespace rocking
