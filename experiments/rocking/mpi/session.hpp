#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "rocking/experiment/summary_bytes.hpp"

/// The processes that `mpirun` started, told apart by their ranks. Two-sided messages only, from one thread a process.
namespace rocking::program::mpi {

/// What a message is about.
enum class Tag : int {
  job,       ///< coordinator to all: what is to be worked on
  block,     ///< coordinator to one: pairs to run
  stop,      ///< coordinator to one that runs a block: give it up
  rest,      ///< coordinator to all: the job is at its end
  quit,      ///< coordinator to all: the program is
  outcomes,  ///< to the coordinator: what came of a block, and: ready for more
  failure,   ///< to the coordinator: no more from here; the text says why
};

struct Message {
  int rank = 0;  ///< of the sender
  Tag tag{};
  experiment::Bytes bytes;
};

/// From MPI_Init to MPI_Finalize.
class Session {
 public:
  Session(int& argc, char**& argv);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }
  /// Name of the machine that this process runs on.
  [[nodiscard]] std::string host() const;

  void send(int rank, Tag tag, std::span<const std::byte> bytes) const;
  void send_to_others(Tag tag, std::span<const std::byte> bytes) const;
  /// The next message, if one has come.
  [[nodiscard]] std::optional<Message> receive() const;
  /// The next message. Sleeps between two looks: a core that waits is a core that another process may use.
  [[nodiscard]] Message wait() const;

 private:
  int rank_ = 0;
  int size_ = 1;
};

}  // namespace rocking::program::mpi
