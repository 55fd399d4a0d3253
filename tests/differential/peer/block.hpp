#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "differential/peer/flow.hpp"
#include "differential/peer/scene.hpp"

namespace rocking::peer {

/// Theta, Theta', X, V.
struct Posture {
  double tilt;
  double tilt_rate;
  double slip;
  double slip_rate;
};

struct Event {
  double tau;
  std::string_view kind;  ///< name as in lib/docs/model.md, section 3
  Posture after;
};

struct Sample {
  std::string_view contact;  ///< rest, slide, rock, rock_slide
  Posture posture;
};

struct Story {
  std::vector<Event> events;
  std::vector<Sample> samples;  ///< at tau = 2 pi k/Omega_h, k = 1, 2, ...
  std::string_view ending;      ///< reached_horizon, overturned, painleve
};

/// Resolution of the peer.
struct Care {
  double steps_per_period = 64.0;  ///< at least
  double shortest_hop = 1e-11;     ///< a chatter ends with the impact after which every hop would last less [tau]
};

/// Simulates `scene` over `periods` excitation periods, by CVODE.
[[nodiscard]] Story story_of(const Scene& scene, std::int64_t periods, const Care& care = {});

}  // namespace rocking::peer
