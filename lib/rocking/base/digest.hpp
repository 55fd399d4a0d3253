#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rocking::base {

using Sha256 = std::array<std::byte, 32>;

/// Lower-case hexadecimal, 64 characters.
[[nodiscard]] std::string to_hex(const Sha256& digest);

/// The digest of 64 such digits; absent if they are not.
[[nodiscard]] std::optional<Sha256> sha256_from_hex(std::string_view digits);

/// Computes the SHA-256 (FIPS 180-4) of the data added to it. Numbers are added as their bytes in little-endian order,
/// so that a digest is the same on every machine; -0.0 and 0.0 give different digests.
class Sha256Builder {
 public:
  Sha256Builder();
  ~Sha256Builder();
  Sha256Builder(Sha256Builder&&) noexcept;
  Sha256Builder& operator=(Sha256Builder&&) noexcept;

  void add(std::string_view text);
  void add(std::uint64_t number);
  void add(double number);
  void add(std::span<const double> numbers);
  void add(const Sha256& digest);

  /// Returns the digest of all data added. The builder must not be used afterwards.
  [[nodiscard]] Sha256 finish();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

[[nodiscard]] Sha256 sha256(std::string_view text);

}  // namespace rocking::base
