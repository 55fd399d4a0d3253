#pragma once

#include <optional>
#include <span>

#include "program.hpp"
#include "rocking/ensemble/summary_bytes.hpp"
#include "rocking/store/store_identity.hpp"

/// Communication between the processes that `mpirun` started. Two-sided messages only, from one thread per process.
namespace rocking::program::mpi {

/// Type of a message.
enum class Tag : int {
  assignment,  ///< coordinator to all: the experiment to run
  block,       ///< coordinator to one: pairs to run
  stop,        ///< coordinator to one that runs a block: abandon it
  rest,        ///< coordinator to all: the assignment has ended
  quit,        ///< coordinator to all: the program ends
  outcomes,    ///< to the coordinator: results of a block; ready for more
  failure,     ///< to the coordinator: this process cannot continue; the text gives the reason
};

struct Message {
  int rank = 0;  ///< of the sender
  Tag tag{};
  Bytes bytes;
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
  /// Waits for the next message; sleeps between two polls, so that other processes can use the core.
  [[nodiscard]] Message wait() const;

 private:
  int rank_ = 0;
  int size_ = 1;
};

/// Runs pairs as the first process. Only this process has the store. It sends blocks of pairs, each of about a quarter
/// of a second, to idle helpers, receives the results, and runs pairs itself at the same time.
[[nodiscard]] ProcessPool pool_of(const Session& session);

/// The loop of every process but the first: runs the blocks that it receives until it is told to quit.
void help(const Session& session);

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
