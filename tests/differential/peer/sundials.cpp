#include "differential/peer/sundials.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace rocking::peer::sundials {

Vector vector_of(N_Vector vector) {
  Vector values{};
  std::copy_n(N_VGetArrayPointer(vector), values.size(), values.begin());
  return values;
}

void require(int flag, const char* what) {
  if (flag < 0) throw std::runtime_error(std::string("SUNDIALS: ") + what + " returned " + std::to_string(flag));
}

int rates(realtype time, N_Vector state, N_Vector result, void* user) {
  const Vector values = static_cast<const Equations*>(user)->rates(time, vector_of(state));
  std::copy(values.begin(), values.end(), N_VGetArrayPointer(result));
  return 0;
}

int guards(realtype time, N_Vector state, realtype* result, void* user) {
  const Guards values = static_cast<const Equations*>(user)->guards(time, vector_of(state));
  std::copy(values.begin(), values.end(), result);
  return 0;
}

void be_silent(int, const char*, const char*, char*, void*) {}

std::array<int, guard_count> falling() {
  std::array<int, guard_count> directions;
  directions.fill(-1);
  return directions;
}

}  // namespace rocking::peer::sundials
