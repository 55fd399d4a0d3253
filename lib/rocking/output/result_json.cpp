#include "rocking/output/result_json.hpp"

#include "rocking/output/provenance_fields.hpp"
#include "rocking/output/stats_fields.hpp"

namespace rocking {

Json interval_json(const stats::Interval& interval) { return type_of<stats::Interval>().json(&interval); }

Json parameters_json(const Condition& condition) {
  return type_of<std::vector<Parameter>>().json(&condition.parameters);
}

}  // namespace rocking
