#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "rocking/input/record_formats.hpp"
#include "rocking/scene/experiment_keys.hpp"
#include "rocking/scene/intensity_measures.hpp"
#include "rocking/text/files.hpp"

namespace rocking {

/// The recorded motions that an experiment names. A file is opened when it is first asked for, and read once for all
/// conditions that share it.
class GroundMotionFiles {
 public:
  explicit GroundMotionFiles(FileSource source) : source_(std::move(source)) {}

  /// The motion, or null where the file holds none; what is wrong with it is then told, each time.
  /// Throws std::system_error where the file cannot be read.
  [[nodiscard]] std::shared_ptr<const GroundMotion> motion(const GroundMotionReading& how, Problems& problems);

  /// The spectral acceleration of a motion at a period, or the average of its pseudo-acceleration over a range of periods
  /// (intensity_measures.hpp), over g; computed once.
  [[nodiscard]] double spectral_acceleration(const std::shared_ptr<const GroundMotion>& motion,
                                             const std::vector<double>& periods, OscillatorAcceleration which);

  /// Throws as above.
  [[nodiscard]] const std::string& text(const std::string& name) { return file(name).text; }
  /// SHA-256 of the file's bytes, in lower-case hexadecimal. Throws as above.
  [[nodiscard]] std::string digest(const std::string& name) { return file(name).digest; }

 private:
  struct File {
    std::string text;
    std::string digest;
  };
  struct Reading {
    std::shared_ptr<const GroundMotion> motion;
    Problems problems;
  };
  [[nodiscard]] const File& file(const std::string& name);
  [[nodiscard]] Reading read(const GroundMotionReading& how);
  enum class Role : std::uint8_t { horizontal, vertical };
  [[nodiscard]] std::optional<GroundMotion> component(const std::string& name, Role role,
                                                      const GroundMotionReading& how, Problems& problems);

  FileSource source_;
  std::map<std::string, File> files_;
  std::map<GroundMotionReading, Reading> readings_;
  std::map<std::tuple<std::shared_ptr<const GroundMotion>, std::vector<double>, OscillatorAcceleration>, double>
      spectral_;
  std::size_t samples_ = 0;  ///< held by all readings
};

/// The keys of a recorded excitation as a file has them. Throws std::system_error where a file cannot be read. Without
/// `files` none is looked at, and the digest is that which is stated.
class FiledRecords final : public RecordFields {
 public:
  explicit FiledRecords(GroundMotionFiles* files) : files_(files) {}

  [[nodiscard]] const ValueType& format_type() const override { return record_format_type(); }
  /// The name is empty where it is not usable. The digest must be that of the file, and is written.
  void file(FieldVisitor& in, const Key& file, const Key& digest, std::string& name) override;
  /// A suite is taken out before an excitation is read, unless it was refused or stands within a sweep.
  bool suite(FieldVisitor& in, const Key& key) override;
  void ground_motion(FieldVisitor& in, const GroundMotionReading& how, const std::optional<Strength>& strength,
                     Recorded& recorded) override;

 private:
  [[nodiscard]] Quantity scale_for(FieldVisitor& in, const Strength& strength,
                                   const std::shared_ptr<const GroundMotion>& motion, double gravity);

  GroundMotionFiles* files_;
};

}  // namespace rocking
