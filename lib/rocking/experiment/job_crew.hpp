#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "rocking/experiment/realisation_crew.hpp"

namespace rocking::experiment {

/// Jobs of several realisations each; those of all jobs are advanced side by side, on one thread.
///
/// A Job has tasks(), which last as long as it does, and accept(task, Record), which takes what came of one of them and says
/// whether that was the last.
template <class Job>
class JobCrew {
 public:
  /// As RealisationCrew.
  JobCrew(std::uint64_t seed, const lanes::Kernels& kernels, base::StopRequest stop) : crew_(seed, kernels, stop) {}

  /// Whether the tasks of another job would be done beside those that are here.
  [[nodiscard]] bool wants_more() const { return crew_.wants_more(); }
  [[nodiscard]] bool is_idle() const { return jobs_.empty(); }
  /// Jobs that are not done.
  [[nodiscard]] std::size_t size() const { return jobs_.size(); }

  void start(std::unique_ptr<Job> started) {
    const auto& job = jobs_.emplace_back(std::move(started));
    for (std::size_t task = 0; task < job->tasks().size(); ++task) {
      tickets_[next_ticket_] = {job.get(), task};
      crew_.start(job->tasks()[task], next_ticket_++);
    }
  }

  /// Goes on for a while; returns the jobs that are done.
  [[nodiscard]] std::vector<std::unique_ptr<Job>> work() {
    std::vector<std::unique_ptr<Job>> done;
    for (auto& [ticket, record] : crew_.work()) {
      const auto entry = tickets_.extract(ticket);
      const auto [job, task] = entry.mapped();
      if (!job->accept(task, std::move(record))) continue;
      const auto place = std::ranges::find(jobs_, job, &std::unique_ptr<Job>::get);
      done.push_back(std::move(*place));
      jobs_.erase(place);
    }
    return done;
  }

 private:
  struct TaskOfJob {
    Job* job;
    std::size_t task;
  };

  std::vector<std::unique_ptr<Job>> jobs_;
  std::map<std::size_t, TaskOfJob> tickets_;
  std::size_t next_ticket_ = 0;
  RealisationCrew crew_;
};

}  // namespace rocking::experiment
