#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "differential/peer/block.hpp"
#include "rocking/experiment/trajectory.hpp"

namespace rocking::differential {

/// An event, or a strobe sample: what both sides tell of, in the same words.
struct Entry {
  double tau;
  std::string_view what;        ///< kind of event; of a sample, the state of contact
  std::array<double, 4> state;  ///< Theta, Theta', X, V after it
};

/// All that happened, in order; last, how it ended. The tail of a chatter is left out, the events at rates below
/// `chatter_rate` that lead to full contact: how many impacts it is told in depends on the rule that ends it.
using Account = std::vector<Entry>;
inline constexpr double chatter_rate = 1e-4;

[[nodiscard]] Account account_of(const experiment::Trajectory& trajectory, double period);
[[nodiscard]] Account account_of(const peer::Story& story, double period);

/// Whether the entry is a chatter's end, in full contact.
[[nodiscard]] bool ends_chatter(const Entry& entry);

/// Largest difference of times and states.
[[nodiscard]] double distance(const Entry& a, const Entry& b);

}  // namespace rocking::differential
