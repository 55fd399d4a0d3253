#pragma once

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "support/json_schema.hpp"
#include "support/record_text.hpp"

namespace rocking::support {

/// Five sines as a suite, seven levels, twenty realisations of each.
class FiveSines : public ProgramTest {
 protected:
  static constexpr std::size_t records = 5;

  /// Five decaying sines. The longest overturn the statue at some levels and not at the next.
  FiveSines() {
    std::filesystem::create_directory(folder_ / "records");
    for (std::size_t k = 0; k < records; ++k) write("records/r" + std::to_string(k) + ".at2", sine(k));
    write("e.json", experiment().dump());
    write("hazard.csv", "pga_g, annual_rate\n0.1, 1e-2\n0.5, 1e-3\n2, 1e-5\n");
  }

  static std::string sine(std::size_t number) {
    const double period = 0.5 + 0.15 * static_cast<double>(number);
    std::vector<double> accelerations;
    for (int i = 0; 0.02 * i <= 3.0 * period; ++i) {
      const double cycles = 0.02 * i / period;
      accelerations.push_back(0.3 * std::sin(2.0 * std::numbers::pi * cycles) * std::exp(-0.5 * cycles));
    }
    accelerations.push_back(0.0);
    return peer_at2(accelerations, ".02");
  }

  static Json experiment() {
    return Json::parse(R"({
      "format": "rocking.experiment/1", "title": "five sines", "block": { "width_m": 0.35, "height_m": 1.6 },
      "excitation": { "kind": "recorded", "suite": "records/*.at2" },
      "fluctuation": { "restitution": { "sigma": 0.05 } },
      "sweep": [ { "parameter": "/excitation/pga_g", "values": [0.2, 0.3, 0.4, 0.5, 0.65, 0.8, 1.0] } ],
      "realisations": 20, "seed": "0x21" })");
  }

  void run() const {
    const auto ran = rocking("run e.json -q --no-page -o out");
    ASSERT_EQ(ran.exit_code, 0) << ran.errors;
  }

  /// The output of `rocking fragility out` with these flags, which fits its schema.
  Json fragility(const std::string& flags = "") const {
    const auto found = rocking("fragility out --json " + flags);
    EXPECT_EQ(found.exit_code, 0) << found.errors;
    EXPECT_EQ(objections("fragility", found.output), "");
    return Json::parse(found.output);
  }

  /// Overturned realisations of a record at a level, by the report.
  std::size_t overturned(std::size_t record, std::size_t level) const {
    static const std::size_t levels = experiment()["sweep"][0]["values"].size();
    return Json::parse(
        read("out/report.json"))["result"]["conditions"][levels * record + level]["counts"]["overturned"];
  }
};

}  // namespace rocking::support
