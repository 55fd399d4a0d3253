#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string_view>
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
    void write(const void* value, std::string_view key, JsonWriter& out) const override {
      const auto& held = *static_cast<const std::optional<T>*>(value);
      held ? type_of<T>().write(&*held, key, out) : out.member(key, Json());
    }
    void read(const Json& json, const ReadingPlace& place, void* value) const override {
      auto& held = *static_cast<std::optional<T>*>(value);
      if (json.is_null()) return held.reset();
      type_of<T>().read(json, place, &held.emplace());
    }
    void check(const void* value, const ReadingPlace& place) const override {
      const auto& held = *static_cast<const std::optional<T>*>(value);
      if (held) type_of<T>().check(&*held, place);
    }
    [[nodiscard]] Json schema(const Rule& rule) const override { return or_null(type_of<T>().schema(rule)); }
    void describe(const std::string& prefix, std::vector<KeyRow>& rows) const override {
      type_of<T>().describe(prefix, rows);
    }
  };
  static const ValueType& get() { return the_only<Type>(); }
};

/// A key that may be absent, and whose value may be null: for fields that are omitted without a value.
template <class T>
struct TypeOf<std::optional<std::optional<T>>> {
  class Type final : public ValueType {
   public:
    [[nodiscard]] Json json(const void* value) const override {
      const auto& held = *static_cast<const std::optional<std::optional<T>>*>(value);
      return held ? inner().json(&*held) : Json();
    }
    void read(const Json& json, const ReadingPlace& place, void* value) const override {
      inner().read(json, place, &static_cast<std::optional<std::optional<T>>*>(value)->emplace());
    }
    void check(const void* value, const ReadingPlace& place) const override {
      const auto& held = *static_cast<const std::optional<std::optional<T>>*>(value);
      if (held) inner().check(&*held, place);
    }
    [[nodiscard]] Json schema(const Rule& rule) const override { return inner().schema(rule); }
    void describe(const std::string& prefix, std::vector<KeyRow>& rows) const override {
      inner().describe(prefix, rows);
    }

   private:
    static const ValueType& inner() { return type_of<std::optional<T>>(); }
  };
  static const ValueType& get() { return the_only<Type>(); }
};

/// A list of any length, or of `size` entries. `item_type` gives the type of an entry.
template <class List, std::size_t size = 0, const ValueType& (*item_type)() = type_of<typename List::value_type>>
class ListType : public ValueType {
  using Item = typename List::value_type;

 public:
  [[nodiscard]] Json json(const void* value) const override {
    Json list = Json::array();
    for (const Item& item : *static_cast<const List*>(value)) list.push_back(item_type().json(&item));
    return list;
  }
  void write(const void* value, std::string_view key, JsonWriter& out) const override {
    const auto& list = *static_cast<const List*>(value);
    if (list.empty()) return out.member(key, Json::array());
    out.begin_list(key);
    for (const Item& item : list) item_type().write_element(&item, out);
    out.end();
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    auto& list = *static_cast<List*>(value);
    if constexpr (size > 0) {
      if (!json.is_array() || json.size() != size) {
        return place.reject(json, "must be a list of " + std::to_string(size) + " entries");
      }
    } else {
      if (!json.is_array()) return place.reject(json, "must be a list");
      list.assign(json.size(), Item{});
    }
    for (std::size_t i = 0; i < list.size(); ++i) item_type().read(json[i], place.at(std::to_string(i)), &list[i]);
  }
  void check(const void* value, const ReadingPlace& place) const override {
    std::size_t i = 0;
    for (const Item& item : *static_cast<const List*>(value)) item_type().check(&item, place.at(std::to_string(i++)));
  }
  [[nodiscard]] Json schema(const Rule& rule) const override {
    Json schema = {{"type", "array"}, {"items", item_type().schema(rule)}};
    if (size > 0) schema.update({{"minItems", size}, {"maxItems", size}});
    return schema;
  }
  void describe(const std::string& prefix, std::vector<KeyRow>& rows) const override {
    item_type().describe(prefix + "[i]", rows);
  }
};

/// A list with a line for each entry, so that thousands of entries remain readable, also for tools that read lines.
template <class List, const ValueType& (*item_type)() = type_of<typename List::value_type>>
class LinesType final : public ListType<List, 0, item_type> {
 public:
  void write(const void* value, std::string_view key, JsonWriter& out) const override {
    const auto& list = *static_cast<const List*>(value);
    if (list.empty()) return out.member(key, Json::array());
    out.begin_list(key);
    for (const auto& item : list) out.line(item_type().json(&item));
    out.end();
  }
};

template <class T>
struct TypeOf<std::vector<T>> {
  static const ValueType& get() { return the_only<ListType<std::vector<T>>>(); }
};

template <class T, std::size_t size>
struct TypeOf<std::array<T, size>> {
  static const ValueType& get() { return the_only<ListType<std::array<T, size>, size>>(); }
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
    void check(const void* value, const ReadingPlace& place) const override {
      for (const auto& [key, item] : *static_cast<const std::map<Key, T>*>(value)) {
        type_of<T>().check(&item, place.at(type_of<Key>().json(&key).template get<std::string>()));
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
  static const ValueType& get() { return the_only<Type>(); }
};

}  // namespace rocking
