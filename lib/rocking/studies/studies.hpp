#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/fields/document.hpp"
#include "rocking/figures/figure.hpp"
#include "rocking/figures/trajectory_file.hpp"
#include "rocking/study/study.hpp"

/// The list of the studies, and of the files that rocking reads and writes. Who adds a study adds a line to studies.cpp, and
/// its folder to CMakeLists.txt.
namespace rocking {

/// Those that rocking writes.
[[nodiscard]] std::vector<const Document*> documents();

/// The part of a format between `rocking.` and `/1`: `comparison`.
[[nodiscard]] std::string name_of(const Document& document);

/// Names of all formats, for `schema_of`.
[[nodiscard]] std::vector<std::string> format_names();

/// JSON Schema (draft 07) of a format, as in reports/schemas; absent if there is none of this name.
[[nodiscard]] std::optional<std::string> schema_of(std::string_view name);

/// Its keys as a table in Markdown, as in lib/docs/formats.md; absent likewise.
[[nodiscard]] std::optional<std::string> keys_of(std::string_view name);

/// All studies, in the order of `rocking --help`.
[[nodiscard]] std::span<const Study* const> studies();

/// The figures that studies add to those of a run with a suite of ground motions.
[[nodiscard]] std::vector<analysis::Figure> figures_of_studies(const RunShown& run);

/// The tables of a document of a study in these formats (`csv`, `latex`).
[[nodiscard]] std::vector<TextFile> table_files(const Study& study, const Json& document,
                                                const std::set<std::string>& formats);
/// Those that studies add to those of a run with a suite of ground motions.
[[nodiscard]] std::vector<TextFile> tables_of_studies(const RunShown& run, const std::set<std::string>& formats);

}  // namespace rocking

namespace rocking::analysis {

/// A file that a command of rocking wrote or printed.
struct OutputFile {
  std::string path;
  std::string text;
};

/// The figures of the outputs of `rocking trajectory`, `bifurcation`, `cost --json`, `fragility --json`,
/// `rare`, `infer`, `threshold` and `check-normal --json`. Each trajectory with a history has `time_history`; several of them also
/// have `responses`; all trajectories together have `poincare`. The other outputs have their own figures. Repeated
/// names are numbered. Throws base::InputError with the path of a file that is none of these.
[[nodiscard]] std::vector<Figure> output_figures(const std::vector<OutputFile>& files, const Window& window);

/// The tables of files that output_figures draws, as CSV and LaTeX.
[[nodiscard]] std::vector<TextFile> output_tables(const std::vector<OutputFile>& files);

}  // namespace rocking::analysis
