#include "rocking/base/digest.hpp"

// The functions for SHA-256 alone. Those for any digest, which OpenSSL 3 recommends, read its configuration and look up
// the algorithm first: a fifth of the instructions of a run of one realisation, and memory allocated for every digest.
#define OPENSSL_SUPPRESS_DEPRECATED

#include <bit>
#include <charconv>
#include <cstring>
#include <system_error>

#include <openssl/sha.h>

#include "rocking/base/error.hpp"

namespace rocking::base {
namespace {

template <class Word>
std::array<std::byte, 8> little_endian(Word word) {
  auto bytes = std::bit_cast<std::array<std::byte, 8>>(word);
  if constexpr (std::endian::native == std::endian::big) {
    for (std::size_t i = 0; i < 4; ++i) std::swap(bytes[i], bytes[7 - i]);
  }
  return bytes;
}

}  // namespace

/// Collects small pieces: OpenSSL takes longer to accept a number than to digest it.
struct Sha256Builder::Context {
  Context() { SHA256_Init(&state); }

  void add(const void* data, std::size_t size) {
    if (size > waiting.size() - filled) {
      pass_on();
      if (size > waiting.size()) {
        SHA256_Update(&state, data, size);
        return;
      }
    }
    if (size > 0) std::memcpy(waiting.data() + filled, data, size);
    filled += size;
  }

  void pass_on() {
    SHA256_Update(&state, waiting.data(), filled);
    filled = 0;
  }

  SHA256_CTX state;
  std::array<std::byte, 1024> waiting;
  std::size_t filled = 0;
};

Sha256Builder::Sha256Builder() : context_(std::make_unique<Context>()) {}
Sha256Builder::~Sha256Builder() = default;
Sha256Builder::Sha256Builder(Sha256Builder&&) noexcept = default;
Sha256Builder& Sha256Builder::operator=(Sha256Builder&&) noexcept = default;

void Sha256Builder::add(std::string_view text) { context_->add(text.data(), text.size()); }

void Sha256Builder::add(std::uint64_t number) {
  const auto bytes = little_endian(number);
  context_->add(bytes.data(), bytes.size());
}

void Sha256Builder::add(double number) { add(std::bit_cast<std::uint64_t>(number)); }

void Sha256Builder::add(std::span<const double> numbers) {
  for (const double number : numbers) add(number);
}

void Sha256Builder::add(const Sha256& digest) { context_->add(digest.data(), digest.size()); }

Sha256 Sha256Builder::finish() {
  ROCKING_EXPECT(context_ != nullptr);
  Sha256 digest{};
  context_->pass_on();
  SHA256_Final(reinterpret_cast<unsigned char*>(digest.data()), &context_->state);
  context_.reset();
  return digest;
}

Sha256 sha256(std::string_view text) {
  Sha256Builder builder;
  builder.add(text);
  return builder.finish();
}

std::string to_hex(const Sha256& digest) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  text.reserve(2 * digest.size());
  for (const std::byte byte : digest) {
    const auto value = std::to_integer<unsigned>(byte);
    text += digits[value >> 4U];
    text += digits[value & 15U];
  }
  return text;
}

std::optional<Sha256> sha256_from_hex(std::string_view digits) {
  Sha256 digest{};
  if (digits.size() != 2 * digest.size()) return std::nullopt;
  for (std::size_t i = 0; i < digest.size(); ++i) {
    unsigned value = 0;
    const char* const end = digits.data() + 2 * i + 2;
    const auto [rest, error] = std::from_chars(digits.data() + 2 * i, end, value, 16);
    if (error != std::errc() || rest != end) return std::nullopt;
    digest[i] = std::byte{static_cast<unsigned char>(value)};
  }
  return to_hex(digest) == digits ? std::optional(digest) : std::nullopt;
}

}  // namespace rocking::base
