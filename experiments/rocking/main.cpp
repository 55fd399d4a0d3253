#include "machine.hpp"
#include "program.hpp"

int main(int argc, char** argv) {
  using namespace rocking::program;
  return static_cast<int>(carry_out_command_line(argc, argv, {.threads = available_threads()}));
}
