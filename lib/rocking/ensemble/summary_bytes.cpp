#include "rocking/ensemble/summary_bytes.hpp"

#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace rocking {
namespace {

class Packer {
 public:
  template <class Value>
  void put(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    const auto* first = reinterpret_cast<const std::byte*>(&value);
    bytes_.insert(bytes_.end(), first, first + sizeof value);
  }
  void put(const section::ModeCounts& counts) {
    const std::string text = to_string(counts);
    put(std::uint64_t{text.size()});
    for (const char letter : text) put(letter);
  }
  template <class Value>
  void put(const std::optional<Value>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  Bytes finish() { return std::move(bytes_); }

 private:
  Bytes bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class Value>
  void get(Value& value) {
    if (bytes_.size() < sizeof value) throw std::length_error("a message between processes ends too early");
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_ = bytes_.subspan(sizeof value);
  }
  void get(section::ModeCounts& counts) {
    std::uint64_t size = 0;
    get(size);
    if (size > bytes_.size()) throw std::length_error("a message between processes ends too early");
    std::string text(size, ' ');
    for (char& letter : text) get(letter);
    counts = section::mode_counts_named(text).value_or(section::ModeCounts{});
  }
  template <class Value>
  void get(std::optional<Value>& value) {
    bool is_there = false;
    get(is_there);
    if (is_there) get(value.emplace());
  }
  [[nodiscard]] bool at_end() const { return bytes_.empty(); }

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace

Bytes to_bytes(std::span<const Pair> pairs) {
  Packer packer;
  for (const Pair& pair : pairs) packer.put(pair);
  return packer.finish();
}

std::vector<Pair> pairs_from(std::span<const std::byte> bytes) {
  std::vector<Pair> pairs;
  for (Unpacker unpacker(bytes); !unpacker.at_end();) unpacker.get(pairs.emplace_back());
  return pairs;
}

Bytes to_bytes(std::span<const PairOutcome> outcomes) {
  Packer packer;
  for (const PairOutcome& outcome : outcomes) {
    packer.put(outcome.pair);
    packer.put(std::uint8_t{outcome.summaries.size() == 2});
    for (const Summary& summary : outcome.summaries) {
      for_each_field(summary, [&packer](const auto&, const auto& field) { packer.put(field); });
    }
  }
  return packer.finish();
}

std::vector<PairOutcome> outcomes_from(std::span<const std::byte> bytes) {
  std::vector<PairOutcome> outcomes;
  for (Unpacker unpacker(bytes); !unpacker.at_end();) {
    PairOutcome& outcome = outcomes.emplace_back();
    unpacker.get(outcome.pair);
    std::uint8_t has_second = 0;
    unpacker.get(has_second);
    outcome.summaries.resize(has_second == 0 ? 1 : 2);
    for (Summary& summary : outcome.summaries) {
      for_each_field(summary, [&unpacker](const auto&, auto& field) { unpacker.get(field); });
    }
  }
  return outcomes;
}

}  // namespace rocking
