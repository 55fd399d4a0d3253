#include "needs.hpp"

#include <system_error>

#include <fmt/format.h>

#include "machine.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::program {

void expect_memory(std::uint64_t bytes) {
  const auto free = available_memory();
  if (!free || bytes <= *free) return;
  throw std::system_error(
      std::make_error_code(std::errc::not_enough_memory),
      fmt::format("the run may need {} of memory, {} are free; divide the sweep between several files, use shorter "
                  "horizons or fewer threads, or use a machine with more memory",
                  size_in_words(bytes), size_in_words(*free)));
}

}  // namespace rocking::program
