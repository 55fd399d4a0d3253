#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rocking {

/// The measure of a column of intensities.
struct HazardMeasure {
  std::string name;      ///< as a run names its own: `pga_g`, `sa_g[0.5]`, `avgsa_g[0.2-2]`
  double divisor = 1.0;  ///< of the numbers in the file, which gives them the unit of the name
};

/// Reads the name of a measure: the key of a sweep or its pointer, with periods in brackets; `PGA`, `PGV` (in cm/s) and
/// `SA(0.5)` as OpenQuake writes them; `pgv_cm_s`. Absent: it is none of these.
[[nodiscard]] std::optional<HazardMeasure> hazard_measure(std::string_view word);

/// What a column says of how often intensities are exceeded.
struct HazardKind {
  bool is_probability = false;
  std::optional<double> years = std::nullopt;  ///< of the probability, where the name states it
};

/// Reads the name of a column: annual rate or frequency of exceedance, or probability of exceedance (`poe`, `poe[50]`,
/// `annual_poe`), in the usual spellings. Absent: it is none of these.
[[nodiscard]] std::optional<HazardKind> hazard_kind(std::string_view word);

}  // namespace rocking
