#include <array>
#include <memory>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/input/read_hazard.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

/// A value of a document with its place in it; null where it is not there.
struct JsonAt {
  const Json* value = nullptr;
  std::string pointer = {};

  [[nodiscard]] JsonAt at(std::string_view key) const {
    if (value == nullptr || !value->is_object()) return {};
    const auto found = value->find(key);
    return found == value->end() ? JsonAt{} : JsonAt{&*found, child_pointer(pointer, key)};
  }
  [[nodiscard]] std::vector<JsonAt> elements() const {
    std::vector<JsonAt> list;
    if (value == nullptr || !value->is_array()) return list;
    for (std::size_t i = 0; i < value->size(); ++i) {
      list.push_back({&(*value)[i], child_pointer(pointer, std::to_string(i))});
    }
    return list;
  }
  [[nodiscard]] std::string text() const {
    return value != nullptr && value->is_string() ? value->get<std::string>() : "";
  }
  [[nodiscard]] std::optional<double> number() const {
    return value != nullptr && value->is_number() ? std::optional(value->get<double>()) : std::nullopt;
  }
  explicit operator bool() const { return value != nullptr; }
};

/// The first of these keys that one of these objects has.
template <std::size_t number>
JsonAt first_of(const std::vector<JsonAt>& objects, const std::array<std::string_view, number>& keys) {
  for (const JsonAt& object : objects) {
    for (const std::string_view key : keys) {
      if (JsonAt found = object.at(key)) return found;
    }
  }
  return {};
}

constexpr std::array<std::string_view, 3> intensity_keys{"xs", "xvalues", "xvals"};
constexpr std::array<std::string_view, 3> rate_keys{"ys", "yvalues", "yvals"};

void add_points(HazardPoints& points, const std::string& name, const JsonAt& intensities, const JsonAt& rates) {
  const std::vector<JsonAt> x = intensities.elements(), y = rates.elements();
  const std::string place = name + ", ";
  if (x.size() != y.size()) {
    return points.reject(place + rates.pointer, std::to_string(y.size()) + " rates",
                         "do not fit " + std::to_string(x.size()) + " intensities", "give one for each");
  }
  for (std::size_t i = 0; i < x.size() && !points.is_enough(); ++i) {
    points.add(place + y[i].pointer, brief(*x[i].value), brief(*y[i].value));
  }
}

/// Reads what the hazard services of the USGS answer: `response` is a list of measures, or has one, `hazardCurves`. Each
/// has the curves of its sources, of which that of all together is meant.
class UsgsHazards {
 public:
  UsgsHazards(std::string_view text, std::string name)
      : document_(std::make_shared<const Json>(parsed(text, name))), name_(std::move(name)) {}

  std::vector<HazardInFile> read() {
    const JsonAt root{document_.get()};
    const JsonAt response = root.at("response");
    if (!response) refuse({}, "is no answer of the hazard service of the USGS", "give a file with a key response");
    const JsonAt curves = response.at("hazardCurves");
    for (const JsonAt& of_measure : (curves ? curves : response).elements()) {
      add_measure(of_measure, {of_measure.at("metadata"), of_measure, root.at("request"), response.at("metadata")});
    }
    if (curves_.empty()) refuse(response, "has no hazard curve", "give the answer of the service as it is");
    return std::move(curves_);
  }

 private:
  static Json parsed(std::string_view text, const std::string& name) {
    try {
      return parse_json(text);
    } catch (const base::InputError& error) {
      std::vector<base::Problem> problems = error.problems();
      for (base::Problem& problem : problems)
        problem.place = name + (problem.place.empty() ? "" : ", " + problem.place);
      throw base::InputError(std::move(problems));
    }
  }

  [[noreturn]] void refuse(const JsonAt& where, std::string reason, std::string remedy) const {
    const std::string place = where.pointer.empty() ? name_ : name_ + ", " + where.pointer;
    throw base::InputError({place, "", std::move(reason), std::move(remedy)});
  }

  /// `around`: objects with what holds for all of its curves.
  void add_measure(const JsonAt& of_measure, const std::vector<JsonAt>& around) {
    const JsonAt measure = first_of(around, std::array<std::string_view, 1>{"imt"});
    const std::vector<JsonAt> all = of_measure.at("data").elements();
    const std::size_t before = curves_.size();
    for (const JsonAt& each : all) {
      const std::string component = each.at("component").text();
      if (!component.empty() && component != "Total") continue;
      std::vector<JsonAt> objects{each.at("values"), each};
      objects.insert(objects.end(), around.begin(), around.end());
      const JsonAt x = first_of(objects, intensity_keys), y = first_of(objects, rate_keys);
      if (!x || !y) refuse(each, "has no intensities or no rates", "give lists xs and ys, or xvalues and yvalues");
      curves_.push_back({.place = name_ + ", " + each.pointer,
                         .measure = measure.at("value") ? measure.at("value").text() : measure.text(),
                         .site = site_in(objects),
                         .add_points = [document = document_, name = name_, x, y](HazardPoints& points) {
                           rocking::add_points(points, name, x, y);
                         }});
    }
    if (curves_.size() == before)
      refuse(of_measure, "has no component Total", "give the curve of all sources together");
  }

  static std::optional<HazardSite> site_in(const std::vector<JsonAt>& objects) {
    const auto longitude = first_of(objects, std::array<std::string_view, 1>{"longitude"}).number();
    const auto latitude = first_of(objects, std::array<std::string_view, 1>{"latitude"}).number();
    if (!longitude || !latitude) return std::nullopt;
    return HazardSite{.longitude = *longitude, .latitude = *latitude};
  }

  std::shared_ptr<const Json> document_;
  std::string name_;
  std::vector<HazardInFile> curves_;
};

}  // namespace

std::vector<HazardInFile> usgs_json_hazards(std::string_view text, const std::string& name) {
  return UsgsHazards(text, name).read();
}

}  // namespace rocking
