#include "rocking/base/error.hpp"

#include <algorithm>
#include <utility>

#include "rocking/base/utf8.hpp"

namespace rocking::base {
namespace {

std::string message_of(const std::vector<Problem>& problems) {
  std::string message;
  for (const Problem& problem : problems) {
    if (!message.empty()) message += '\n';
    message += to_string(problem);
  }
  return message;
}

std::error_code code_of(FolderError::Kind kind) {
  switch (kind) {
    case FolderError::Kind::missing: return std::make_error_code(std::errc::no_such_file_or_directory);
    case FolderError::Kind::contradiction: return std::make_error_code(std::errc::invalid_argument);
    case FolderError::Kind::in_the_way:
    case FolderError::Kind::different: return std::make_error_code(std::errc::file_exists);
    case FolderError::Kind::at_work: break;
  }
  return std::make_error_code(std::errc::device_or_resource_busy);
}

std::string escape_of(unsigned char byte) {
  constexpr char digits[] = "0123456789abcdef";
  return {'\\', 'x', digits[byte >> 4U], digits[byte & 15U]};
}

}  // namespace

std::string to_string(const Problem& problem) {
  constexpr std::size_t longest_place = 160;
  constexpr std::size_t longest_value = 80;
  std::string text = problem.where.empty() ? "" : problem.where + ": ";
  text += cut_to(problem.place, longest_place);
  if (!problem.value.empty()) text.append(" = ").append(cut_to(problem.value, longest_value));
  text.append(": ").append(problem.reason);
  if (!problem.remedy.empty()) text.append("; ").append(problem.remedy);
  return printable(text);
}

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length_at(text, i);
    const auto first = static_cast<unsigned char>(text[i]);
    const bool is_control = (first < 0x20 && first != '\n') || first == 0x7f;
    const bool is_high_control = length == 2 && first == 0xc2 && static_cast<unsigned char>(text[i + 1]) < 0xa0;
    if (const std::string direction = direction_control_at(text, i); !direction.empty()) {
      shown += direction;
    } else if (length == 0 || is_control) {
      shown += escape_of(first);
    } else if (is_high_control) {
      shown += escape_of(static_cast<unsigned char>(text[i + 1]));
    } else {
      shown += text.substr(i, length);
    }
    i += std::max<std::size_t>(length, 1);
  }
  return shown;
}

std::string cut_to(std::string_view text, std::size_t most) {
  constexpr std::string_view dots = "...";
  if (text.size() <= most) return std::string(text);
  std::size_t end = most - std::min(most, dots.size());
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
  return std::string(text.substr(0, end)) += dots;
}

InputError::InputError(Problem problem) : InputError(std::vector<Problem>{std::move(problem)}) {}

InputError::InputError(std::vector<Problem> problems)
    : std::runtime_error(message_of(problems)), problems_(std::move(problems)) {}

ContractViolation::ContractViolation(const char* condition, const char* file, int line)
    : std::logic_error(std::string(file) + ":" + std::to_string(line) + ": contract broken: " + condition) {}

FolderError::FolderError(Kind kind, const std::string& place, const std::string& reason, const std::string& remedy)
    : std::system_error(code_of(kind)),
      kind_(kind),
      problem_{place, "", reason, remedy},
      text_((place.empty() ? "" : place + ": ") + reason + (remedy.empty() ? "" : "; " + remedy)) {}

FolderError::FolderError(const std::system_error& cause)
    : std::system_error(cause.code()), kind_(Kind::missing), problem_{"", "", cause.what(), ""}, text_(cause.what()) {}

}  // namespace rocking::base
