// Cost of a store of many realisations: time, disk space, memory. The numbers of reports/evidence/scale.md.
// Usage: store_scale ROWS FOLDER

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "rocking/ensemble/run.hpp"
#include "rocking/ensemble/summary_bytes.hpp"
#include "rocking/store/difference.hpp"

namespace {

using namespace rocking;

const Identity identity{.experiment = "{}", .code = "", .files = "", .shard = {}};

/// A row of a typical realisation of the headline experiment: 620 periods of sliding and rocking.
Summary typical(std::uint64_t number) {
  Summary summary;
  summary.mode = rocking::section::periodic(1, 1);
  summary.margin = std::sqrt(static_cast<double>(number + 2));
  summary.held = 1.0;
  summary.digest = rocking::base::sha256(std::to_string(number));
  if (number % 2 == 0) summary.diverged_from_next = static_cast<std::int64_t>(number % 600);
  if (number % 10 == 0) summary.rerun_mode = summary.mode;
  summary.operations.steps = 30000 + number % 5000;
  summary.operations.slip_steps = 20000 + number % 4000;
  summary.operations.root_isolations = 3000 + number % 500;
  summary.operations.kinetic_friction_draws = 25000 + number % 4000;
  summary.operations.static_friction_draws = 600 + number % 300;
  for (std::uint64_t& events : summary.operations.events) events = 100 + number % 700;
  return summary;
}

Experiment experiment_of(std::uint64_t rows) {
  Experiment question;
  question.conditions.resize(1);
  question.conditions[0].realisations = rows;
  question.conditions[0].scene.initial.tilt = Uniform{.low = 0.0, .high = 0.1};
  return question;
}

/// Largest memory use of this process so far.
std::string peak_memory() {
  std::ifstream facts("/proc/self/status");
  for (std::string line; std::getline(facts, line);) {
    if (line.starts_with("VmHWM:")) return line.substr(6);
  }
  return " unknown";
}

template <class Work>
void measure(const std::string& name, std::uint64_t rows, Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::cout << name << ": " << seconds << " s, " << 1e6 * seconds / static_cast<double>(rows)
            << " us a row; peak memory" << peak_memory() << '\n';
}

void add_rows(Store& store, std::uint64_t from, std::uint64_t rows, std::uint64_t step) {
  std::uint64_t added = 0;
  for (std::uint64_t number = from; number < rows; number += step) {
    store.add({0, number}, typical(number));
    if (++added % 4000 == 0) store.commit();
  }
  store.close_up();
}

void measure_messages() {
  std::vector<PairOutcome> outcomes;
  for (std::uint64_t number = 0; number < 100; number += 2) {
    outcomes.push_back({{.condition = 0, .first = number}, {typical(number), typical(number + 1)}});
  }
  Bytes bytes;
  std::size_t read = 0;
  constexpr std::uint64_t times = 1000;
  measure("packed into a message", 100 * times, [&] {
    for (std::uint64_t time = 0; time < times; ++time) bytes = to_bytes(std::span<const PairOutcome>(outcomes));
  });
  measure("read from a message", 100 * times, [&] {
    for (std::uint64_t time = 0; time < times; ++time) read += outcomes_from(bytes).size();
  });
  std::cout << "bytes a row in a message: " << bytes.size() / 100 << " (" << read << " pairs read)\n";
}

void measure_store(std::uint64_t rows, const std::filesystem::path& folder) {
  const auto path = folder / "scale.sqlite";
  measure("written", rows, [&] {
    Store store = Store::create(path, identity);
    add_rows(store, 0, rows, 1);
  });
  const auto size = std::filesystem::file_size(path);
  std::cout << "on the disk: " << size << " bytes, " << static_cast<double>(size) / static_cast<double>(rows)
            << " a row\n";
  const Store store = Store::open(path, sqlite::Access::read);
  const Experiment experiment = experiment_of(rows);
  measure("counted for resume and status", rows,
          [&] { std::cout << completeness(experiment, store).done << " done\n"; });
  measure("checked for damage", rows, [&] { std::cout << (store.damage() ? "damaged\n" : "sound\n"); });
  measure("reduced to a result", rows,
          [&] { std::cout << (result_of(experiment, store) ? "complete\n" : "incomplete\n"); });
}

void measure_merge(std::uint64_t rows, const std::filesystem::path& folder) {
  for (std::uint64_t part = 0; part < 2; ++part) {
    Store shard = Store::create(folder / ("part" + std::to_string(part)), identity);
    add_rows(shard, part, rows, 2);
  }
  Store whole = Store::create(folder / "whole", identity);
  measure("merged from two interleaved shards", rows, [&] {
    for (const char* part : {"part0", "part1"}) {
      if (!merge(whole, Store::open(folder / part, sqlite::Access::read)).empty()) std::cout << "conflicts\n";
    }
    whole.close_up();
  });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: store_scale ROWS FOLDER\n";
    return 64;
  }
  const std::uint64_t rows = std::stoull(argv[1]);
  const std::filesystem::path folder = argv[2];
  std::filesystem::create_directories(folder);
  measure_messages();
  measure_store(rows, folder);
  measure_merge(rows, folder);
}
