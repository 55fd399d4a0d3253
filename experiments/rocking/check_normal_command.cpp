#include <cstdint>
#include <memory>

#include "commands.hpp"
#include "output.hpp"
#include "rocking/input/read_quantity.hpp"
#include "rocking/output/check_normal_summary.hpp"
#include "rocking/output/write_check_normal.hpp"
#include "rocking/random/sampler.hpp"
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

/// The sample and its neighbours, each scaled to the law.
stats::NormalCheck check_sample(const CheckNormalRequest& request, std::uint64_t seed) {
  const random::SamplerKind kind = random::sampler_from_string(request.sampler).value();
  const auto drawn = [&](std::uint64_t realisation, random::Source source) {
    auto numbers = random::standard_sample(kind, {seed, realisation}, source, request.n);
    for (double& number : numbers) number = request.law.mean + request.law.sigma * number;
    return numbers;
  };
  const auto sample = drawn(0, random::Source::check_normal);
  const auto of_next_realisation = drawn(1, random::Source::check_normal);
  const auto of_next_source = drawn(0, random::Source::slip_rate);
  const auto check = stats::check_normal({sample, of_next_realisation, of_next_source}, request.law);
  if (!check)
    throw UsageError("--sigma: too small compared with --mean to give two different numbers; give a larger one");
  return *check;
}

ExitCode check_normal(const CheckNormalRequest& request) {
  const auto seed = seed_from_text(request.seed);
  if (!seed)
    throw UsageError("--seed " + request.seed +
                     ": must be a whole number of at most 64 bits; give a value such as 0x2012 or 8210");
  if (!(request.law.sigma > 0.0)) throw UsageError("--sigma: must be positive; give a value such as 0.03");
  const SamplerCheck check{request.sampler, *seed, check_sample(request, *seed)};
  print_result(request.loudness.json ? check_normal_text(check) : check_normal_summary(check));
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
