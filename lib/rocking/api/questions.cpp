#include "rocking/api/questions.hpp"

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

}  // namespace rocking
