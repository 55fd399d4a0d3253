#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "rocking/input/ground_motion_files.hpp"
#include "rocking/input/object_reader.hpp"
#include "rocking/scene/keys.hpp"

/// What is asked of the files of a recorded excitation.
namespace rocking {

/// A file and its digest, which must be that of the file and is written; empty where there is no usable name. Throws
/// std::system_error where the file cannot be read. Without `files` the digest is that which is stated.
[[nodiscard]] std::string read_named_file(ObjectReader& keys, std::string_view key, std::string_view digest_key,
                                          GroundMotionFiles* files);

/// The factor that gives the motion its strength.
[[nodiscard]] Quantity scale_for(ObjectReader& keys, const Strength& strength, GroundMotionFiles& files,
                                 const std::shared_ptr<const GroundMotion>& motion, double gravity);

/// A suite is taken out before an excitation is read, unless it was refused or stands within a sweep.
void refuse_suite_here(ObjectReader& keys, std::string_view key);

}  // namespace rocking
