#include "helper.hpp"

#include <chrono>
#include <exception>
#include <future>

#include <fmt/format.h>

#include "exit_code.hpp"
#include "interrupt.hpp"
#include "job.hpp"
#include "rocking/experiment/pair_workers.hpp"
#include "run_folder.hpp"

namespace rocking::program::mpi {
namespace {

using experiment::Pair;
using experiment::PairOutcome;

constexpr int coordinator = 0;

/// Runs a block; returns what came of the pairs that were finished when it was asked to stop.
std::vector<PairOutcome> run_block(const experiment::Experiment& experiment, const std::vector<Pair>& block,
                                   unsigned threads) {
  experiment::RunOptions options;
  options.threads = threads;
  options.stop_requested = &stop_on_interrupt();
  std::vector<PairOutcome> outcomes;
  std::size_t given = 0;
  run_pairs(experiment, options,
            {.next = [&] { return given < block.size() ? std::optional(block[given++]) : std::nullopt; },
             .accept =
                 [&](const Pair& pair, const auto& summaries) {
                   outcomes.push_back({pair, summaries});
                 }});
  return outcomes;
}

/// The same, and listens to the coordinator meanwhile: only this thread may.
std::vector<PairOutcome> outcomes_of(const Session& session, const experiment::Experiment& experiment,
                                     const std::vector<Pair>& block, unsigned threads) {
  auto work = std::async(std::launch::async, [&] { return run_block(experiment, block, threads); });
  while (work.wait_for(std::chrono::microseconds(100)) != std::future_status::ready) {
    if (const auto order = session.receive(); order && order->tag == Tag::stop) stop_for_time();
  }
  return work.get();
}

void expect_same_code(const experiment::Identity& identity) {
  if (identity.code == code_identity()) return;
  throw InTheWay(fmt::format("this process runs `rocking` {}, the first process runs {}; use the same build for all",
                             code_identity(), identity.code));
}

// Until the job ends; returns with what order.
Tag work_on(const Session& session, const Job& job) {
  expect_same_code(job.identity);
  const experiment::Experiment experiment = experiment_of(job.identity);
  std::vector<PairOutcome> outcomes;
  while (true) {
    session.send(coordinator, Tag::outcomes, experiment::to_bytes(std::span<const PairOutcome>(outcomes)));
    const Message order = session.wait();
    if (order.tag != Tag::block) return order.tag;
    outcomes = outcomes_of(session, experiment, experiment::pairs_from(order.bytes), job.threads);
  }
}

}  // namespace

void help(const Session& session) {
  while (true) {
    const Message message = session.wait();
    if (message.tag == Tag::quit) return;
    if (message.tag != Tag::job) continue;
    try {
      if (work_on(session, job_from(message.bytes)) == Tag::quit) return;
    } catch (const std::exception& error) {
      session.send(coordinator, Tag::failure, text_bytes(fmt::format("on {}: {}", session.host(), error.what())));
    }
  }
}

}  // namespace rocking::program::mpi
