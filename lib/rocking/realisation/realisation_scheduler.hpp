#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/lanes/kernels.hpp"
#include "rocking/realisation/realisation_result.hpp"

namespace rocking {

/// A realisation of a valid condition (check_condition). The condition must outlive the run.
struct RequestedRun {
  const Condition* condition;
  std::uint64_t realisation;
};

/// Runs several realisations at once on one thread. The result of each has the bits that realise() returns, whatever
/// the other realisations and the number of lanes.
class RealisationScheduler {
 public:
  /// When asked to stop, start() and work() throw base::Stopped, unless they return within a moment.
  RealisationScheduler(std::uint64_t seed, const lanes::Kernels& kernels, base::StopRequest stop = {});
  ~RealisationScheduler();

  /// Whether a lane is free for another realisation, and no result waits to be returned by work().
  [[nodiscard]] bool wants_more() const;
  [[nodiscard]] bool is_idle() const;

  void start(const RequestedRun& run, std::size_t id);

  struct Finished {
    std::size_t id;
    RealisationResult result;
  };
  /// Advances the realisations until at least one is finished, or for about a millisecond. Returns the finished ones.
  [[nodiscard]] std::vector<Finished> work();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rocking
