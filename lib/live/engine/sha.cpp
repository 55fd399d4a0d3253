#include <algorithm>
#include <bit>

#include <openssl/sha.h>

namespace {

using Words = std::array<std::uint32_t, 64>;

/// The first 32 bits of the fractional part of the k-th root (2 or 3) of the first primes, where 3 gives the constants of the
/// rounds and 2 the initial hash (sections 4.2.2 and 5.3.3): floor(2^32 root(p)) mod 2^32, by bisection in integers.
constexpr Words roots_of_primes(int power) {
  Words words{};
  std::size_t found = 0;
  for (std::uint64_t p = 2; found < words.size(); ++p) {
    bool is_prime = true;
    for (std::uint64_t d = 2; d * d <= p; ++d) is_prime = is_prime && p % d != 0;
    if (!is_prime) continue;
    std::uint64_t low = 0, high = std::uint64_t{1} << 37U;
    while (high - low > 1) {
      const std::uint64_t middle = (low + high) / 2;
      using Wide = unsigned __int128;
      // Against p 2^(32 power). The cube needs up to 111 bits.
      const Wide value = Wide{middle} * middle * (power == 3 ? middle : 1);
      (value <= Wide{p} << (32U * static_cast<unsigned>(power)) ? low : high) = middle;
    }
    words[found++] = static_cast<std::uint32_t>(low);
  }
  return words;
}

constexpr Words rounds = roots_of_primes(3);
constexpr Words first_hash = roots_of_primes(2);

void add_block(SHA256_CTX& context) {
  Words w{};
  for (std::size_t i = 0; i < 16; ++i) {
    for (std::size_t k = 0; k < 4; ++k) w[i] = w[i] << 8U | context.block[4 * i + k];
  }
  for (std::size_t i = 16; i < 64; ++i) {
    const std::uint32_t x = w[i - 15], y = w[i - 2];
    w[i] = w[i - 16] + (std::rotr(x, 7) ^ std::rotr(x, 18) ^ x >> 3U) + w[i - 7] +
           (std::rotr(y, 17) ^ std::rotr(y, 19) ^ y >> 10U);
  }
  auto [a, b, c, d, e, f, g, h] = context.hash;
  for (std::size_t i = 0; i < 64; ++i) {
    const std::uint32_t first =
        h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + ((e & f) ^ (~e & g)) + rounds[i] + w[i];
    const std::uint32_t second =
        (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
    h = g, g = f, f = e, e = d + first, d = c, c = b, b = a, a = first + second;
  }
  const std::array<std::uint32_t, 8> added{a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < 8; ++i) context.hash[i] += added[i];
}

}  // namespace

int SHA256_Init(SHA256_CTX* context) {
  std::copy_n(first_hash.begin(), 8, context->hash.begin());
  context->size = 0;
  return 1;
}

int SHA256_Update(SHA256_CTX* context, const void* data, std::size_t size) {
  const auto* bytes = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < size; ++i) {
    context->block[context->size++ % 64] = bytes[i];
    if (context->size % 64 == 0) add_block(*context);
  }
  return 1;
}

int SHA256_Final(unsigned char* digest, SHA256_CTX* context) {
  const std::uint64_t bits = 8 * context->size;
  unsigned char byte = 0x80;
  do {
    SHA256_Update(context, &byte, 1);
    byte = 0;
  } while (context->size % 64 != 56);
  for (int shift = 56; shift >= 0; shift -= 8) {
    byte = static_cast<unsigned char>(bits >> static_cast<unsigned>(shift));
    SHA256_Update(context, &byte, 1);
  }
  for (std::size_t i = 0; i < 32; ++i) {
    digest[i] = static_cast<unsigned char>(context->hash[i / 4] >> (24 - 8 * (i % 4)));
  }
  return 1;
}
