#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/api/trajectory.hpp"
#include "rocking/base/error.hpp"
#include "rocking/fields/container_types.hpp"
#include "rocking/fields/struct_type.hpp"

namespace rocking {

/// The fields of what callers in C++ ask, with the rule of each.
[[nodiscard]] const StructType& fields_of(const Execution*);
[[nodiscard]] const StructType& fields_of(const Provenance*);
[[nodiscard]] const StructType& fields_of(const TrajectoryRequest*);

template <const StructType& (*fields)()>
[[nodiscard]] const ValueType& struct_type() {
  return fields();
}

/// A list of structs that have these fields in questions.
template <class Item, const StructType& (*fields)()>
[[nodiscard]] const ValueType& list_of() {
  return the_only<ListType<std::vector<Item>, 0, struct_type<fields>>>();
}

/// Finds what is wrong with a question: first each number and text by the rule of its field, then what expect() is told.
class QuestionCheck {
 public:
  QuestionCheck() = default;
  template <HasFields Question>
  explicit QuestionCheck(const Question& question) {
    fields_of(&question).check(&question, {.pointer = "", .problems = &problems_});
  }

  /// A relation between values. `place`: within the question, such as `earlier/0/at`.
  void expect(bool holds, std::string place, std::string value, std::string reason);
  void expect_size(std::size_t size, std::size_t right, std::string place, std::string_view of_each);
  void add(std::vector<base::Problem> problems);

  /// Throws base::InputError with the first twenty problems, if there is any.
  void finish();

 private:
  std::vector<base::Problem> problems_;
};

/// Throws base::InputError if a field of the question breaks its rule.
template <HasFields Question>
void check_fields(const Question& question) {
  QuestionCheck(question).finish();
}

}  // namespace rocking
