#include <cstdint>
#include <memory>

#include "commands.hpp"
#include "output.hpp"
#include "rocking/input/read_quantity.hpp"
#include "rocking/output/check_normal_fields.hpp"
#include "rocking/output/check_normal_summary.hpp"
#include "rocking/studies/check_sampler.hpp"
#include "rocking/text/seed_text.hpp"
#include "usage.hpp"

namespace rocking::program {
namespace {

struct CheckNormalRequest {
  std::uint64_t n = 20'000;
  stats::NormalLaw law{.mean = 0.4, .sigma = 0.03};
  std::string seed = "0x2012";
  std::string sampler = "box-muller";
  Loudness loudness;
};

ExitCode check_normal(const CheckNormalRequest& request) {
  const auto seed = seed_from_text(request.seed);
  if (!seed)
    throw UsageError("--seed " + request.seed +
                     ": must be a whole number of at most 64 bits; give a value such as 0x2012 or 8210");
  if (!(request.law.sigma > 0.0)) throw UsageError("--sigma: must be positive; give a value such as 0.03");
  const auto found = check_sampler({.n = request.n, .law = request.law, .seed = *seed, .sampler = request.sampler});
  if (!found)
    throw UsageError("--sigma: too small compared with --mean to give two different numbers; give a larger one");
  const SamplerCheck check{request.sampler, *seed, *found};
  print_result(request.loudness.json ? check_normal_document().text(check) : check_normal_summary(check));
  if (!stats::is_refuted(check.found)) return ExitCode::done;
  print_notice("these numbers do not follow the distribution: a p-value is below 1e-6");
  return ExitCode::check_failed;
}

}  // namespace

void add_check_normal(CLI::App& app, Action& action) {
  const auto request = std::make_shared<CheckNormalRequest>();
  CLI::App* command = app.add_subcommand("check-normal", "Test the random numbers: moments, tests of fit, histogram");
  command->footer(
      "Example: rocking check-normal --n 20000 --mean 0.4 --sigma 0.03\n"
      "generates 20000 friction coefficients as a simulation does and compares them with the normal distribution.");
  command->add_option("--n", request->n, "How many numbers")
      ->check(whole_number(20, 100'000'000))
      ->capture_default_str()
      ->type_name("N");
  command->add_option("--mean", request->law.mean, "Mean of the distribution")
      ->check(number(-1e6, 1e6))
      ->capture_default_str()
      ->type_name("M");
  command->add_option("--sigma", request->law.sigma, "Standard deviation of the distribution")
      ->check(number(0.0, 1e6))
      ->capture_default_str()
      ->type_name("S");
  command->add_option("--seed", request->seed, "Seed, for example 0x2012 or 8210")
      ->capture_default_str()
      ->type_name("S");
  command->add_option("--sampler", request->sampler, "Method for normal numbers; simulations use box-muller")
      ->check(one_of({"box-muller", "ziggurat", "inverse-cdf"}))
      ->capture_default_str()
      ->type_name("NAME");
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return check_normal(*request); }; });
}

}  // namespace rocking::program
