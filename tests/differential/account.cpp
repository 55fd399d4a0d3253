#include "differential/account.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace rocking::differential {
namespace {

constexpr double same_instant = 1e-10;  ///< events closer than this are listed as simultaneous

/// Inserts samples in their places: after the events of their instant, to rounding.
void insert_samples(Account& account, const Account& samples) {
  for (const Entry& sample : samples) {
    const auto later = std::find_if(account.begin(), account.end(),
                                    [&](const Entry& entry) { return entry.tau > sample.tau + same_instant; });
    account.insert(later, sample);
  }
}

void drop_chatter_tails(Account& account) {
  Account kept;
  for (const Entry& entry : account) {
    if (ends_chatter(entry)) {
      const auto belongs = [](const Entry& before) {
        const bool is_hop = before.what.starts_with("impact_") || before.what.starts_with("slip_");
        return is_hop && std::abs(before.state[1]) < chatter_rate;
      };
      while (!kept.empty() && belongs(kept.back())) kept.pop_back();
    }
    kept.push_back(entry);
  }
  account = kept;
}

Account finished(Account events, const Account& samples, std::string_view ending) {
  insert_samples(events, samples);
  drop_chatter_tails(events);
  const double end = events.empty() ? 0.0 : events.back().tau;
  events.push_back({end, ending, {}});
  return events;
}

}  // namespace

bool ends_chatter(const Entry& entry) { return entry.what == "to_rest" || entry.what == "to_slide"; }

Account account_of(const Trajectory& trajectory, double period) {
  Account events;
  Account samples;
  for (const auto& e : trajectory.events) {
    events.push_back({e.tau, to_string(e.kind), {e.tilt, e.tilt_rate, e.slip, e.slip_rate}});
  }
  for (const auto& s : trajectory.strobe) {
    samples.push_back(
        {static_cast<double>(s.period) * period, to_string(s.contact), {s.tilt, s.tilt_rate, s.slip, s.slip_rate}});
  }
  return finished(std::move(events), samples, to_string(trajectory.termination));
}

Account account_of(const peer::Story& story, double period) {
  const auto numbers = [](const peer::Posture& p) {
    return std::array<double, 4>{p.tilt, p.tilt_rate, p.slip, p.slip_rate};
  };
  Account events;
  Account samples;
  for (const peer::Event& e : story.events) events.push_back({e.tau, e.kind, numbers(e.after)});
  double instant = 0.0;
  for (const peer::Sample& s : story.samples) samples.push_back({instant += period, s.contact, numbers(s.posture)});
  return finished(std::move(events), samples, story.ending);
}

double distance(const Entry& a, const Entry& b) {
  double largest = std::abs(a.tau - b.tau);
  for (std::size_t i = 0; i < a.state.size(); ++i) largest = std::max(largest, std::abs(a.state[i] - b.state[i]));
  return largest;
}

}  // namespace rocking::differential
