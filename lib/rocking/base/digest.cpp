#include "rocking/base/digest.hpp"

#include <bit>
#include <new>

#include <openssl/evp.h>

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

struct Sha256Builder::Context {
  Context() : handle(EVP_MD_CTX_new()) {
    if (handle == nullptr || EVP_DigestInit_ex(handle, EVP_sha256(), nullptr) != 1) throw std::bad_alloc();
  }
  ~Context() { EVP_MD_CTX_free(handle); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  void add(const void* data, std::size_t size) { EVP_DigestUpdate(handle, data, size); }

  EVP_MD_CTX* handle;
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
  EVP_DigestFinal_ex(context_->handle, reinterpret_cast<unsigned char*>(digest.data()), nullptr);
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

}  // namespace rocking::base
