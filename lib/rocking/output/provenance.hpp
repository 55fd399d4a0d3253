#pragma once

#include <string>
#include <vector>

#include "rocking/base/build_info.hpp"
#include "rocking/base/digest.hpp"
#include "rocking/fields/struct_type.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/text/json.hpp"

/// The origin of a result.
namespace rocking {

/// What was asked.
struct InputFacts {
  Json experiment;     ///< canonical; null if it was made in C++
  std::string sha256;  ///< of its text, in hexadecimal digits

  [[nodiscard]] std::string title() const { return experiment.is_null() ? "" : experiment.at("title"); }
};

[[nodiscard]] InputFacts input_of(const Experiment& experiment);

/// Facts that may differ between two equal runs. The caller provides them; the library does not read them itself.
struct SystemFacts {
  base::BuildInfo build;
  std::string machine;      ///< processor and operating system
  std::string start;        ///< ISO 8601 in UTC, as `2012-02-01T12:00:00Z`
  double duration_s = 0.0;  ///< wall-clock time of the run [s]
  unsigned threads = 1;
};

/// 64 bits as text: `0x2012`.
[[nodiscard]] const ValueType& seed_type();

/// A digest in hexadecimal digits.
template <>
struct TypeOf<base::Sha256> {
  static const ValueType& get();
};

[[nodiscard]] const StructType& fields_of(const InputFacts*);
[[nodiscard]] const StructType& fields_of(const SystemFacts*);

/// Reports a digest that is not that of the experiment in the same file.
void check_input(const InputFacts& input, const ReadingPlace& place);

/// Reports where a value differs from what follows from the rest of the file.
void check_fit(const Json& read, const Json& right, const ReadingPlace& place);
template <class T>
void check_fit(const T& read, const T& right, const ReadingPlace& place) {
  check_fit(type_of<T>().json(&read), type_of<T>().json(&right), place);
}

/// The name of a response mode, as `(1,3)`.
template <>
struct TypeOf<section::ResponseMode> {
  static const ValueType& get();
};

/// The values of a point of the sweep: an object of JSON pointers and values, and under `names` the names of those that
/// have one.
template <>
struct TypeOf<std::vector<Parameter>> {
  static const ValueType& get();
};

}  // namespace rocking
