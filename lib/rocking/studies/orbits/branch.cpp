#include "rocking/studies/orbits/branch.hpp"

namespace rocking {}  // namespace rocking
