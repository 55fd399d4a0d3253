#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <mpi.h>

#include "session.hpp"

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

// Texts that end with a zero byte, one after the other: none of them holds one.
Bytes to_bytes(const Assignment& assignment) {
  std::string all;
  for (const std::string& text : {std::to_string(assignment.threads), assignment.identity.experiment,
                                  assignment.identity.code, assignment.identity.files}) {
    all += text;
    all += '\0';
  }
  return text_bytes(all);
}

Assignment assignment_from(std::span<const std::byte> bytes) {
  const std::string all = text_from(bytes);
  std::vector<std::string> texts;
  for (std::size_t from = 0; from < all.size(); from += texts.back().size() + 1) {
    texts.emplace_back(all.c_str() + from);
  }
  return {.threads = static_cast<unsigned>(std::stoul(texts.at(0))),
          .identity = {.experiment = texts.at(1), .code = texts.at(2), .files = texts.at(3), .shard = {}}};
}

Bytes text_bytes(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

std::string text_from(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace rocking::program::mpi
