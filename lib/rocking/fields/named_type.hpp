#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
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

/// Enumerators that stand in documents by their names. `names`: a std::array of them, in the order of the enumerators.
template <class Enumeration, const auto& names>
class WordType final : public ValueType {
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
