#include "rocking/random/draws.hpp"

#include <map>
#include <set>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace rocking::random;

constexpr std::uint64_t largest = ~std::uint64_t{0};

static_assert(std::is_trivially_copyable_v<Draws> && sizeof(Draws) == 16);

// Published results refer to these numbers through their seeds. They must never change.
TEST(Source, KeepsItsNumber) {
  const std::map<int, std::string_view> numbers{{1, "static_friction"},
                                                {2, "kinetic_friction"},
                                                {3, "restitution"},
                                                {4, "amplitude"},
                                                {5, "phase"},
                                                {6, "tilt"},
                                                {7, "tilt_rate"},
                                                {8, "slip_rate"},
                                                {9, "check_normal"},
                                                {10, "block_width"},
                                                {11, "block_height"},
                                                {12, "fragility_bootstrap"},
                                                {13, "rare_choice"},
                                                {14, "mean_static_friction"},
                                                {15, "mean_kinetic_friction"},
                                                {16, "mean_restitution"},
                                                {17, "excitation_size"},
                                                {18, "excitation_frequency"},
                                                {19, "inference_shares"},
                                                {20, "inference_counts"},
                                                {21, "centre_height"},
                                                {22, "centre_offset"},
                                                {23, "radius_of_gyration"},
                                                {24, "left_edge"},
                                                {25, "right_edge"},
                                                {26, "base_left"},
                                                {27, "base_right"},
                                                {28, "mean_right_restitution"},
                                                {29, "slip"},
                                                {30, "vertical_size"},
                                                {31, "vertical_frequency"},
                                                {32, "vertical_phase"},
                                                {33, "building_frequency"},
                                                {34, "building_damping"},
                                                {35, "building_height"},
                                                {36, ""}};
  for (const auto& [number, name] : numbers) EXPECT_EQ(to_string(static_cast<Source>(number)), name);
}

TEST(Draws, LayOutTheCounterAsDocumented) {
  const Draws draws(0x0123456789abcdef, 0x00fedcba98765432);
  const Words block = philox({0x55667788, 0x11223344, 0x98765432, 0x03fedcba}, 0x0123456789abcdef);
  const std::uint64_t index = 2 * 0x1122334455667788;
  EXPECT_EQ(draws.bits(Source::restitution, index), half_of(block, 0));
  EXPECT_EQ(draws.bits(Source::restitution, index + 1), half_of(block, 1));
  EXPECT_EQ(draws.uniform(Source::restitution, index), static_cast<double>(half_of(block, 0) >> 11U) * 0x1p-53);
  EXPECT_EQ(draws.standard_normal(Source::restitution, index), box_muller(block).cosine);
  EXPECT_EQ(draws.standard_normal(Source::restitution, index + 1), box_muller(block).sine);
}

// Bits of `rocking.draws/1`. Each is within 2 units in the last place of the value from 60-digit arithmetic for its
// words (mpmath); the last bits are those of the project's own logarithm, sine and cosine.
TEST(Draws, HaveTheBitsOfVersionOne) {
  EXPECT_EQ(Draws(0x2012, 0).standard_normal(Source::kinetic_friction, 0), 0x1.3a476944c8834p-1);
  EXPECT_EQ(Draws(0x2012, 0).standard_normal(Source::kinetic_friction, 1), 0x1.5f7bc52354d9ep+0);
  EXPECT_EQ(Draws(0x2012, 0).standard_normal(Source::static_friction, 0), -0x1.6907f5577454cp-1);
  EXPECT_EQ(Draws(0x2012, 1).standard_normal(Source::kinetic_friction, 0), -0x1.94bfd46a2bcb7p-1);
  EXPECT_EQ(Draws(0x2012, 7).standard_normal(Source::static_friction, paired_index(3, 5)), 0x1.616760b64df6ep+0);
  EXPECT_EQ(Draws(largest, realisation_limit - 1).standard_normal(Source::check_normal, largest), -0x1.b775ca1b404fp+0);
  EXPECT_EQ(Draws(0, 0).standard_normal(Source::restitution, 12345678901), -0x1.4e76ee4fa8fcdp-1);
}

TEST(Draws, DependOnNoOtherDraw) {
  const Draws draws(99, 3);
  std::vector<double> forward;
  for (std::uint64_t j = 0; j < 100; ++j) forward.push_back(draws.standard_normal(Source::kinetic_friction, j));
  for (std::uint64_t j = 100; j-- > 0;) {
    static_cast<void>(draws.uniform(Source::phase, j));
    static_cast<void>(draws.standard_normal(Source::static_friction, j * j));
    EXPECT_EQ(Draws(99, 3).standard_normal(Source::kinetic_friction, j), forward[j]) << j;
  }
}

TEST(Draws, DifferInEveryPartOfTheirName) {
  std::set<std::uint64_t> seen;
  std::size_t asked = 0;
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 32U, largest}) {
    for (const std::uint64_t realisation :
         {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 32U, realisation_limit - 1}) {
      for (int source = 1; source <= 9; ++source) {
        for (const std::uint64_t index : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2}, paired_index(1, 0),
                                          paired_index(2, 0), paired_index(0, 1U << 31U), largest}) {
          seen.insert(Draws(seed, realisation).bits(static_cast<Source>(source), index));
          ++asked;
        }
      }
    }
  }
  EXPECT_EQ(seen.size(), asked);  // for a correct generator two of these 1008 are equal with probability 3e-14
}

TEST(Draws, GiveAPairTheTwoDrawsOfItsBlock) {
  const Draws draws(5, 6);
  for (const std::uint64_t block : {std::uint64_t{0}, std::uint64_t{41}, paired_index(7, 8) / 2, largest / 2}) {
    const NormalPair pair = draws.standard_normal_pair(Source::amplitude, block);
    EXPECT_EQ(pair.cosine, draws.standard_normal(Source::amplitude, 2 * block));
    EXPECT_EQ(pair.sine, draws.standard_normal(Source::amplitude, 2 * block + 1));
    EXPECT_EQ(pair[2 * block + 1], pair.sine);
  }
}

TEST(Draws, GiveAnArrayUpToTheLastIndex) {
  const Draws draws(5, 6);
  std::vector<double> numbers(5);
  draws.standard_normals(Source::amplitude, largest - 4, numbers);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(numbers[i], draws.standard_normal(Source::amplitude, largest - 4 + i)) << i;
  }
}

TEST(PairedIndex, IsAnotherForEveryPair) {
  constexpr std::uint64_t last = 0xffffffff;
  std::set<std::uint64_t> seen;
  for (const std::uint64_t major : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2}, last}) {
    for (const std::uint64_t minor : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2}, last}) {
      seen.insert(paired_index(major, minor));
    }
  }
  EXPECT_EQ(seen.size(), 16U);
  EXPECT_EQ(paired_index(0, 17), 17U);
}

#if defined(ROCKING_CONTRACTS)
TEST(Draws, RefuseToRepeatThemselvesBeyondTheirLimits) {
  using rocking::base::ContractViolation;
  EXPECT_THROW(Draws(0, realisation_limit), ContractViolation);
  EXPECT_THROW(static_cast<void>(paired_index(std::uint64_t{1} << 32U, 0)), ContractViolation);
  EXPECT_THROW(static_cast<void>(paired_index(0, std::uint64_t{1} << 32U)), ContractViolation);
  std::vector<double> numbers(6);
  EXPECT_THROW(Draws(0, 0).standard_normals(Source::amplitude, largest - 4, numbers), ContractViolation);
}
#endif

}  // namespace
