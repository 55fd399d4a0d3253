#include "rocking/scene/counted_tests.hpp"

#include <algorithm>

#include "rocking/base/error.hpp"

namespace rocking {
namespace {

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

std::vector<section::ResponseMode> modes_in_group(std::string_view name, const std::string& place) {
  if (name == "other") return {};
  std::vector<section::ResponseMode> modes;
  for (std::size_t first = 0; first <= name.size();) {
    const std::size_t end = std::min(name.find('|', first), name.size());
    const std::string_view one = without_blanks(name.substr(first, end - first));
    first = end + 1;
    const auto mode = section::response_mode_named(one);
    if (!mode) {
      throw base::InputError({place, std::string(one), "is no response mode",
                              "write modes such as (1,1), chaotic, overturned or rest, joined by |; or \"other\" alone "
                              "for all that are not named"});
    }
    modes.push_back(*mode);
  }
  return modes;
}

std::size_t group_of(const std::vector<ModeGroup>& groups, const section::ResponseMode& mode) {
  for (std::size_t i = 0; i + 1 < groups.size(); ++i) {
    if (std::ranges::find(groups[i].modes, mode) != groups[i].modes.end()) return i;
  }
  return groups.size() - 1;
}

}  // namespace rocking
