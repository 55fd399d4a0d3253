#include "rocking/output/ground_motion_facts.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "rocking/fields/container_types.hpp"
#include "rocking/output/findings.hpp"
#include "rocking/scene/intensity_measures.hpp"
#include "rocking/scene/restitution.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {

const StructType& fields_of(const GroundMotionFacts*) {
  using Facts = GroundMotionFacts;
  static const StructType fields{
      "GroundMotionFacts",
      field<&Facts::file>("file", "that was read"),
      field<&Facts::format>("format", "in which it was read"),
      field<&Facts::unit>("unit", "of the accelerations in the file"),
      field<&Facts::unit_is_assumed>("unit_is_assumed", "whether neither the file nor the user states the unit"),
      field<&Facts::columns>("columns", "of a file of numbers: what each was taken for; otherwise empty"),
      field<&Facts::component>("component", "that was read, as the header names it, or null"),
      field<&Facts::components>("components", "of the file, where it holds several; otherwise empty"),
      field<&Facts::header_peak_m_s2>(
          "header_peak_m_s2", "largest acceleration that the header states, or null [m/s^2]", rule::not_negative),
      field<&Facts::header_peak_agrees>(
          "header_peak_agrees", "whether it is that of the samples, to 1 % and the digits that are printed, or null"),
      field<&Facts::has_vertical>("has_vertical", "whether there is a vertical component"),
      field<&Facts::vertical_file>("vertical_file", "from which the vertical component was read, or null"),
      field<&Facts::samples>("samples", "that were read", {.least = 1}),
      field<&Facts::declared_samples>("declared_samples", "that the header declares, or null"),
      field<&Facts::time_step_s>("time_step_s", "null if the times of the file are not evenly spaced [s]",
                                 rule::positive),
      field<&Facts::duration_s>("duration_s", "from the first sample to the last [s]", rule::not_negative),
      field<&Facts::warnings>("warnings", "sentences about the file"),
  };
  return fields;
}

const StructType& fields_of(const UsedGroundMotion*) {
  using Used = UsedGroundMotion;
  static const StructType fields{
      "UsedGroundMotion",
      inlined<&Used::facts>(),
      field<&Used::least_scale>("least_scale", "smallest factor on its accelerations in any condition",
                                rule::not_negative),
      field<&Used::largest_scale>("largest_scale", "largest factor on its accelerations in any condition",
                                  rule::not_negative),
  };
  return fields;
}

GroundMotionFacts facts_of(const GroundMotion& motion) {
  GroundMotionFacts facts{.file = motion.name,
                          .format = motion.format,
                          .unit = motion.unit,
                          .unit_is_assumed = motion.unit_is_assumed,
                          .columns = {motion.columns.begin(), motion.columns.end()},
                          .component = {},
                          .components = motion.components,
                          .header_peak_m_s2 = {},
                          .header_peak_agrees = {},
                          .vertical_file = {},
                          .has_vertical = motion.has_vertical,
                          .samples = motion.samples.size(),
                          .declared_samples = motion.declared,
                          .time_step_s = motion.time_step,
                          .duration_s = motion.samples.back().time - motion.samples.front().time,
                          .warnings = motion.warnings};
  if (!motion.component.empty()) facts.component = motion.component;
  if (motion.header_peak) {
    facts.header_peak_m_s2 = motion.header_peak->m_s2;
    facts.header_peak_agrees = motion.header_peak->is_that_of_samples;
  }
  if (!motion.vertical_file.empty()) facts.vertical_file = motion.vertical_file;
  return facts;
}

std::string reading_in_words(const GroundMotionFacts& facts) {
  std::string text = facts.format;
  for (const std::string& column : facts.columns) text += (&column == facts.columns.data() ? " " : ", ") + column;
  if (!facts.components.empty()) text += ", component " + *facts.component;
  text += "; accelerations in " + facts.unit + (facts.unit_is_assumed ? " (assumed)" : "");
  if (facts.header_peak_agrees)
    text += *facts.header_peak_agrees ? ", peak as in the header" : ", peak not that of the header";
  text += "; ";
  if (!facts.has_vertical) return text + "horizontal component only";
  return text + "with a vertical component, from " +
         (facts.vertical_file ? *facts.vertical_file : std::string("the same file"));
}

std::optional<double> scale_of(const Scene& scene) {
  const auto* recorded = std::get_if<Recorded>(&scene.excitation);
  return recorded == nullptr ? std::nullopt : std::optional(recorded->size());
}

const StructType& fields_of(const FloorPeaks*) {
  static const StructType fields{
      "FloorPeaks",
      field<&FloorPeaks::pga_g>("pga_g", "largest horizontal acceleration of the ground over g, scaled",
                                rule::not_negative),
      field<&FloorPeaks::floor_peak_g>(
          "floor_peak_g", "the same of the floor; of a random building that of the mean one", rule::not_negative),
  };
  return fields;
}

std::optional<FloorPeaks> floor_peaks_of(const Scene& scene) {
  const auto* recorded = std::get_if<Recorded>(&scene.excitation);
  if (recorded == nullptr || !recorded->building || !recorded->ground_motion) return std::nullopt;
  return FloorPeaks{.pga_g = recorded->size() * peak_acceleration(recorded->ground_motion->samples),
                    .floor_peak_g = recorded->size() * peak_acceleration(base_motion(*recorded))};
}

std::vector<UsedGroundMotion> used_ground_motions(const std::vector<Condition>& conditions) {
  std::vector<UsedGroundMotion> all;
  std::size_t place = 0;
  for (const Condition& condition : conditions) {
    const auto* recorded = std::get_if<Recorded>(&condition.scene.excitation);
    if (recorded == nullptr || !recorded->ground_motion || recorded->ground_motion->name.empty()) continue;
    const double scale = recorded->size();
    const GroundMotion& motion = *recorded->ground_motion;
    if (all.empty() || all[place].facts.file != motion.name ||
        all[place].facts.component.value_or("") != motion.component) {
      const GroundMotionFacts facts = facts_of(motion);
      const auto known = std::ranges::find(all, facts, &UsedGroundMotion::facts);
      place = static_cast<std::size_t>(known - all.begin());
      if (known == all.end()) all.push_back({.facts = facts, .least_scale = scale, .largest_scale = scale});
    }
    all[place].least_scale = std::min(all[place].least_scale, scale);
    all[place].largest_scale = std::max(all[place].largest_scale, scale);
  }
  return all;
}

std::string last_part(const std::string& path) { return path.substr(path.rfind('/') + 1); }

namespace {

constexpr std::size_t most_kinds = 5;

/// `time step: 0.005 to 0.02 s; duration: 20 to 60 s`; the step of uneven times is the mean.
std::string times_in_words(const std::vector<UsedGroundMotion>& motions) {
  NumberRange steps, durations;
  for (const UsedGroundMotion& used : motions) {
    const double mean = used.facts.duration_s / static_cast<double>(std::max<std::uint64_t>(used.facts.samples, 2) - 1);
    steps.add(used.facts.time_step_s.value_or(mean));
    durations.add(used.facts.duration_s);
  }
  return "time step: " + steps.text() + " s; duration: " + durations.text() + " s";
}

}  // namespace

std::vector<std::string> ground_motion_lines(const std::vector<UsedGroundMotion>& motions) {
  if (motions.empty()) return {};
  std::vector<std::pair<std::string, std::vector<std::string>>> kinds;  // how files were read, and their names
  for (const UsedGroundMotion& used : motions) {
    const std::string words = reading_in_words(used.facts);
    auto known = std::ranges::find(kinds, words, &std::pair<std::string, std::vector<std::string>>::first);
    if (known == kinds.end()) known = kinds.insert(kinds.end(), {words, {}});
    known->second.push_back(last_part(used.facts.file));
  }
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(kinds.size(), most_kinds); ++i) {
    const auto& [words, names] = kinds[i];
    const std::string who =
        names.size() == 1 ? names.front() : std::to_string(names.size()) + " files, " + names.front() + " ...";
    lines.push_back("ground motion: " + who + ": " + words);
  }
  if (kinds.size() > most_kinds) {
    lines.push_back("ground motion: " + std::to_string(kinds.size() - most_kinds) +
                    " more ways of reading: report.json");
  }
  lines.push_back(times_in_words(motions));
  const auto least = std::ranges::min_element(motions, {}, &UsedGroundMotion::least_scale);
  const auto largest = std::ranges::max_element(motions, {}, &UsedGroundMotion::largest_scale);
  const std::string low = significant(least->least_scale, 3), high = significant(largest->largest_scale, 3);
  lines.push_back("scale factor: " + (low == high ? low
                                                  : "from " + low + " (" + last_part(least->facts.file) + ") to " +
                                                        high + " (" + last_part(largest->facts.file) + ')'));
  return lines;
}

std::optional<Finding> far_scaled(const std::vector<UsedGroundMotion>& motions) {
  const auto is_far = [](const UsedGroundMotion& used) { return used.largest_scale > largest_usual_scale; };
  const auto count = std::ranges::count_if(motions, is_far);
  if (count == 0) return std::nullopt;
  const auto largest = std::ranges::max_element(motions, {}, &UsedGroundMotion::largest_scale);
  return Finding{.name = "scale factors of the records",
                 .text = "scale factors above " + significant(largest_usual_scale, 2) + " for " +
                         std::to_string(count) + " of " + counted(motions.size(), "ground motion") + " (" +
                         last_part(largest->facts.file) + ": up to " + significant(largest->largest_scale, 3) +
                         "): a factor does not make the record of a strong earthquake of a weak one",
                 .remedy = "give stronger records"};
}

std::string ground_motion_text(const Experiment& experiment) {
  const std::vector<UsedGroundMotion> motions = used_ground_motions(experiment.conditions);
  std::string text;
  for (const std::string& line : ground_motion_lines(motions)) text += line + '\n';
  if (const auto far = far_scaled(motions)) text += warning_lines({*far});
  return text;
}

}  // namespace rocking
