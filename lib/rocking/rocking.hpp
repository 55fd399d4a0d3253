#pragma once

/// \file
/// The interface of the library: read, run, look.
///
///     const rocking::Experiment experiment = rocking::read_experiment("mine.json");
///     const rocking::RunResult run = rocking::run(experiment, {.threads = 4});
///     for (const auto& [mode, probability] : run.result->conditions[0].modes) {
///       std::cout << rocking::name_of(mode) << ' ' << probability.estimate << '\n';
///     }
///
/// Stable between patch versions: what these headers declare in namespace rocking, and the structs that they return.
/// Whatever else is installed with them are their details.
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/api/checks.hpp"
#include "rocking/api/experiment.hpp"
#include "rocking/api/run.hpp"
#include "rocking/api/trajectory.hpp"
#include "rocking/base/error.hpp"
#include "rocking/studies/bifurcation/question.hpp"
#include "rocking/studies/check_normal/question.hpp"
#include "rocking/studies/comparison/question.hpp"
#include "rocking/studies/cost/question.hpp"
#include "rocking/studies/fragility/question.hpp"
#include "rocking/studies/infer/question.hpp"
#include "rocking/studies/motion/question.hpp"
#include "rocking/studies/orbits/question.hpp"
#include "rocking/studies/rare/question.hpp"
#include "rocking/studies/threshold/question.hpp"

namespace rocking {

/// What a study is asked about: an experiment, or runs.
struct StudySubject {
  Experiment experiment = {};
  std::filesystem::path files = ".";  ///< folder from which the files of the experiment are seen
  std::vector<StoredRun> runs = {};
  std::vector<std::string> run_names = {};        ///< as problems and tables name the runs, in their order
  std::map<std::string, std::string> texts = {};  ///< by name: files that the question names and that are not read
  std::string earlier = {};                       ///< document from which a study goes on, such as `rare`; empty: none
};

/// The answer of a study.
struct StudyAnswer {
  std::string document;              ///< JSON text, with the bytes that the program writes
  std::string table;                 ///< what the program prints
  std::string sentence;              ///< its first one: the answer
  std::vector<std::string> notices;  ///< what it says beside that
};

/// The answer of any study. `study`: its name, as `check_normal`. `question`: a JSON object of keywords, as studies_text()
/// lists them; absent ones have their default. Throws base::InputError with the keyword where a question is wrong or does
/// not fit its subject, base::Stopped if it is asked to stop, and std::invalid_argument for a study that does not exist.
[[nodiscard]] ROCKING_API StudyAnswer answer(std::string_view study, std::string_view question,
                                             const StudySubject& subject, const Execution& execution = {},
                                             const Provenance& provenance = {});

/// The studies as JSON text: name, sentence, subject, document, whether a seed and what number of realisations may replace
/// those of an experiment, and the keywords of a question with their sentence, schema and default.
[[nodiscard]] ROCKING_API std::string studies_text();

/// The JSON Schema (draft 07) of a format: `experiment`, `report`, ... ; empty where there is none of this name.
[[nodiscard]] ROCKING_API std::string schema(std::string_view name);

}  // namespace rocking
