#include "rocking/api/question_check.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rocking {

const StructType& fields_of(const Execution*) {
  static const StructType fields{
      "Execution",
      field<&Execution::threads>("threads", "of the computation", Rule{.least = 1.0, .most = 4096.0}),
  };
  return fields;
}

const StructType& fields_of(const Provenance*) {
  static const StructType fields{
      "Provenance",
      field<&Provenance::duration_s>("duration_s", "of the run [s]", rule::not_negative),
      field<&Provenance::threads>("threads", "of the run"),
  };
  return fields;
}

const StructType& fields_of(const TrajectoryRequest*) {
  using Type = TrajectoryRequest;
  static const StructType fields{
      "TrajectoryRequest",
      field<&Type::condition>("condition", "from 0"),
      field<&Type::realisation>("realisation", "from 0", Rule{.most = 999'999'999.0}),
      field<&Type::periods>("periods", "of the excitation", Rule{.least = 1.0, .most = 1e8}),
      field<&Type::samples_per_period>("samples_per_period", "of the history", Rule{.least = 0.0, .most = 1e5}),
  };
  return fields;
}

void QuestionCheck::expect(bool holds, std::string place, std::string value, std::string reason) {
  if (!holds) problems_.push_back({std::move(place), std::move(value), std::move(reason), ""});
}

void QuestionCheck::expect_size(std::size_t size, std::size_t right, std::string place, std::string_view of_each) {
  expect(size == right, std::move(place), std::to_string(size) + " entries",
         "must be " + std::to_string(right) + ", one for each " + std::string(of_each));
}

void QuestionCheck::add(std::vector<base::Problem> problems) {
  std::ranges::move(problems, std::back_inserter(problems_));
}

void QuestionCheck::finish() {
  constexpr std::size_t most_told = 20;
  if (problems_.empty()) return;
  problems_.resize(std::min(problems_.size(), most_told));
  for (base::Problem& problem : problems_) {
    if (problem.place.starts_with('/')) problem.place.erase(0, 1);  // that of an argument, not of a file
  }
  throw base::InputError(std::move(problems_));
}

}  // namespace rocking
