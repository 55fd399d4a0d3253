#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rocking/dynamics/observer.hpp"

namespace rocking::support {

/// An event of a block, with the state after it.
struct LoggedEvent {
  dynamics::EventKind kind;
  double tau;
  dynamics::State state;
};

/// Keeps all events and strobe points of a realisation.
class EventLog final : public dynamics::Observer {
 public:
  void event(dynamics::EventKind kind, double tau, const dynamics::State& state) override {
    events.push_back({kind, tau, state});
  }
  void strobe(const dynamics::State& state) override { strobes.push_back(state); }

  /// The kinds of the events in order, by their names: `lift impact_stick`.
  [[nodiscard]] std::string story() const {
    std::string text;
    for (const LoggedEvent& happened : events) {
      if (!text.empty()) text += ' ';
      text += to_string(happened.kind);
    }
    return text;
  }

  [[nodiscard]] std::size_t count(dynamics::EventKind kind) const {
    std::size_t number = 0;
    for (const LoggedEvent& happened : events) number += happened.kind == kind ? 1 : 0;
    return number;
  }

  std::vector<LoggedEvent> events;
  std::vector<dynamics::State> strobes;
};

}  // namespace rocking::support
