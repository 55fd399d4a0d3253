#include "session.hpp"

#include <chrono>
#include <exception>
#include <future>

#include <fmt/format.h>

#include "exit_code.hpp"
#include "interrupt.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/ensemble/pair_workers.hpp"

namespace rocking::program::mpi {
namespace {

constexpr int coordinator = 0;

/// Runs a block; if it is asked to stop, returns the results of the pairs that were finished.
std::vector<PairOutcome> run_block(const Experiment& experiment, const std::vector<Pair>& block, unsigned threads) {
  RunOptions options;
  options.threads = threads;
  options.stop_requested = &stop_on_interrupt();
  std::vector<PairOutcome> outcomes;
  std::size_t given = 0;
  run_pairs(experiment, options,
            {.next = [&] { return given < block.size() ? std::optional(block[given++]) : std::nullopt; },
             .accept =
                 [&](const Pair& pair, const auto& summaries) {
                   outcomes.push_back({pair, summaries});
                 },
             .left = [&] { return block.size() - outcomes.size(); }});
  return outcomes;
}

/// The same; this thread, the only one that communicates, receives messages of the coordinator meanwhile.
std::vector<PairOutcome> outcomes_of(const Session& session, const Experiment& experiment,
                                     const std::vector<Pair>& block, unsigned threads) {
  auto work = std::async(std::launch::async, [&] { return run_block(experiment, block, threads); });
  while (work.wait_for(std::chrono::microseconds(100)) != std::future_status::ready) {
    if (const auto order = session.receive(); order && order->tag == Tag::stop) stop_for_time();
  }
  return work.get();
}

void expect_same_code(const Identity& identity) {
  if (identity.code == base::code_identity()) return;
  throw InTheWay(fmt::format("this process runs `rocking` {}, the first process runs {}; use the same build for all",
                             base::code_identity(), identity.code));
}

// Works until the assignment ends; returns the message that ended it.
Tag work_on(const Session& session, const Assignment& assignment) {
  expect_same_code(assignment.identity);
  const Experiment experiment = experiment_of(assignment.identity);
  std::vector<PairOutcome> outcomes;
  while (true) {
    session.send(coordinator, Tag::outcomes, to_bytes(std::span<const PairOutcome>(outcomes)));
    const Message order = session.wait();
    if (order.tag != Tag::block) return order.tag;
    outcomes = outcomes_of(session, experiment, pairs_from(order.bytes), assignment.threads);
  }
}

}  // namespace

void help(const Session& session) {
  while (true) {
    const Message message = session.wait();
    if (message.tag == Tag::quit) return;
    if (message.tag != Tag::assignment) continue;
    try {
      if (work_on(session, assignment_from(message.bytes)) == Tag::quit) return;
    } catch (const std::exception& error) {
      session.send(coordinator, Tag::failure, text_bytes(fmt::format("on {}: {}", session.host(), error.what())));
    }
  }
}

}  // namespace rocking::program::mpi
