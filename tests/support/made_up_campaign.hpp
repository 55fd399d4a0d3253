#pragma once

// A made-up simulator: three groups of response modes whose shares are smooth functions of unknowns between 0 and 1.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rocking/studies/infer/infer.hpp"
#include "support/split_mix.hpp"

namespace rocking::support {

/// How the shares depend on the unknowns.
enum class Dependence : std::uint8_t {
  steady,  ///< in the same direction under all conditions
  sharp,   ///< they change over a part of the range that differs between the conditions
  none
};

/// The first unknown changes the second group, a second one changes the third.
inline std::vector<double> made_up_shares(const std::vector<double>& at, std::size_t condition, Dependence dependence) {
  const auto c = static_cast<double>(condition);
  double a = -2.0 + 1.5 * c;
  double b = -1.0 + (at.size() > 1 ? 2.5 * at[1] * (c - 0.5) : c - 0.5);
  if (dependence == Dependence::steady) {
    a += 3.0 * at[0];
    b += at[0];
  }
  if (dependence == Dependence::sharp) {
    a = 6.0 * (at[0] - 0.3 - 0.2 * c);
    b = -1.0 + 0.5 * c;
  }
  const double sum = 1.0 + std::exp(a) + std::exp(b);
  return {1.0 / sum, std::exp(a) / sum, std::exp(b) / sum};
}

/// Groups of the uniform numbers.
inline std::vector<std::uint64_t> groups_of(const std::vector<double>& shares, const std::vector<double>& numbers) {
  std::vector<std::uint64_t> counts(shares.size());
  for (const double u : numbers) {
    std::size_t group = 0;
    for (double sum = shares[0]; group + 1 < shares.size() && u >= sum; sum += shares[++group]) {
    }
    ++counts[group];
  }
  return counts;
}

inline std::vector<double> uniform_numbers(SplitMix& random, std::size_t size) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < size; ++i) numbers.push_back(random.uniform());
  return numbers;
}

struct Campaign {
  std::vector<double> truth;
  Dependence dependence = Dependence::steady;
  std::size_t tests = 10;  ///< under each of three conditions
  std::size_t realisations = 400;
  bool has_common_numbers = true;  ///< the conditions have the same random numbers
};

/// Tests counted at the truth, and the simulator with numbers of its own.
inline InferenceSetting made_up_question(const Campaign& campaign, SplitMix& random) {
  constexpr std::size_t conditions = 3;
  InferenceSetting question;
  question.seed = random.bits();
  for (std::size_t k = 0; k < campaign.truth.size(); ++k) question.unknowns.push_back({.pointer = "/x"});
  question.tests.groups.resize(3);
  for (std::size_t c = 0; c < conditions; ++c) {
    const std::vector<double> shares = made_up_shares(campaign.truth, c, campaign.dependence);
    question.tests.conditions.push_back(
        {.parameters = {}, .counts = groups_of(shares, uniform_numbers(random, campaign.tests))});
  }
  std::vector<std::vector<double>> numbers(conditions, uniform_numbers(random, campaign.realisations));
  if (!campaign.has_common_numbers) {
    for (auto& of_condition : numbers) of_condition = uniform_numbers(random, campaign.realisations);
  }
  question.simulate = [numbers, dependence = campaign.dependence](const std::vector<std::vector<double>>& points) {
    CountsAtPoints all;
    for (const std::vector<double>& at : points) {
      all.emplace_back();
      for (std::size_t c = 0; c < conditions; ++c) {
        all.back().push_back(groups_of(made_up_shares(at, c, dependence), numbers[c]));
      }
    }
    return all;
  };
  return question;
}

}  // namespace rocking::support
