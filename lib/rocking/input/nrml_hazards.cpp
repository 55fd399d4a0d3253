#include <algorithm>
#include <memory>
#include <sstream>
#include <utility>

#include <pugixml.hpp>

#include "rocking/base/error.hpp"
#include "rocking/input/read_hazard.hpp"

namespace rocking {
namespace {

/// The name of an element without the prefix of its namespace.
std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  return name.substr(name.find(':') + 1);
}

bool is_element(const pugi::xml_node& node, std::string_view name) { return local_name(node) == name; }

/// The first element of this name below another one.
pugi::xml_node below(const pugi::xml_node& node, std::string_view name) {
  return node.find_node([name](const pugi::xml_node& each) { return is_element(each, name); });
}

/// All text of an element: what stands behind a comment, in CDATA and in elements below it, too.
std::string text_of(const pugi::xml_node& node) {
  std::string text = node.value();
  for (const pugi::xml_node& child : node.children()) text += text_of(child);
  return text;
}

std::vector<std::string> words_in(const pugi::xml_node& node) {
  std::istringstream text(text_of(node));
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(std::move(word));
  return words;
}

/// Reads the curves of an NRML file: elements `hazardCurves`, each with one measure and the curves of sites.
class NrmlHazards {
 public:
  NrmlHazards(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  std::vector<HazardInFile> read() {
    const pugi::xml_parse_result parsed =
        document_->load_buffer(text_.data(), text_.size(), pugi::parse_default | pugi::parse_ws_pcdata);
    if (!parsed) {
      refuse(line_at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0))), "",
             std::string("is not XML: ") + parsed.description(), "give the file as OpenQuake wrote it");
    }
    const pugi::xml_node root = document_->document_element();
    for (const pugi::xml_node& node : root.children()) {
      if (is_element(node, "hazardCurves")) add_curves(node);
    }
    if (curves_.empty()) {
      const pugi::xml_node first = root.find_child([](const pugi::xml_node& each) { return *each.name() != '\0'; });
      refuse(place_of(first ? first : root), first ? first.name() : root.name(), "is no hazard curve",
             "give NRML with an element hazardCurves, which has IMLs and the poEs of sites");
    }
    return std::move(curves_);
  }

 private:
  /// Lines are counted on from the place that was asked for last.
  [[nodiscard]] std::string line_at(std::size_t offset) {
    if (offset < counted_) counted_ = 0, lines_ = 1;
    lines_ += std::ranges::count(text_.substr(counted_, offset - counted_), '\n');
    counted_ = std::min(offset, text_.size());
    return name_ + ", line " + std::to_string(lines_);
  }
  [[nodiscard]] std::string place_of(const pugi::xml_node& node) {
    return line_at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)));
  }
  [[noreturn]] static void refuse(std::string place, std::string found, std::string reason, std::string remedy) {
    throw base::InputError({std::move(place), std::move(found), std::move(reason), std::move(remedy)});
  }

  /// `SA(0.1)` also where the period is another attribute.
  [[nodiscard]] std::string measure_of(const pugi::xml_node& curves) {
    const std::string name = curves.attribute("IMT").value();
    const std::string damping = curves.attribute("saDamping").value();
    const std::optional<double> per_cent = hazard_number(damping);
    if (!damping.empty() && per_cent != 5.0 && per_cent != 0.05) {
      refuse(place_of(curves), damping, "is another damping than the 5 % of spectral accelerations here",
             "give a hazard curve at 5 % damping");
    }
    const std::string period = curves.attribute("saPeriod").value();
    return period.empty() || name != "SA" ? name : name + '(' + period + ')';
  }

  static std::string statistic_of(const pugi::xml_node& curves) {
    const std::string statistic = curves.attribute("statistics").value();
    const std::string quantile = curves.attribute("quantileValue").value();
    if (!statistic.empty()) return statistic_word(quantile.empty() ? statistic : statistic + '-' + quantile);
    const std::string path = curves.attribute("sourceModelTreePath").value();
    return path.empty() ? "" : statistic_word(path + '/' + curves.attribute("gsimTreePath").value());
  }

  void add_curves(const pugi::xml_node& curves) {
    HazardInFile curve{
        .measure = measure_of(curves),
        .statistic = statistic_of(curves),
        .kind = {.is_probability = true, .years = hazard_number(curves.attribute("investigationTime").value())}};
    const pugi::xml_node levels = below(curves, "IMLs");
    if (!levels) refuse(place_of(curves), "hazardCurves", "has no IMLs", "give the intensities of its curves");
    for (const pugi::xml_node& node : curves.children()) {
      if (is_element(node, "hazardCurve")) add_curve(curve, node, levels);
    }
  }

  void add_curve(HazardInFile curve, const pugi::xml_node& node, const pugi::xml_node& levels) {
    const pugi::xml_node values = below(node, "poEs");
    curve.place = place_of(values ? values : node);
    const std::vector<std::string> position = words_in(below(node, "pos"));
    if (position.size() >= 2) {
      const auto longitude = hazard_number(position[0]), latitude = hazard_number(position[1]);
      if (longitude && latitude) curve.site = HazardSite{.longitude = *longitude, .latitude = *latitude};
    }
    curve.add_points = [document = document_, levels, values, place = curve.place](HazardPoints& points) {
      const std::vector<std::string> intensities = words_in(levels), probabilities = words_in(values);
      if (intensities.size() != probabilities.size()) {
        return points.reject(place, std::to_string(probabilities.size()) + " poEs",
                             "do not fit " + std::to_string(intensities.size()) + " IMLs", "give one for each");
      }
      for (std::size_t i = 0; i < intensities.size() && !points.is_enough(); ++i) {
        points.add(place, intensities[i], probabilities[i]);
      }
    };
    curves_.push_back(std::move(curve));
  }

  std::string_view text_;
  std::string name_;
  std::shared_ptr<pugi::xml_document> document_ = std::make_shared<pugi::xml_document>();
  std::vector<HazardInFile> curves_;
  std::size_t counted_ = 0;
  std::ptrdiff_t lines_ = 1;
};

}  // namespace

std::vector<HazardInFile> nrml_hazards(std::string_view text, const std::string& name) {
  return NrmlHazards(text, name).read();
}

}  // namespace rocking
