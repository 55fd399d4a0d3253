#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "rocking/fields/value_type.hpp"

/// What stands in documents as null or a value, as a list, and as an object with one key for each entry.
namespace rocking {

template <class T>
struct TypeOf<std::optional<T>> {
  class Type final : public ValueType {
   public:
    [[nodiscard]] Json json(const void* value) const override {
      const auto& held = *static_cast<const std::optional<T>*>(value);
      return held ? type_of<T>().json(&*held) : Json();
    }
    void read(const Json& json, const ReadingPlace& place, void* value) const override {
      auto& held = *static_cast<std::optional<T>*>(value);
      if (json.is_null()) return held.reset();
      type_of<T>().read(json, place, &held.emplace());
    }
    [[nodiscard]] Json schema(const Rule& rule) const override { return or_null(type_of<T>().schema(rule)); }
    void describe(const std::string& prefix, std::vector<KeyRow>& rows) const override {
      type_of<T>().describe(prefix, rows);
    }
  };
  static const ValueType& get() {
    static const Type type;
    return type;
  }
};

template <class T>
struct TypeOf<std::vector<T>> {
  class Type final : public ValueType {
   public:
    [[nodiscard]] Json json(const void* value) const override {
      Json list = Json::array();
      for (const T& item : *static_cast<const std::vector<T>*>(value)) list.push_back(type_of<T>().json(&item));
      return list;
    }
    void read(const Json& json, const ReadingPlace& place, void* value) const override {
      if (!json.is_array()) return place.reject(json, "must be a list");
      auto& list = *static_cast<std::vector<T>*>(value);
      list.assign(json.size(), T{});
      for (std::size_t i = 0; i < list.size(); ++i) type_of<T>().read(json[i], place.at(std::to_string(i)), &list[i]);
    }
    [[nodiscard]] Json schema(const Rule& rule) const override {
      return {{"type", "array"}, {"items", type_of<T>().schema(rule)}};
    }
    void describe(const std::string& prefix, std::vector<KeyRow>& rows) const override {
      type_of<T>().describe(prefix + "[i]", rows);
    }
  };
  static const ValueType& get() {
    static const Type type;
    return type;
  }
};

template <class T, std::size_t size>
struct TypeOf<std::array<T, size>> {
  class Type final : public ValueType {
   public:
    [[nodiscard]] Json json(const void* value) const override {
      Json list = Json::array();
      for (const T& item : *static_cast<const std::array<T, size>*>(value)) list.push_back(type_of<T>().json(&item));
      return list;
    }
    void read(const Json& json, const ReadingPlace& place, void* value) const override {
      if (!json.is_array() || json.size() != size) {
        return place.reject(json, "must be a list of " + std::to_string(size) + " entries");
      }
      auto& list = *static_cast<std::array<T, size>*>(value);
      for (std::size_t i = 0; i < size; ++i) type_of<T>().read(json[i], place.at(std::to_string(i)), &list[i]);
    }
    [[nodiscard]] Json schema(const Rule& rule) const override {
      return {{"type", "array"}, {"items", type_of<T>().schema(rule)}, {"minItems", size}, {"maxItems", size}};
    }
    void describe(const std::string& prefix, std::vector<KeyRow>& rows) const override {
      type_of<T>().describe(prefix + "[i]", rows);
    }
  };
  static const ValueType& get() {
    static const Type type;
    return type;
  }
};

/// Keys are values that stand in documents as texts.
template <class Key, class T>
struct TypeOf<std::map<Key, T>> {
  class Type final : public ValueType {
   public:
    [[nodiscard]] Json json(const void* value) const override {
      Json object = Json::object();
      for (const auto& [key, item] : *static_cast<const std::map<Key, T>*>(value)) {
        object[type_of<Key>().json(&key).template get<std::string>()] = type_of<T>().json(&item);
      }
      return object;
    }
    void read(const Json& json, const ReadingPlace& place, void* value) const override {
      if (!json.is_object()) return place.reject(json, "must be an object");
      auto& map = *static_cast<std::map<Key, T>*>(value);
      map.clear();
      for (const auto& [text, item] : json.items()) {
        Key key{};
        T read{};
        type_of<Key>().read(Json(text), place.at(text), &key);
        type_of<T>().read(item, place.at(text), &read);
        map.emplace(std::move(key), std::move(read));
      }
    }
    [[nodiscard]] Json schema(const Rule& rule) const override {
      return {{"type", "object"},
              {"propertyNames", type_of<Key>().schema({})},
              {"additionalProperties", type_of<T>().schema(rule)}};
    }
    void describe(const std::string& prefix, std::vector<KeyRow>& rows) const override {
      type_of<T>().describe(prefix + ".NAME", rows);
    }
  };
  static const ValueType& get() {
    static const Type type;
    return type;
  }
};

}  // namespace rocking
