#include "fuzz/mutate_json.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "rocking/base/digest.hpp"

namespace rocking::fuzz {
namespace {

/// Pointers to every value of a document, including the document itself.
std::vector<Json::json_pointer> places_of(const Json& document) {
  std::vector<Json::json_pointer> places{Json::json_pointer()};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Json::json_pointer place = places[i];
    const Json& value = document.at(place);
    if (value.is_object()) {
      for (const auto& [key, part] : value.items()) places.push_back(place / key);
    } else if (value.is_array()) {
      for (std::size_t index = 0; index < value.size(); ++index) places.push_back(place / index);
    }
  }
  return places;
}

/// The object with its keys replaced by `name(index, key)`; an empty name removes the member.
template <class Name>
Json renamed(const Json& object, Name name) {
  Json result = Json::object();
  std::size_t index = 0;
  for (const auto& [key, part] : object.items()) {
    const std::string chosen = name(index++, key);
    if (!chosen.empty()) result[chosen] = part;
  }
  return result;
}

}  // namespace

Json JsonMutator::damaged(Json document) {
  const int changes = 1 + random_.below(3);
  for (int i = 0; i < changes; ++i) change(document);
  return document;
}

void JsonMutator::change(Json& document) {
  const auto places = places_of(document);
  Json& value = document.at(places[below(places.size())]);
  if (value.is_structured() && !value.empty() && random_.below(3) > 0) {
    change_members(value);
  } else {
    change_value(value, document);
  }
}

void JsonMutator::change_members(Json& value) {
  const std::size_t chosen = below(value.size());
  if (value.is_array()) {
    switch (random_.below(4)) {
      case 0: value.erase(chosen); break;
      case 1: value.push_back(Json(value[chosen])); break;
      case 2: std::reverse(value.begin(), value.end()); break;
      default: value.push_back(strange_value());
    }
    return;
  }
  switch (random_.below(3)) {
    case 0:
      value = renamed(value, [chosen](std::size_t i, const std::string& key) { return i == chosen ? "" : key; });
      break;
    case 1:
      value =
          renamed(value, [chosen](std::size_t i, const std::string& key) { return i == chosen ? key + "<b>" : key; });
      break;
    default: value["\x1b[31m<script>" + std::to_string(random_.below(10))] = strange_value();
  }
}

void JsonMutator::change_value(Json& value, const Json& document) {
  const int kind = random_.below(4);
  if (kind == 0) {
    const auto places = places_of(document);
    value = Json(document.at(places[below(places.size())]));
  } else if (kind == 1 && value.is_number()) {
    const double number = value.get<double>();
    const double changes[] = {number + 1.0,  number - 1.0, -number,
                              10.0 * number, 0.5 * number, std::nextafter(number, 1e9)};
    const double changed = changes[below(std::size(changes))];
    const bool whole = value.is_number_integer() && std::trunc(changed) == changed && std::abs(changed) < 1e15;
    value = whole
                ? (changed < 0.0 ? Json(static_cast<std::int64_t>(changed)) : Json(static_cast<std::uint64_t>(changed)))
                : Json(changed);
  } else {
    value = strange_value();
  }
}

Json JsonMutator::strange_value() {
  switch (random_.below(20)) {
    case 0: return nullptr;
    case 1: return true;
    case 2: return -1;
    case 3: return 0;
    case 4: return 1e308;
    case 5: return -1e308;
    case 6: return 5e-324;
    case 7: return UINT64_MAX;
    case 8: return INT64_MIN;
    case 9: return 0.5;
    case 10: return "";
    case 11: return "</script><script>alert(1)</script>";
    case 12: return "'`touch x`\" \\ \n\x1b]0;x\x07";
    case 13: return std::string(200'000, '1');
    case 14: return "(" + std::string(100'000, '1') + ",1)";
    case 15: return Json::array();
    case 16: return Json::object();
    case 17: return Json::array({0.0, 1.0, nullptr});
    case 18: return Json::object({{"mean", 1e300}, {"sigma", -1}});
    default: return 1'000'000'000'000'000'000ULL;
  }
}

std::string JsonMutator::damaged_text(std::string text) {
  const int changes = 1 + random_.below(3);
  for (int i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t place = below(text.size());
    const std::size_t length = std::min(text.size() - place, 1 + below(40));
    switch (random_.below(6)) {
      case 0: text[place] = static_cast<char>(static_cast<unsigned char>(text[place]) ^ (1U << below(8))); break;
      case 1: text.erase(place, length); break;
      case 2: text.insert(place, text.substr(place, length)); break;
      case 3: text[place] = '\0'; break;
      case 4: text[place] = static_cast<char>(0x80 + below(128)); break;
      default: text.resize(place);
    }
  }
  return text;
}

Json sealed(Json report) {
  const Json::json_pointer experiment("/input/experiment");
  const Json::json_pointer digest("/input/sha256");
  if (!report.contains(experiment) || !report.contains(digest)) return report;
  report[digest] = base::to_hex(base::sha256(report[experiment].dump(-1, ' ', false, Json::error_handler_t::replace)));
  return report;
}

}  // namespace rocking::fuzz
