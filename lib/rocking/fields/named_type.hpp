#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "rocking/fields/value_type.hpp"

namespace rocking {

/// Enumerators that stand in documents by their names. `names`: a std::array of them, in the order of the enumerators.
template <class Enumeration, const auto& names>
class NamedType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    return std::string(names[static_cast<std::size_t>(*static_cast<const Enumeration*>(value))]);
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    const auto found = std::ranges::find(names, json.is_string() ? json.get<std::string>() : "");
    if (found == names.end()) return place.reject(json, "must be one of " + list());
    *static_cast<Enumeration*>(value) = static_cast<Enumeration>(found - names.begin());
  }
  [[nodiscard]] Json schema(const Rule&) const override { return {{"type", "string"}, {"enum", names}}; }

 private:
  static std::string list() {
    std::string text;
    for (const std::string_view name : names) (text += text.empty() ? "" : ", ") += name;
    return text;
  }
};

}  // namespace rocking
