#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "rocking/base/number_text.hpp"
#include "rocking/scene/check_ground_motion.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/number_rule.hpp"

namespace rocking {

/// Ground motions that were found to be sound, with the gravity that they are over.
using SoundGroundMotions = std::set<std::pair<const GroundMotion*, double>>;

/// Adds a problem for each number of a condition that its rule (scene/rules.hpp) does not allow, in the order of the
/// keys of an experiment file. What numbers demand of each other: check_relations. Looks through a ground motion only
/// where `sound` does not hold it.
void check_numbers(const Condition& condition, SoundGroundMotions& sound, Problems& problems);

/// Why an interval is none.
[[nodiscard]] std::optional<Refusal> refuse_ends(const Uniform& law);

/// JSON text of a quantity.
[[nodiscard]] std::string text_of(const Quantity& quantity);

/// Checks numbers one by one. An excitation's check() calls it with each of its own.
class NumberChecker {
 public:
  NumberChecker(double gravity, SoundGroundMotions& sound, Problems& problems)
      : gravity_(gravity), sound_(&sound), problems_(&problems) {}

  void operator()(std::string_view place, double value, const NumberRule& rule) const;
  /// Both ends of an interval, or the mean and the standard deviation.
  void operator()(std::string_view place, const Quantity& quantity, const NumberRule& rule) const;
  void operator()(std::string_view place, const std::shared_ptr<const GroundMotion>& motion) const;

  template <class Integer>
  void operator()(std::string_view place, Integer value, const IntegerRule& rule) const {
    if (!rule.allows(value))
      problems_->push_back({std::string(place), std::to_string(value), rule.demand(), rule.remedy()});
  }

 private:
  double gravity_;
  SoundGroundMotions* sound_;
  Problems* problems_;
};

}  // namespace rocking
