#include "session.hpp"

#include <chrono>
#include <string>
#include <thread>

#include <mpi.h>

namespace rocking::program::mpi {

// Errors of MPI itself end the program (MPI_ERRORS_ARE_FATAL, its default), and mpirun then ends the others.
Session::Session(int& argc, char**& argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Session::~Session() { MPI_Finalize(); }

std::string Session::host() const {
  char name[MPI_MAX_PROCESSOR_NAME];
  int length = 0;
  MPI_Get_processor_name(name, &length);
  return {name, static_cast<std::size_t>(length)};
}

void Session::send(int rank, Tag tag, std::span<const std::byte> bytes) const {
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, rank, static_cast<int>(tag), MPI_COMM_WORLD);
}

void Session::send_to_others(Tag tag, std::span<const std::byte> bytes) const {
  for (int rank = 0; rank < size_; ++rank) {
    if (rank != rank_) send(rank, tag, bytes);
  }
}

std::optional<Message> Session::receive() const {
  int is_there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status);
  if (is_there == 0) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Message message{.rank = status.MPI_SOURCE,
                  .tag = static_cast<Tag>(status.MPI_TAG),
                  .bytes = Bytes(static_cast<std::size_t>(size))};
  MPI_Recv(message.bytes.data(), size, MPI_BYTE, message.rank, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return message;
}

Message Session::wait() const {
  while (true) {
    if (auto message = receive()) return *std::move(message);
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
}

}  // namespace rocking::program::mpi
