#pragma once

#include "rocking/experiment/store_identity.hpp"
#include "rocking/experiment/summary_bytes.hpp"

namespace rocking::program::mpi {

/// What a process must know to run pairs of an experiment.
struct Job {
  unsigned threads = 1;
  experiment::Identity identity;
};

[[nodiscard]] experiment::Bytes to_bytes(const Job& job);
[[nodiscard]] Job job_from(std::span<const std::byte> bytes);

/// A text as the bytes of a message, and back.
[[nodiscard]] experiment::Bytes text_bytes(std::string_view text);
[[nodiscard]] std::string text_from(std::span<const std::byte> bytes);

}  // namespace rocking::program::mpi
