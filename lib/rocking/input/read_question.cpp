#include "rocking/input/read_question.hpp"

#include "rocking/input/reading_keys.hpp"

namespace rocking {
namespace {

void read_format(ObjectReader& in) {
  const Json* format = in.value("format");
  if (format == nullptr) {
    in.reject("format", "is missing", "add \"format\": \"" + std::string(experiment_format) + '"');
  } else if (*format != experiment_format) {
    in.reject("format", "is not a format that this version reads", "write \"" + std::string(experiment_format) + '"');
  }
  in.write("format", experiment_format);
}

}  // namespace

QuestionAsRead read_question(const Json& document, GroundMotionFiles* files, Problems& problems,
                             std::span<const std::string> written) {
  QuestionAsRead read;
  ObjectReader in(document, "", problems);
  if (!written.empty()) in.write_only(written);
  read_format(in);
  const bool is_swept = document.is_object() && document.contains("sweep");
  ReadingKeys keys(in, {.sweep = is_swept ? &document["sweep"] : nullptr, .files = files});
  keys_of(keys, read.question);
  read.canonical = in.finish();
  return read;
}

}  // namespace rocking
