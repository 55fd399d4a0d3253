#include "hazard_file.hpp"

#include <fmt/format.h>

#include "exit_code.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/studies/fragility/question.hpp"

namespace rocking::program {

void HazardFile::add_to(CLI::App& command, const std::string& effect) {
  CLI::Option* file =
      command
          .add_option("--hazard", file_,
                      "Hazard curve (CSV: intensity, annual_rate or poe; its header names measure and kind): " + effect)
          ->type_name("FILE");
  command
      .add_option("--years", reading_.years,
                  "With --hazard: the years of its probabilities of exceedance, where the file does not state them")
      ->type_name("T")
      ->needs(file);
  command
      .add_option("--imt", reading_.measure,
                  "With --hazard: the intensity measure of the file, where it does not name it, such as PGA or SA(0.5)")
      ->type_name("MEASURE")
      ->needs(file);
}

std::optional<HazardCurve> HazardFile::read() const {
  if (!is_given()) return std::nullopt;
  return input_of([this] { return hazard_curve(file_, reading_); });
}

std::string HazardFile::flags() const {
  return fmt::format("--hazard {}{}{}", shell_word(file_),
                     reading_.years ? " --years " + base::shortest(*reading_.years) : "",
                     reading_.measure ? " --imt " + shell_word(*reading_.measure) : "");
}

}  // namespace rocking::program
