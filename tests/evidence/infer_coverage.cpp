// How often inferred intervals cover the truth, with a made-up simulator: the table of reports/evidence/infer.md.
//
//     infer_coverage [data sets]

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "rocking/studies/infer/infer.hpp"
#include "support/made_up_campaign.hpp"

namespace {

using namespace rocking;
using support::Campaign;
using support::Dependence;

void print(const char* name, const Campaign& campaign, std::size_t sets) {
  support::SplitMix random(11);
  const std::size_t unknowns = campaign.truth.size();
  std::vector<double> sums(unknowns);
  std::vector<double> squares(unknowns);
  std::size_t covered = 0;
  std::size_t small = 0;
  double points = 0.0;
  for (std::size_t set = 0; set < sets; ++set) {
    const Inference found = infer_unknowns(support::made_up_question(campaign, random), {});
    points += static_cast<double>(found.design.size());
    const InferenceAnswer& answer = found.answer.value();
    small += answer.fit.p_value <= 0.05;
    for (std::size_t k = 0; k < unknowns; ++k) {
      const UnknownAnswer& unknown = answer.unknowns[k];
      covered += unknown.interval.low <= campaign.truth[k] && campaign.truth[k] <= unknown.interval.high;
      sums[k] += unknown.estimate - campaign.truth[k];
      squares[k] += std::pow(unknown.estimate - campaign.truth[k], 2);
    }
  }
  const auto n = static_cast<double>(sets);
  std::printf("| %s | %zu |", name, campaign.tests);
  for (const double truth : campaign.truth) std::printf(" %.2f", truth);
  std::printf(" | %zu/%zu |", covered, sets * unknowns);
  for (std::size_t k = 0; k < unknowns; ++k) std::printf(" %+.3f", sums[k] / n);
  std::printf(" |");
  for (std::size_t k = 0; k < unknowns; ++k) std::printf(" %.3f", std::sqrt(squares[k] / n - std::pow(sums[k] / n, 2)));
  std::printf(" | %zu/%zu | %.0f |\n", small, sets, points / n);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t sets = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 200;
  std::printf("| unknowns | tests each | truth | covered | bias | deviation | p <= 0.05 | points |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::size_t tests : {5U, 10U, 40U}) {
    for (const double truth : {0.0, 0.35, 0.8}) {
      print("1", {.truth = {truth}, .dependence = Dependence::sharp, .tests = tests}, sets);
    }
  }
  for (const std::size_t tests : {5U, 10U, 40U}) {
    for (const auto& [first, second] : {std::array{0.0, 0.5}, std::array{0.35, 0.6}, std::array{0.8, 0.2}}) {
      print("2", {.truth = {first, second}, .dependence = Dependence::steady, .tests = tests}, sets / 4);
    }
  }
}
