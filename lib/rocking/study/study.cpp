#include "rocking/study/study.hpp"

#include <algorithm>

namespace rocking {

std::string Study::command() const {
  std::string command(name);
  std::ranges::replace(command, '_', '-');
  return command;
}

}  // namespace rocking
