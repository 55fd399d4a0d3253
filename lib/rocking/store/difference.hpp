#pragma once

#include <string>
#include <vector>

#include "rocking/store/store.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// A realisation whose result differed when it was run again.
struct Difference {
  RealisationKey key;
  std::vector<std::string> fields;  ///< names of the fields of its row that differ
};

/// Names of the fields in which two summaries differ.
[[nodiscard]] std::vector<std::string> differing_fields(const Summary& a, const Summary& b);

/// Adds the realisations of one store to another. Realisations present in both must be equal; those that are not are
/// returned, in order. The added rows are not yet durable.
[[nodiscard]] std::vector<Difference> merge(Store& into, const Store& from);

}  // namespace rocking
