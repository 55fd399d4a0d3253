#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/api/questions.hpp"
#include "rocking/base/error.hpp"

namespace rocking {

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
