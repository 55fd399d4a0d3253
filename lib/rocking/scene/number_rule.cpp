#include "rocking/scene/number_rule.hpp"

namespace rocking {
namespace {
std::string such_as(std::string_view example) { return "give a value such as " + std::string(example); }
}  // namespace

std::string NumberRule::remedy() const { return such_as(example); }

std::string IntegerRule::demand() const {
  return "must be a whole number from " + std::to_string(low) + " to " + std::to_string(high);
}

std::string IntegerRule::remedy() const { return such_as(std::to_string(example)); }

}  // namespace rocking
