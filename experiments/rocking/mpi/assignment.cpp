#include "assignment.hpp"

#include <string>
#include <vector>

namespace rocking::program::mpi {

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
