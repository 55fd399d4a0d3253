#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "differential/peer/block.hpp"
#include "rocking/realisation/trajectory.hpp"

namespace rocking::differential {

/// An event or a strobe sample, in the words that both sides use.
struct Entry {
  double tau;
  std::string_view what;        ///< kind of the event; for a sample, the contact state
  std::array<double, 4> state;  ///< Theta, Theta', X, V after it
};

/// All events in order, and the termination last. The events of a chatter with rates below `chatter_rate` that lead to
/// full contact are omitted: their number depends on the rule that ends the chatter.
using Account = std::vector<Entry>;
inline constexpr double chatter_rate = 1e-4;

[[nodiscard]] Account account_of(const Trajectory& trajectory, double period);
[[nodiscard]] Account account_of(const peer::Story& story, double period);

/// Whether the entry is the end of a chatter, in full contact.
[[nodiscard]] bool ends_chatter(const Entry& entry);

/// Largest difference of times and states.
[[nodiscard]] double distance(const Entry& a, const Entry& b);

}  // namespace rocking::differential
