#pragma once

#include <algorithm>
#include <string>
#include <type_traits>

#include "rocking/fields/value_type.hpp"

namespace rocking {

/// Enumerators that stand in documents by their names, which `to_string` gives. `all`: a std::array of them.
template <const auto& all>
class NamedType final : public ValueType {
  using Enumeration = typename std::remove_cvref_t<decltype(all)>::value_type;

 public:
  [[nodiscard]] Json json(const void* value) const override {
    return std::string(to_string(*static_cast<const Enumeration*>(value)));
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    const std::string name = json.is_string() ? json.get<std::string>() : "";
    const auto found = std::ranges::find_if(all, [&name](Enumeration each) { return to_string(each) == name; });
    if (found == all.end()) return place.reject(json, "must be one of " + names());
    *static_cast<Enumeration*>(value) = *found;
  }
  [[nodiscard]] Json schema(const Rule&) const override {
    Json schema = {{"type", "string"}};
    for (const Enumeration each : all) schema["enum"].push_back(std::string(to_string(each)));
    return schema;
  }

 private:
  static std::string names() {
    std::string list;
    for (const Enumeration each : all) list += (list.empty() ? "" : ", ") + std::string(to_string(each));
    return list;
  }
};

}  // namespace rocking
