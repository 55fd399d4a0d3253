#include "rocking/studies/studies.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "rocking/input/read_experiment.hpp"
#include "rocking/output/report.hpp"
#include "rocking/output/trajectory_report.hpp"
#include "rocking/rocking.hpp"
#include "rocking/studies/bifurcation/study.hpp"
#include "rocking/studies/check_normal/study.hpp"
#include "rocking/studies/comparison/study.hpp"
#include "rocking/studies/cost/study.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/studies/infer/study.hpp"
#include "rocking/studies/motion/study.hpp"
#include "rocking/studies/orbits/study.hpp"
#include "rocking/studies/rare/study.hpp"
#include "rocking/studies/threshold/study.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

/// Null: none has this name.
const Document* document_named(std::string_view name) {
  for (const Document* document : documents()) {
    if (name_of(*document) == name) return document;
  }
  return nullptr;
}

}  // namespace

std::vector<const Document*> documents() {
  std::vector<const Document*> all{&report_document(), &trajectory_document()};
  for (const Study* study : studies()) all.push_back(&study->document);
  std::ranges::sort(all, {}, &Document::format);
  return all;
}

std::string name_of(const Document& document) {
  const std::string_view format = document.format();
  const std::size_t start = format.find('.') + 1;
  return std::string(format.substr(start, format.find('/') - start));
}

std::vector<std::string> format_names() {
  std::vector<std::string> names{"experiment"};
  for (const Document* document : documents()) names.push_back(name_of(*document));
  return names;
}

std::optional<std::string> keys_of(std::string_view name) {
  if (name == "experiment") return experiment_table();
  const Document* document = document_named(name);
  return document == nullptr ? std::nullopt : std::optional(document->table());
}

std::optional<std::string> schema_of(std::string_view name) {
  if (name == "experiment") return experiment_schema_text();
  const Document* document = document_named(name);
  return document == nullptr ? std::nullopt : std::optional(document->schema_text());
}

std::string schema(std::string_view name) { return schema_of(name).value_or(""); }

std::span<const Study* const> studies() {
  static const std::array all{&comparison_study(), &bifurcation_study(), &orbits_study(), &threshold_study(),
                              &rare_study(),       &infer_study(),       &cost_study(),   &fragility_study(),
                              &motion_study(),     &check_normal_study()};
  return all;
}

std::vector<analysis::Figure> figures_of_studies(const RunShown& run) {
  std::vector<analysis::Figure> figures;
  for (const Study* study : studies()) {
    const std::string document = study->document_of_run == nullptr ? "" : study->document_of_run(run);
    if (document.empty()) continue;
    for (analysis::Figure& figure : study->figures(parse_json(document), {})) figures.push_back(std::move(figure));
  }
  return figures;
}

std::vector<TextFile> table_files(const Study& study, const Json& document, const std::set<std::string>& formats) {
  std::vector<TextFile> files;
  if (study.tables == nullptr) return files;
  for (const auto& [name, table, caption] : study.tables(document)) {
    if (formats.contains("csv")) files.push_back({name + ".csv", to_csv(table)});
    if (formats.contains("latex")) files.push_back({name + ".tex", to_latex(table, caption)});
  }
  return files;
}

std::vector<TextFile> tables_of_studies(const RunShown& run, const std::set<std::string>& formats) {
  std::vector<TextFile> files;
  for (const Study* study : studies()) {
    const std::string document = study->document_of_run == nullptr ? "" : study->document_of_run(run);
    if (document.empty()) continue;
    for (TextFile& file : table_files(*study, parse_json(document), formats)) files.push_back(std::move(file));
  }
  return files;
}

}  // namespace rocking
