#pragma once

#include <filesystem>
#include <vector>

#include <CLI/CLI.hpp>

#include "rocking/base/error.hpp"
#include "rocking/fields/struct_type.hpp"

namespace rocking::program {

/// Adds the flags of the fields of a question, which they set in place; both must outlive the command.
void add_flags(CLI::App& command, const StructType& fields, void* question);

/// The files that the question says are to be written.
[[nodiscard]] std::vector<std::filesystem::path> new_files(const StructType& fields, const void* question);

/// The problems of an error, with the flag of a field in place of its key.
[[nodiscard]] base::InputError with_flags(const base::InputError& error, const StructType& fields);

}  // namespace rocking::program
