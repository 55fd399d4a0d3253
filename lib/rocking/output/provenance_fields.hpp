#pragma once

#include <string>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/fields/struct_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/response_mode.hpp"

/// How the origin of a result, and the names of its parts, stand in documents.
namespace rocking {

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

/// The values of a point of the sweep: an object of JSON pointers and values.
template <>
struct TypeOf<std::vector<Parameter>> {
  static const ValueType& get();
};

}  // namespace rocking
