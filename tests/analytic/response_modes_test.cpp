// Response modes of the noise-free reference cases, run far beyond their 20 periods, and of a few noisy responses,
// compared with a horizon 20 times longer. Many more of the latter: reports/evidence/classification-evidence.md.

#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/realisation/realisation_result.hpp"
#include "support/excitation.hpp"
#include "support/reference_case.hpp"

namespace rocking {
namespace {

/// Response mode of each case, from its note or, if the note does not say, from a run ten times as long (5000 + 600
/// periods). Case 10 is called chaotic in its note. Its largest exponent over 3000 periods is -8e-5 +- 8e-5 per period:
/// it moves on a torus. The exponent of case 14 is 0.0043 +-
/// 0.0004: chaotic, but too weakly for the default horizon.
const std::map<std::string, std::string> modes{
    {"01_noslip_11", "(1,1)"},
    {"02_noslip_13", "(1,3)"},
    {"03_noslip_13_e0912", "(1,3)"},
    {"04_noslip_15", "(1,5)"},
    {"05_stickslip_40", "(3,3)"},
    {"06_stickslip_35_11", "(1,1)"},
    {"07_slipimpact_e0912", "(1,3)"},
    {"08_aperiodic_centroidal", "chaotic"},
    {"09_chaotic_printed_90", "chaotic"},
    {"10_chaotic_printed_66", "quasi-periodic"},
    {"11_printed_abs26_80", "chaotic"},
    {"12_near_overturn", "(1,1)"},
    {"13_overturn", "overturned"},
    {"14_slender_HB10", "unresolved"},
    {"15_stocky_HB15_rock", "(1,1)"},
    {"16_stocky_HB15_slide", "(0,1)"},
    {"17_stocky_HB15_drop", "(0,1)"},
    {"18_chatter_rest_relift", "(1,1)"},
    {"19_free_rocking", "rest"},
    {"20_slipimpact_e03", "(1,1)"},
    {"21_jump_start_no_slip", "(1,1)"},
    {"22_kinetic_below_tip_static_above", "(0,1)"},
};

/// A chaotic motion differs for every tolerance and every rounding. About one in thirty (5, 11 and 7 of 200 tolerances
/// in cases 8, 9 and 11) is unresolved at the default horizon; none may get another class.
void expect_chaos_of_most_roundings(Condition condition) {
  constexpr int roundings = 20;
  const double tolerance = condition.tolerance;
  int chaotic = 0;
  for (int i = 0; i < roundings; ++i) {
    condition.tolerance = tolerance * (1.0 + 0.01 * i);
    const std::string mode = to_string(realise(condition, 0, 0).classification.mode);
    EXPECT_THAT(mode, testing::AnyOf("chaotic", "unresolved")) << "at tolerance " << condition.tolerance;
    chaotic += mode == "chaotic" ? 1 : 0;
  }
  EXPECT_GE(chaotic, 17);
}

class ReferenceMode : public testing::TestWithParam<std::string> {};

TEST_P(ReferenceMode, IsClassifiedRight) {
  const auto condition = tests::condition_of_reference(tests::load_reference(GetParam()));
  if (modes.at(GetParam()) == "chaotic") return expect_chaos_of_most_roundings(condition);
  const RealisationResult result = realise(condition, 0, 0);
  EXPECT_EQ(to_string(result.classification.mode), modes.at(GetParam()))
      << to_string(result.classification.reason.value());
}

Condition noisy_friction(const Friction& friction, double amplitude) {
  Condition condition = support::shaken(amplitude, friction);
  condition.scene.fluctuation.static_friction = condition.scene.fluctuation.kinetic_friction = 0.03;
  condition.tolerance = 1e-10;
  return condition;
}

constexpr std::uint64_t headline_seed = 0x2012;
constexpr Friction low_friction{.static_coefficient = 0.35, .kinetic_coefficient = 0.30};
constexpr Friction high_friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};

/// Class and `held` of a realisation, and its class with 20 times as many sampled periods.
struct Names {
  section::Classification classification;
  section::ResponseMode in_the_long_run;
};

Names names_of(Condition condition, std::uint64_t realisation) {
  Names names;
  names.classification = realise(condition, headline_seed, realisation).classification;
  condition.horizon.sampled_periods *= 20;
  names.in_the_long_run = realise(condition, headline_seed, realisation).classification.mode;
  return names;
}

// Conditions of the headline experiment with one long-term response. Of 1120 such realisations none was classified
// wrongly; 5 were unresolved.
TEST(NoisyMode, IsThatOfAHorizonTwentyTimesLonger) {
  struct Case {
    Friction friction;
    double amplitude;
    std::uint64_t realisations;
  };
  for (const Case& c : {Case{low_friction, 2.0, 4}, Case{high_friction, 3.0, 4}, Case{high_friction, 5.0, 4},
                        Case{low_friction, 9.0, 1}}) {
    for (std::uint64_t realisation = 0; realisation < c.realisations; ++realisation) {
      const Names names = names_of(noisy_friction(c.friction, c.amplitude), realisation);
      EXPECT_EQ(to_string(names.classification.mode), to_string(names.in_the_long_run))
          << c.amplitude << ' ' << realisation;
      EXPECT_NE(names.classification.mode.kind, section::ResponseKind::unresolved) << c.amplitude << ' ' << realisation;
      EXPECT_EQ(names.classification.held, 1.0) << c.amplitude << ' ' << realisation;
    }
  }
}

TEST(NoisyMode, IsThatOfAHorizonTwentyTimesLongerAlsoWhereItSettledLate) {
  struct Case {
    double amplitude;
    std::uint64_t realisation;
    std::string mode;
  };
  for (const Case& c : {Case{5.5, 1, "(1,3)"}, Case{6.0, 21, "(1,3)"}, Case{6.0, 116, "(1,1)"}, Case{7.0, 40, "(1,1)"},
                        Case{7.0, 26, "(1,1)"}}) {
    const Names names = names_of(noisy_friction(high_friction, c.amplitude), c.realisation);
    EXPECT_EQ(to_string(names.classification.mode), c.mode) << c.amplitude << ' ' << c.realisation;
    EXPECT_LT(names.classification.held, 1.0) << c.amplitude << ' ' << c.realisation;
    EXPECT_EQ(to_string(names.in_the_long_run), c.mode) << c.amplitude << ' ' << c.realisation;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ReferenceMode, testing::ValuesIn(tests::reference_names()),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace rocking
