#include "rocking/input/record_formats.hpp"

#include <cstddef>

#include "rocking/input/line_problems.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_header_lines = 100;

}  // namespace

RecordFormat recognised_format(std::string_view text) {
  text = without_byte_order_mark(text);
  for (std::size_t i = 0; i < most_header_lines && !text.empty(); ++i) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    line = line.substr(0, line.find('#'));
    for (const RecordReader& reader : record_readers) {
      if (reader.is_line == nullptr || !reader.is_line(line)) continue;
      return static_cast<RecordFormat>(&reader - record_readers.data());
    }
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return RecordFormat::columns;
}

}  // namespace rocking
