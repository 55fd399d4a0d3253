#include "rocking/base/regular_file.hpp"

#include <system_error>

#include "rocking/base/error.hpp"

namespace rocking::base {

void expect_regular_file(const std::filesystem::path& path) {
  std::error_code unknown;
  const auto status = std::filesystem::status(path, unknown);
  if (unknown || status.type() == std::filesystem::file_type::not_found || is_regular_file(status)) return;
  throw InputError(
      {path.string(), "", is_directory(status) ? "is a folder" : "is a pipe or a device", "give a regular file"});
}

}  // namespace rocking::base
