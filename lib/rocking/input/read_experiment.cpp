#include "rocking/input/read_experiment.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rocking/input/experiment_problems.hpp"
#include "rocking/input/other_files.hpp"
#include "rocking/input/overrides.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/input/read_question.hpp"
#include "rocking/input/repeated_records.hpp"
#include "rocking/input/suite.hpp"
#include "rocking/input/sweep.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/locate.hpp"

namespace rocking {
namespace {

constexpr std::size_t enough_problems = 10;  // of a file without its sweep: the sweep is then left aside

// Tells values as they are written.
void check_relations_of(const Condition& condition, const Json& document, Problems& problems) {
  const std::size_t problems_before = problems.size();
  check_relations(condition, problems);
  for (std::size_t i = problems_before; i < problems.size(); ++i) {
    const Json::json_pointer place(problems[i].place);
    problems[i].value = document.contains(place) ? brief(document.at(place)) : "";
  }
}

class ExperimentBuilder {
 public:
  ExperimentBuilder(Json document, const Surroundings& surroundings, Problems problems)
      : document_(std::move(document)),
        files_(surroundings.files),
        matches_(surroundings.matches),
        most_conditions_(surroundings.most_conditions),
        problems_(std::move(problems)) {}

  Experiment build(const Overrides& overrides) {
    apply(overrides, document_);
    Problems found;
    take_strength_from_sweep(document_);
    suite_ = take_suite(document_, matches_, files_, overrides.skips_unreadable, found);
    const bool is_bad_suite = !found.empty();
    QuestionAsRead base = read_question(has_suite() ? with_suite_as_sweep(document_) : document_, &files_, found);
    // Merging and sweeping compare keys with each other, which takes hours where there are 10^5 of them.
    const bool is_hopeless = found.size() > enough_problems;
    const bool swept = !is_hopeless && document_.is_object() && document_.contains("sweep");
    if (swept) read_axes(base.canonical, overrides, found);
    if (!is_hopeless && document_.is_object() && document_.contains("unknown")) {
      unknowns_ = read_unknowns(document_["unknown"], base.canonical, axes_, found);
    }
    problems_.merge(found);
    if (has_suite()) {
      axes_.insert(axes_.begin(), SweepAxis{.pointer = std::string(suite_place), .values = suite_.records});
    }
    const bool is_readable = !is_hopeless && !is_bad_suite && document_.is_object();
    if (is_readable && !problems_.are_enough()) build_conditions();
    if (has_suite() && !problems_.any()) check_records();
    problems_.throw_any(overrides, suite_);
    if (swept) base.canonical["sweep"] = canonical_sweep();
    if (has_suite()) {
      if (!swept) base.canonical.erase("sweep");
      write_suite(base.canonical, {.records = axes_.front().canonical_values, .left_out = suite_.left_out});
    }
    return {.title = base.question.title,
            .seed = base.question.seed,
            .conditions = std::move(conditions_),
            .canonical_text = base.canonical.dump(),
            .sweep_sizes = sweep_sizes(),
            .unknowns = std::move(unknowns_),
            .left_out = std::move(suite_.left_out)};
  }

 private:
  [[nodiscard]] bool has_suite() const { return !suite_.records.empty(); }

  /// Each record as the first condition has it that names it.
  [[nodiscard]] std::vector<std::shared_ptr<const GroundMotion>> motions_of_suite() const {
    std::vector<std::shared_ptr<const GroundMotion>> motions;
    const std::size_t of_a_record = conditions_.size() / suite_.records.size();
    for (std::size_t i = 0; i < conditions_.size(); i += of_a_record) {
      auto motion = std::get<Recorded>(conditions_[i].scene.excitation).ground_motion;
      // A table may select a record for several levels.
      if (std::ranges::find(motions, motion) == motions.end()) motions.push_back(std::move(motion));
    }
    return motions;
  }

  /// Reports records that cannot stand beside the others, and warns of those that are likely another one once more.
  void check_records() {
    const auto motions = motions_of_suite();
    check_suite(motions, problems_.all());
    if (problems_.any()) return;
    for (const auto& [record, why] : repeated_records(motions)) {
      auto warned = std::make_shared<GroundMotion>(*motions[record]);
      warned->warnings.push_back(why);
      for (Condition& condition : conditions_) {
        auto& motion = std::get<Recorded>(condition.scene.excitation).ground_motion;
        if (motion == motions[record]) motion = warned;
      }
    }
  }

  void read_axes(const Json& canonical, const Overrides& overrides, Problems& found) {
    Json known = canonical;
    known.merge_patch(document_);  // a place whose value is refused is a place nonetheless
    Problems of_sweep;
    const std::size_t records = std::max<std::size_t>(suite_.records.size(), 1);
    axes_ = read_sweep(document_["sweep"], known, std::max<std::size_t>(most_conditions_ / records, 1), of_sweep);
    apply(overrides, axes_, of_sweep);
    if (has_suite()) refuse_swept_suite(of_sweep);
    if (!of_sweep.empty()) axes_.clear();  // the file can still be checked as one condition
    found.insert(found.end(), of_sweep.begin(), of_sweep.end());
  }

  void refuse_swept_suite(Problems& problems) const {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      if (axes_[i].pointer != "/excitation" && axes_[i].pointer != "/excitation/kind") continue;
      problems.push_back({"/sweep/" + std::to_string(i) + "/parameter", '"' + axes_[i].pointer + '"',
                          "changes the excitation, whose ground motions are a suite", "omit it, or the suite"});
    }
  }

  // Every condition is read as a file of its own, in which the swept values stand in their places.
  void build_conditions() {
    const std::size_t size = grid_size(axes_);
    Json document = document_;
    if (!axes_.empty()) document["sweep"] = swept_places();
    const std::vector<std::string> swept = swept_keys();
    for (const SweepAxis& axis : axes_) places_.emplace_back(axis.pointer);
    conditions_.reserve(size);
    for (std::size_t index = 0; index < size && !problems_.are_enough(); ++index) {
      const auto values = grid_point(axes_, index);
      for (std::size_t i = 0; i < axes_.size(); ++i) {
        if (!put(document, i, *values[i])) return;
      }
      Problems found;
      QuestionAsRead read = read_question(document, &files_, found, swept);
      check_relations_of(read.question.condition, document, found);
      if (!found.empty()) problems_.merge(found, setting_in_words(values));
      if (!problems_.any()) keep(std::move(read), index);
    }
  }

  [[nodiscard]] std::string setting_in_words(const std::vector<const Json*>& values) const {
    std::string words;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      words += (i == 0 ? " (where the sweep sets " : ", ") + axes_[i].pointer + " = " + shown(*values[i]);
    }
    return words.empty() ? words : words + ')';
  }

  /// The keys of the file in which swept values stand: of a condition nothing else is written in canonical form.
  [[nodiscard]] std::vector<std::string> swept_keys() const {
    std::vector<std::string> keys;
    for (const SweepAxis& axis : axes_) keys.push_back(axis.pointer.substr(1, axis.pointer.find('/', 1) - 1));
    return keys;
  }

  // The sweep without its values, which no condition needs.
  Json swept_places() const {
    Json places = Json::array();
    for (const SweepAxis& axis : axes_) places.push_back({{"parameter", axis.pointer}});
    return places;
  }

  // A record of a suite by its file alone.
  static std::string shown(const Json& value) { return brief(value.is_object() ? name_of_record(value) : value); }

  // A place that cannot be reached belongs to a part of the file that was already refused.
  bool put(Json& document, std::size_t axis, const Json& value) const {
    if (axes_[axis].pointer == suite_place) {
      put_record(document, value);
      return true;
    }
    try {
      document[places_[axis]] = value;
      return true;
    } catch (const Json::exception&) {
      return false;
    }
  }

  void keep(QuestionAsRead read, std::size_t index) {
    std::size_t stride = grid_size(axes_);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      SweepAxis& axis = axes_[i];
      stride /= axis.values.size();
      const bool is_suite = axis.pointer == suite_place;
      Json canonical = is_suite ? record_of(read.canonical) : read.canonical.at(places_[i]);
      if (is_suite) read.question.condition.record_stream = stream_of(canonical);
      const Json value = is_suite ? name_of_record(canonical) : canonical;
      const std::size_t place = (index / stride) % axis.values.size();
      read.question.condition.parameters.push_back(
          {axis.pointer, swept_value(value), axis.name_of(&axis.values[place])});
      // The first condition with this value, at the first values of the others, gives its canonical form.
      if (index == place * stride) axis.canonical_values.push_back(std::move(canonical));
    }
    conditions_.push_back(std::move(read.question.condition));
  }

  std::vector<std::size_t> sweep_sizes() const {
    std::vector<std::size_t> sizes;
    for (const SweepAxis& axis : axes_) sizes.push_back(axis.values.size());
    return sizes;
  }

  Json canonical_sweep() const {
    Json sweep = Json::array();
    const std::size_t of_suite = has_suite() ? 1 : 0;
    for (std::size_t i = of_suite; i < axes_.size(); ++i) {
      Json entry = Json::object();
      entry["parameter"] = axes_[i].pointer;
      if (axes_[i].evenly_spaced) {
        for (const char* key : {"from", "to", "step"}) {
          entry[key] = document_["sweep"][i - of_suite][key].get<double>();
        }
      } else {
        entry["values"] = axes_[i].canonical_values;
        if (!axes_[i].names.empty()) entry["names"] = axes_[i].names;
      }
      sweep.push_back(std::move(entry));
    }
    return sweep;
  }

  Json document_;
  GroundMotionFiles files_;
  FileMatches matches_;
  Suite suite_;  ///< without records: the experiment has none
  std::size_t most_conditions_;
  ExperimentProblems problems_;
  std::vector<SweepAxis> axes_;
  std::vector<Json::json_pointer> places_;  ///< of the axes
  std::vector<Condition> conditions_;
  std::vector<Unknown> unknowns_;
};

}  // namespace

Surroundings seen_from(const std::filesystem::path& folder) {
  return {.files = files_seen_from(folder), .matches = matches_seen_from(folder)};
}

Experiment experiment_in(std::string_view text, const Overrides& overrides, const Surroundings& surroundings) {
  Problems problems;
  if (auto refusal = refuse_binary_file(text)) {
    throw base::InputError(
        {"the file", "", std::move(refusal->reason), "give an experiment in JSON, as text in UTF-8"});
  }
  Json document = parse_json(text, problems);
  return ExperimentBuilder(std::move(document), surroundings, std::move(problems)).build(overrides);
}

ExperimentText experiment_text_of(const std::filesystem::path& path) {
  return {.text = read_file(path, most_experiment_bytes), .name = path.string(), .folder = path.parent_path()};
}

Experiment experiment_in(const ExperimentText& source, const Overrides& overrides) {
  if (source.text.size() > most_experiment_bytes) {
    throw base::InputError({.place = source.name,
                            .value = "",
                            .reason = "is longer than 64 MB",
                            .remedy = "give a range instead of a list of values"});
  }
  try {
    return experiment_in(source.text, overrides, seen_from(source.folder));
  } catch (const base::InputError& error) {
    if (source.name.empty()) throw;
    throw located(error, source.text, source.name);
  }
}

Experiment read_experiment_file(const std::filesystem::path& path, const Overrides& overrides) {
  return experiment_in(experiment_text_of(path), overrides);
}

}  // namespace rocking
