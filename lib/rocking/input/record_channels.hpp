#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/input/even_samples.hpp"

/// Files that hold several components of a record.
namespace rocking {

struct RecordChannel {
  std::string component = {};  ///< as its header names it; empty: it does not
  std::string origin = {};     ///< earthquake and station, as GroundMotion::origin
  EvenHeader header = {};
  std::string_view samples = {};  ///< its lines of numbers
  std::size_t line = 0;           ///< of the file, above them
};

/// The component that is asked for; the only one where none is. Reported where it is not clear which one, with the list:
/// two of one name are told apart as `channel 2`. `channels`: at least one.
[[nodiscard]] std::optional<GroundMotion> read_chosen(const std::vector<RecordChannel>& channels,
                                                      const GroundMotionReading& how, Problems& problems);

/// The blocks of lines of which a file consists, one for each component.
class ChannelReader {
 public:
  ChannelReader(const GroundMotionReading& how, Problems& found)
      : how_(how), found_(found), problems_(how.name, found) {}
  virtual ~ChannelReader() = default;

  [[nodiscard]] std::optional<GroundMotion> read(std::string_view text);

 protected:
  /// Whether a line is the first one of a block. Lines of text before it are left out; numbers there are a fault.
  [[nodiscard]] virtual bool begins(std::string_view line) const = 0;
  /// Reads a block, whose first line was taken off `text`, and takes its lines off. Absent: a block of something else, or
  /// one with a fault, which is reported.
  [[nodiscard]] virtual std::optional<RecordChannel> block(std::string_view first, std::string_view& text) = 0;
  /// What a file holds in which no block is of accelerations.
  [[nodiscard]] virtual std::string instead() const = 0;

  /// Takes the lines of the samples off `text`, `per_line` groups of `header.columns` numbers in each.
  [[nodiscard]] RecordChannel channel(std::string component, const EvenHeader& header, std::size_t per_line,
                                      std::string_view& text);
  /// Takes the lines of so many numbers off `text`. Reports one that is no line of numbers.
  std::string_view take_numbers(std::size_t count, std::size_t per_line, std::string_view& text);
  /// Reports what the text of a header says, if it is none of what its numbers give. `said`: absent, if it says nothing.
  void expect_said(std::optional<std::string_view> said, std::initializer_list<std::string_view> given);
  /// Reports a duration [s] of the header that is not that of its samples, by more than `rounding`.
  void expect_duration(std::optional<std::string_view> said, const EvenHeader& header, double rounding);

  const GroundMotionReading& how_;
  Problems& found_;
  LineProblems problems_;
};

}  // namespace rocking
