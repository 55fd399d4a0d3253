#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

// The three functions of OpenSSL that base/digest.cpp calls, for a target that OpenSSL does not know: SHA-256 (FIPS 180-4).

struct SHA256_CTX {
  std::array<std::uint32_t, 8> hash;
  std::array<unsigned char, 64> block;
  std::uint64_t size;  ///< bytes that were added
};

int SHA256_Init(SHA256_CTX* context);
int SHA256_Update(SHA256_CTX* context, const void* data, std::size_t size);
int SHA256_Final(unsigned char* digest, SHA256_CTX* context);
