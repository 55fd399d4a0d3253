#include "rocking/input/record_format.hpp"

#include <cstddef>

#include "rocking/input/header_words.hpp"
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
    if (line.starts_with("SAMPLING_INTERVAL_S:")) return RecordFormat::esm_asc;
    if (word_place(line, "npts") && word_place(line, "dt")) return RecordFormat::peer_at2;
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return RecordFormat::columns;
}

}  // namespace rocking
