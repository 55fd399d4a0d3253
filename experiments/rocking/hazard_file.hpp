#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "rocking/scene/hazard.hpp"

namespace rocking::program {

/// The hazard curve of a command: `--hazard` names its file, `--years` and `--imt` say what the file leaves open.
class HazardFile {
 public:
  /// `effect`: what the curve gives, for the help.
  void add_to(CLI::App& command, const std::string& effect);

  [[nodiscard]] bool is_given() const { return !file_.empty(); }
  /// Absent if no file is named. Throws MissingInput, and base::InputError as hazard_curve().
  [[nodiscard]] std::optional<HazardCurve> read() const;
  /// The flags, as they were given.
  [[nodiscard]] std::string flags() const;

 private:
  std::string file_;
  HazardReading reading_;
};

}  // namespace rocking::program
