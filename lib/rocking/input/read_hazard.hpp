#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/scene/hazard.hpp"

namespace rocking {

/// Most points of a hazard curve, and most bytes of its file.
inline constexpr std::size_t most_hazard_points = 10'000;
inline constexpr std::size_t most_hazard_bytes = 10'000'000;

/// Reads a hazard curve of any format that is known: two columns, OpenQuake's CSV or NRML, CSV or JSON of the USGS.
///
/// Two columns: a line `intensity, annual rate of exceedance`, or `intensity, probability of exceedance`, for each point,
/// between commas, semicolons or blanks; `#` begins a comment. The first line names the columns (lib/docs/formats.md);
/// without it `reading` names the measure, and the numbers are rates, or probabilities if it has years.
///
/// A probability P in T years is the rate -ln(1 - P)/T. Of several curves `reading` chooses one. `name`: of the file.
///
/// Throws base::InputError with line, value and remedy of every fault: several curves of which none is chosen, or none
/// that is asked for, names that are not known, a time of the probabilities that is not stated or stated twice, a line
/// without two numbers, an intensity that is not positive or does not rise, a rate that rises, a probability above 1,
/// intensities that are in another unit than their name says, fewer than two points or more than `most_hazard_points`, a
/// text of more than `most_hazard_bytes`.
[[nodiscard]] HazardCurve read_hazard(std::string_view text, const std::string& name,
                                      const HazardReading& reading = {});

/// Reads rates of occurrence over two measures: lines of both and `annual_rate`, of which the first names the columns.
/// `measures`: x and y. Throws base::InputError with the line of a fault.
[[nodiscard]] JointHazard read_joint_hazard(std::string_view text, const std::string& name,
                                            const std::vector<std::string>& measures);

/// The measure of a column of intensities.
struct HazardMeasure {
  std::string name;      ///< as a run names its own: `pga_g`, `sa_g[0.5]`, `avgsa_g[0.2-2]`
  double divisor = 1.0;  ///< of the numbers in the file, which gives them the unit of the name
};

/// Reads the name of a measure: the key of a sweep or its pointer, with periods in brackets; `PGA`, `PGV` (in cm/s) and
/// `SA(0.5)` as OpenQuake writes them, `PSA(0.5)`, `SA(0.5s)`; `SA0P5` as the USGS does; `pgv_cm_s`. Absent: it is none of these.
[[nodiscard]] std::optional<HazardMeasure> hazard_measure(std::string_view word);

/// What a column says of how often intensities are exceeded.
struct HazardKind {
  bool is_probability = false;
  std::optional<double> years = std::nullopt;  ///< of the probability, where the name states it
};

/// Reads the name of a column: annual rate or frequency of exceedance, or probability of exceedance (`poe`, `poe[50]`,
/// `annual_poe`), in the usual spellings. Absent: it is none of these.
[[nodiscard]] std::optional<HazardKind> hazard_kind(std::string_view word);

/// The number that a field is; absent: it is none, or not finite.
[[nodiscard]] std::optional<double> hazard_number(const std::string& field);

/// Takes what a file says of a hazard curve, whatever its format: its measure, what its numbers are, its points. Collects
/// the problems; `place` is that of a fault, `h.csv, line 3`.
class HazardPoints {
 public:
  /// `name`: of the file.
  HazardPoints(std::string name, HazardReading reading);

  void reject(std::string place, std::string found, std::string reason, std::string remedy);
  [[nodiscard]] std::size_t size() const { return curve_.points.size(); }
  /// Whether more need not be read: there are too many points, or too many problems.
  [[nodiscard]] bool is_enough() const;
  void set_header_line(std::size_t line) { curve_.header_line = line; }
  void set_origin(const std::string& statistic, const std::optional<HazardSite>& site);

  /// The measure that the file names; absent: it names none, and the reading must.
  void set_measure(const std::string& place, const std::optional<HazardMeasure>& named);
  /// What the numbers are; `word`: as the file says it.
  void set_kind(const std::string& place, const std::string& word, const HazardKind& kind);
  /// A point, both numbers as written. After measure and kind. Points with the probability 1 before all others are left
  /// out: no rate gives it.
  void add(const std::string& place, const std::string& intensity, const std::string& value);

  /// The curve. Throws base::InputError with all problems.
  [[nodiscard]] HazardCurve finish();

  static constexpr const char* known_measures =
      "name the measure as the sweep does, pga_g, pgv_m_s or sa_g[0.5], or as OpenQuake does, PGA, PGV or SA(0.5)";

 private:
  void check_whole();
  void check_unit();

  HazardReading reading_;
  HazardMeasure measure_;
  HazardCurve curve_;
  std::vector<base::Problem> problems_;
};

/// One of the curves of a file.
struct HazardInFile {
  std::string place = {};      ///< `h.xml, line 3`
  std::string measure = {};    ///< as the file names it; empty: it does not
  std::string statistic = {};  ///< HazardCurve::statistic
  std::optional<HazardSite> site = {};
  HazardKind kind = {};
  /// Gives the points, while the text of the file is there.
  std::function<void(HazardPoints&)> add_points = {};
};

/// The curves of a file, by its format; `name`: of the file. Throw base::InputError where the text has not this format.
[[nodiscard]] std::vector<HazardInFile> nrml_hazards(std::string_view text, const std::string& name);
[[nodiscard]] std::vector<HazardInFile> usgs_json_hazards(std::string_view text, const std::string& name);
/// Of a table with a line for each site, as OpenQuake and the USGS write it. Absent: it is no such table.
[[nodiscard]] std::optional<std::vector<HazardInFile>> hazard_table(std::string_view text, const std::string& name);

/// `quantile_0.840` as `quantile-0.84`, in small letters.
[[nodiscard]] std::string statistic_word(std::string_view text);

/// The curve that `reading` chooses of several, or the only one. Throws base::InputError with the list if there are more.
[[nodiscard]] HazardCurve chosen_hazard(std::vector<HazardInFile> curves, const std::string& name,
                                        const HazardReading& reading);

}  // namespace rocking
