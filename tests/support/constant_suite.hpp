#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "rocking/input/read_experiment.hpp"
#include "rocking/text/json.hpp"
#include "support/split_mix.hpp"

namespace rocking::support {

/// A suite of closed form, as an experiment of the program. A record is a constant acceleration of c g, and the width B
/// of the block is lognormal: at rest it lifts, and then overturns, where the scale exceeds B/(H c). The capacity of a
/// realisation under a record is therefore lognormal, with the scatter of 1/c between records and of B within one.
struct ConstantSuite {
  std::size_t records = 20;
  std::vector<double> levels = {0.25, 0.3, 0.35, 0.4, 0.5, 0.6, 0.8};  ///< scales
  std::size_t realisations = 25;
  double median = 0.42;
  double between_records = 0.35;
  double within_record = 0.3;
  bool has_common_numbers = false;  ///< as the program had them up to results version 3: the same under all records

  /// One suite: its records by `random`, its realisations by a seed of it.
  [[nodiscard]] Experiment drawn(SplitMix& random) const {
    constexpr double height = 0.4;
    const double sigma = within_record;
    const double mean = median * height * std::exp(0.5 * sigma * sigma);
    Json json = {
        {"format", "rocking.experiment/1"},
        {"block",
         {{"width_m", {{"lognormal", {{"mean", mean}, {"sigma", mean * std::sqrt(std::expm1(sigma * sigma))}}}}},
          {"height_m", height}}},
        {"excitation", {{"kind", "recorded"}, {"format", "columns"}, {"units", "g"}}},
        {"restitution", 0.5},
        {"accuracy", {{"rerun_every", 0}}},
        {"sweep", {{{"parameter", "/excitation/scale"}, {"values", levels}}}},
        {"realisations", realisations},
        {"seed", std::to_string(random.bits())}};
    std::map<std::string, std::string> files;
    for (std::size_t r = 0; r < records; ++r) {
      const std::string name = "record_" + std::to_string(r) + ".txt";
      const std::string value = number_text(std::exp(-between_records * random.normal()));
      files[name] = "0 " + value + "\n6 " + value + '\n';
      json["excitation"]["suite"].push_back(name);
    }
    Experiment experiment = experiment_in(
        json.dump(), {}, {.files = [files](const std::string& name, std::size_t) { return files.at(name); }});
    if (has_common_numbers) {
      for (Condition& condition : experiment.conditions) condition.record_stream = 0;
    }
    return experiment;
  }

 private:
  static std::string number_text(double number) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
  }
};

}  // namespace rocking::support
