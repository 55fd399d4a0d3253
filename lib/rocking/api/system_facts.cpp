#include "rocking/api/system_facts.hpp"

#include "rocking/input/report_claims.hpp"
#include "rocking/text/files.hpp"

namespace rocking {

Surroundings seen_near(const std::filesystem::path& folder) {
  Surroundings surroundings;
  surroundings.files = [folder](const std::string& name, std::size_t most) {
    const std::filesystem::path around = std::filesystem::absolute(folder / "..").lexically_normal();
    for (const std::filesystem::path& place : {folder, around}) {
      if (std::filesystem::exists(place / name)) return files_seen_from(place)(name, most);
    }
    return files_seen_from(".")(name, most);
  };
  return surroundings;
}

std::optional<Experiment> stated_experiment(const InputFacts& input, const Surroundings& surroundings) {
  if (input.experiment.is_null()) return {};
  const std::string text = input.experiment.dump();
  if (!has_stated_digest({.experiment = text, .sha256 = input.sha256, .code = ""})) return {};
  return experiment_in(text, {}, surroundings);
}

}  // namespace rocking
