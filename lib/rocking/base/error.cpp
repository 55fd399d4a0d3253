#include "rocking/base/error.hpp"

#include <utility>

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

}  // namespace

std::string to_string(const Problem& problem) {
  std::string text = problem.place;
  if (!problem.value.empty()) text.append(" = ").append(problem.value);
  text.append(": ").append(problem.reason);
  if (!problem.remedy.empty()) text.append("; ").append(problem.remedy);
  return text;
}

InputError::InputError(Problem problem) : InputError(std::vector<Problem>{std::move(problem)}) {}

InputError::InputError(std::vector<Problem> problems)
    : std::runtime_error(message_of(problems)), problems_(std::move(problems)) {}

ContractViolation::ContractViolation(const char* condition, const char* file, int line)
    : std::logic_error(std::string(file) + ":" + std::to_string(line) + ": contract broken: " + condition) {}

}  // namespace rocking::base
