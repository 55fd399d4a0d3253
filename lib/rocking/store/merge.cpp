#include "rocking/store/merge.hpp"

namespace rocking {

std::vector<Difference> merge(Store& into, const Store& from) {
  std::vector<Difference> conflicts;
  from.for_each([&](const RealisationKey& key, const Summary& summary) {
    const auto known = into.find(key);
    if (!known) return into.add(key, summary);
    const auto fields = differing_fields(*known, summary);
    if (!fields.empty()) conflicts.push_back({key, fields});
  });
  return conflicts;
}

}  // namespace rocking
