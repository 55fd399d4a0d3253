#include "rocking/input/experiment_problems.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "rocking/input/overrides.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_problems = 20;

struct GoneKey {
  std::string_view place;
  std::string_view remedy;
};

/// Keys of former states of this format, and what to do without them.
constexpr std::array gone_keys{
    GoneKey{"/check_labels",
            "leave it out: every label (m,n) is tested, and the report states what backs it (backed_by)"},
    GoneKey{"/accuracy/repeat_every", "it is \"rerun_every\""}};

/// Tells what replaces a key that is gone, and where, or of which kind, one stands that was written at another place.
void name_places(Problems& problems) {
  for (base::Problem& problem : problems) {
    if (problem.reason != "is not a key of this format") continue;
    const auto* gone = std::ranges::find(gone_keys, problem.place, &GoneKey::place);
    if (gone != gone_keys.end()) {
      problem.remedy = gone->remedy;
      continue;
    }
    const auto place = place_of_key(last_key(problem.place));
    const bool is_here = place == problem.place.substr(0, problem.place.rfind('/'));
    if (place) problem.remedy = is_here ? "it is of another kind or form" : "it stands under " + *place;
  }
}

}  // namespace

bool ExperimentProblems::are_enough() const { return problems_.size() >= most_problems; }

void ExperimentProblems::merge(const Problems& found, const std::string& where) {
  for (const base::Problem& problem : found) {
    const auto is_same = [&problem](const base::Problem& other) {
      return problem.place == other.place && problem.value == other.value && problem.reason == other.reason;
    };
    if (std::ranges::any_of(seen_, is_same)) continue;
    seen_.push_back(problem);
    problems_.push_back(problem);
    problems_.back().reason += where;
  }
}

/// Tells with the first record that cannot be read which ones can.
void ExperimentProblems::name_readable_records(const Suite& suite) {
  constexpr std::size_t most_named = 30;
  std::vector<std::string> readable;
  auto first = problems_.end();
  for (const Json& record : suite.records) {
    const auto found =
        std::ranges::find_if(problems_, [&record](const base::Problem& each) { return is_of_record(each, record); });
    if (found == problems_.end()) {
      readable.push_back(record["file"].get<std::string>());
    } else {
      first = std::min(first, found);
    }
  }
  if (first == problems_.end() || readable.empty() || are_enough()) return;
  first->remedy += "; --skip-unreadable goes on with the other " + std::to_string(readable.size()) + ": ";
  for (std::size_t i = 0; i < std::min(readable.size(), most_named); ++i) {
    first->remedy += (i == 0 ? "" : ", ") + readable[i].substr(readable[i].rfind('/') + 1);
  }
  if (readable.size() > most_named) first->remedy += ", ...";
}

void ExperimentProblems::throw_any(const Overrides& overrides, const Suite& suite) {
  name_flags(overrides, problems_);
  name_readable_records(suite);
  name_places(problems_);
  if (problems_.size() > most_problems) problems_.resize(most_problems);
  if (any()) throw base::InputError(std::move(problems_));
}

}  // namespace rocking
