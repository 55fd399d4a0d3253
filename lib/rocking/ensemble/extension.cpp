#include "rocking/ensemble/extension.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "rocking/base/error.hpp"

namespace rocking {

std::uint64_t most_stored_realisations(const Store& store) {
  std::uint64_t most = 0;
  store.for_each_key([&most](const RealisationKey& key) { most = std::max(most, key.realisation + 1); });
  return most;
}

void copy_common_realisations(const Store& former, const Experiment& experiment, const Experiment& extension,
                              Store& into) {
  ROCKING_EXPECT(experiment.seed == extension.seed);
  std::map<std::vector<Parameter>, std::uint64_t> places;
  for (std::uint64_t i = 0; i < extension.conditions.size(); ++i) places[extension.conditions[i].parameters] = i;
  std::vector<std::uint64_t> there;
  for (const Condition& condition : experiment.conditions) there.push_back(places.at(condition.parameters));
  former.for_each([&](const RealisationKey& key, const Summary& summary) {
    const RealisationKey new_key{.condition = there.at(key.condition), .realisation = key.realisation};
    const std::uint64_t before = effective_realisations(experiment.conditions[key.condition]);
    const std::uint64_t after = effective_realisations(extension.conditions[new_key.condition]);
    const bool is_alone_in_one = key.realisation % 2 == 0 && key.realisation + 1 == std::min(before, after);
    if (key.realisation >= after || (is_alone_in_one && before != after)) return;
    into.add(new_key, summary);
  });
}

std::filesystem::path extended_store_beside(const std::filesystem::path& path) {
  return path.parent_path() / "extended.sqlite";
}

void extend_store(const std::filesystem::path& path, Store former, const Experiment& experiment,
                  const Experiment& extension, const std::string& code) {
  const std::filesystem::path extended = extended_store_beside(path);
  Store::remove(extended);  // of a process that was killed
  Identity identity = former.identity();
  identity.experiment = extension.canonical_text;
  identity.code = code;
  {
    Store store = Store::create(extended, identity);
    copy_common_realisations(former, experiment, extension, store);
    store.close_up();
  }
  { const Store closed = std::move(former); }
  sqlite::remove_logs(path);  // SQLite would apply them to the new file
  std::filesystem::rename(extended, path);
}

}  // namespace rocking
