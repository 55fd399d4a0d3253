#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>

#include "arguments.hpp"
#include "commands.hpp"
#include "exit_code.hpp"
#include "rocking/api/checks.hpp"
#include "rocking/output/check_normal_fields.hpp"
#include "rocking/output/check_normal_summary.hpp"
#include "rocking/text/number_text.hpp"
#include "study_file.hpp"
#include "usage.hpp"

namespace rocking::program {
namespace {

struct CheckNormalCommand {
  SamplerQuestion question;
  std::string seed = "0x2012";
  std::string law = std::string(fluctuation_law_names.front());
  Loudness loudness;
};

SamplerQuestion question_of(const CheckNormalCommand& command) {
  SamplerQuestion question = command.question;
  const auto seed = seed_from_text(command.seed);
  if (!seed) {
    throw UsageError("--seed " + command.seed +
                     ": must be a whole number of at most 64 bits; give a value such as 0x2012 or 8210");
  }
  question.seed = *seed;
  const auto place = std::ranges::find(fluctuation_law_names, command.law) - fluctuation_law_names.begin();
  question.distribution = static_cast<FluctuationLaw>(place);
  return question;
}

ExitCode check_normal(const CheckNormalCommand& command) {
  const SamplerQuestion question = question_of(command);
  SamplerCheck check;
  try {
    check = sampler_check(question, rocking::check_normal(question));
  } catch (const base::InputError& error) {
    throw with_flags(error, {{"mean", "--mean"}, {"sigma", "--sigma"}});
  }
  print_study(command.loudness, check_normal_document().text(check), check_normal_summary(check));
  if (!stats::is_refuted(check.found)) return ExitCode::done;
  print_notice("these numbers do not follow the distribution: a p-value is below 1e-6");
  return ExitCode::check_failed;
}

}  // namespace

void add_check_normal(CLI::App& app, Action& action) {
  const auto request = std::make_shared<CheckNormalCommand>();
  CLI::App* command = app.add_subcommand("check-normal", "Test the random numbers: moments, tests of fit, histogram");
  command->footer(
      "Example: rocking check-normal --n 20000 --mean 0.4 --sigma 0.03\n"
      "generates 20000 friction coefficients as a simulation does and compares them with the normal distribution, or "
      "with that of --law.");
  command->add_option("--n", request->question.n, "How many numbers")
      ->check(whole_number(20, 100'000'000))
      ->capture_default_str()
      ->type_name("N");
  command->add_option("--mean", request->question.law.mean, "Mean of the distribution")
      ->check(number(-1e6, 1e6))
      ->capture_default_str()
      ->type_name("M");
  command->add_option("--sigma", request->question.law.sigma, "Standard deviation of the distribution")
      ->check(number(0.0, 1e6))
      ->capture_default_str()
      ->type_name("S");
  command->add_option("--law", request->law, "Distribution of the numbers")
      ->check(one_of({fluctuation_law_names.begin(), fluctuation_law_names.end()}))
      ->capture_default_str()
      ->type_name("NAME");
  command->add_option("--seed", request->seed, "Seed, for example 0x2012 or 8210")
      ->capture_default_str()
      ->type_name("S");
  command->add_option("--sampler", request->question.sampler, "Method for normal numbers; simulations use box-muller")
      ->check(one_of({"box-muller", "ziggurat", "inverse-cdf"}))
      ->capture_default_str()
      ->type_name("NAME");
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return check_normal(*request); }; });
}

}  // namespace rocking::program
