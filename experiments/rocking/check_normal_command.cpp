#include <cstdint>
#include <memory>
#include <vector>

#include "commands.hpp"
#include "output.hpp"
#include "rocking/random/sampler.hpp"
#include "rocking/report/read_quantity.hpp"
#include "rocking/report/write_check_normal.hpp"
#include "rocking/stats/correlation.hpp"

namespace rocking::program {
namespace {

struct CheckNormalRequest {
  std::uint64_t n = 20'000;
  stats::NormalLaw law{.mean = 0.4, .sigma = 0.03};
  std::string seed = "0x2012";
  std::string sampler = "box-muller";
  Loudness loudness;
};

report::NormalCheck check_sample(const CheckNormalRequest& request, std::uint64_t seed,
                                 const std::vector<double>& sample) {
  const stats::NormalLaw& law = request.law;
  const auto moments = stats::sample_moments(sample, law);
  if (!moments) throw UsageError("--sigma: too small beside --mean to make two different numbers; give a larger one");
  return {.sampler = request.sampler,
          .seed = seed,
          .law = law,
          .moments = *moments,
          .pair_correlation = stats::pair_correlation(sample, law),
          .lag_correlation = stats::lag_correlation(sample, law, 1),
          .jarque_bera = stats::jarque_bera(sample),
          .dagostino_pearson = stats::dagostino_pearson(sample),
          .anderson_darling = stats::anderson_darling(sample, law),
          .kolmogorov_smirnov = stats::kolmogorov_smirnov(sample, law),
          .tails = stats::normal_tails(sample, law),
          .histogram = stats::normal_histogram(sample, law, 40, 4.0)};
}

// Whether the sample is so far from the law that no chance explains it: an ideal sampler is accused falsely less than
// four times in a million seeds.
bool is_refuted(const report::NormalCheck& check) {
  constexpr double significance = 1e-6;
  for (const stats::TailCount& tail : check.tails) {
    if (tail.p_value < significance) return true;
  }
  return check.kolmogorov_smirnov.p_value < significance;
}

ExitCode check_normal(const CheckNormalRequest& request) {
  const auto seed = report::seed_from_text(request.seed);
  if (!seed)
    throw UsageError("--seed " + request.seed +
                     ": must be a whole number of at most 64 bits; give a value such as 0x2012 or 8210");
  if (!(request.law.sigma > 0.0)) throw UsageError("--sigma: must be positive; give a value such as 0.03");
  const auto kind = random::sampler_from_string(request.sampler);
  const auto sample = random::sample_normal(kind.value(), *seed, request.n, request.law.mean, request.law.sigma);
  const report::NormalCheck check = check_sample(request, *seed, sample);
  print_result(request.loudness.json ? check_normal_text(check) : check_normal_summary(check));
  if (!is_refuted(check)) return ExitCode::done;
  print_notice("these numbers do not follow the law: a p-value is below 1e-6");
  return ExitCode::check_failed;
}

}  // namespace

void add_check_normal(CLI::App& app, Action& action) {
  const auto request = std::make_shared<CheckNormalRequest>();
  CLI::App* command = app.add_subcommand("check-normal", "Check the random numbers: moments, tests of fit, histogram");
  command->footer(
      "Example: rocking check-normal --n 20000 --mean 0.4 --sigma 0.03\n"
      "draws 20000 friction coefficients as a simulation does and compares them with the normal law.");
  command->add_option("--n", request->n, "How many numbers")
      ->check(CLI::Range(std::uint64_t{20}, std::uint64_t{100'000'000}))
      ->capture_default_str()
      ->type_name("N");
  command->add_option("--mean", request->law.mean, "Mean of the law")
      ->check(CLI::Range(-1e6, 1e6))
      ->capture_default_str()
      ->type_name("M");
  command->add_option("--sigma", request->law.sigma, "Standard deviation of the law")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str()
      ->type_name("S");
  command->add_option("--seed", request->seed, "Seed, as 0x2012 or 8210")->capture_default_str()->type_name("S");
  command
      ->add_option("--sampler", request->sampler, "How uniform numbers become normal ones; simulations use box-muller")
      ->check(CLI::IsMember({"box-muller", "ziggurat", "inverse-cdf"}))
      ->capture_default_str()
      ->type_name("NAME");
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return check_normal(*request); }; });
}

}  // namespace rocking::program
