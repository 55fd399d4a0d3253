// In place of base/digest.cpp, which needs OpenSSL for the processor of the build. Digests are computed only of
// realisations that are continued after their horizon; bits.cpp has none.

#include <cstdlib>

#include "rocking/base/digest.hpp"

namespace rocking::base {

struct Sha256Builder::Context {};

Sha256Builder::Sha256Builder() { std::abort(); }
Sha256Builder::~Sha256Builder() = default;
void Sha256Builder::add(double /*number*/) { std::abort(); }
Sha256 Sha256Builder::finish() { std::abort(); }

}  // namespace rocking::base
