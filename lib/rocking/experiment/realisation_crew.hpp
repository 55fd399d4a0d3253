#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/experiment/record.hpp"
#include "rocking/lanes/kernels.hpp"

namespace rocking::experiment {

/// A realisation of a condition, which must last until its record is there.
struct Task {
  const Condition* condition;
  std::uint64_t realisation;
};

/// Runs realisations side by side, on one thread. What comes of one is what realise() returns for it, to the bit, whoever
/// is beside it and however many lanes there are.
class RealisationCrew {
 public:
  /// Once it is asked to stop, start() and work() throw base::Stopped where they would take longer than a moment.
  RealisationCrew(std::uint64_t seed, const lanes::Kernels& kernels, base::StopRequest stop = {});
  ~RealisationCrew();

  /// Whether another realisation would be done beside those that are here.
  [[nodiscard]] bool wants_more() const;
  [[nodiscard]] bool is_idle() const;

  void start(const Task& task, std::size_t ticket);

  struct Finished {
    std::size_t ticket;
    Record record;
  };
  /// Goes on until something is finished, or for about a millisecond; returns what is finished.
  [[nodiscard]] std::vector<Finished> work();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rocking::experiment
