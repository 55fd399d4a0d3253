#pragma once

#include "rocking/ensemble/summary_bytes.hpp"
#include "rocking/store/store_identity.hpp"

namespace rocking::program::mpi {

/// The data that a process needs to run pairs of an experiment.
struct Assignment {
  unsigned threads = 1;
  Identity identity;
};

[[nodiscard]] Bytes to_bytes(const Assignment& assignment);
[[nodiscard]] Assignment assignment_from(std::span<const std::byte> bytes);

/// A text as the bytes of a message, and back.
[[nodiscard]] Bytes text_bytes(std::string_view text);
[[nodiscard]] std::string text_from(std::span<const std::byte> bytes);

}  // namespace rocking::program::mpi
