#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rocking/api/checks.hpp"
#include "rocking/api/run.hpp"
#include "rocking/base/error.hpp"
#include "rocking/fields/document.hpp"
#include "rocking/figures/figure.hpp"
#include "rocking/look/table.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/text/files.hpp"

/// A study as a value: what is asked, how the answer is found, and how it looks. The program, the module for Python and the
/// documents treat all studies by these values alone.
namespace rocking {

class Store;

/// What is asked contradicts itself, or its subject cannot answer it.
class UnfitQuestion : public base::InputError {
 public:
  /// `place`: key of the question; or of its subject what contradicts it.
  UnfitQuestion(std::string place, std::string value, std::string reason, std::string remedy = "")
      : InputError({std::move(place), std::move(value), std::move(reason), std::move(remedy)}) {}
};

/// What a study is about.
enum class SubjectKind : std::uint8_t {
  none,        ///< what is asked says all
  files,       ///< files that the question names
  experiment,  ///< an experiment file
  runs,        ///< complete runs
  two_runs,    ///< two runs
};
/// Their names, in their order.
inline constexpr std::array<std::string_view, 5> subject_names{"none", "files", "experiment", "runs", "two_runs"};

struct NamedRun {
  std::string folder;  ///< as the caller named it
  StoredRun stored;
};

/// What one call is about.
struct Subject {
  Experiment experiment = {};              ///< of a study about an experiment; valid
  std::filesystem::path folder = ".";      ///< from which the files of the experiment are seen
  FileSource files = files_seen_from("");  ///< that the question names
  std::vector<NamedRun> runs = {};         ///< of a study about runs
};

/// How a question is answered: with the facts and wishes of the caller.
struct Circumstances {
  Execution execution = {};
  Provenance provenance = {};          ///< without the duration
  Extent extent = Extent::one_screen;  ///< of the table
  bool draws = false;                  ///< whether figures are asked for
  /// Of a study that can be resumed: called with what is finished, as a document. Null: a stop gives nothing.
  std::function<void(const std::function<std::string()>& document)> keep = {};
};

enum class AnswerEnd : std::uint8_t {
  complete,
  stopped,  ///< it was asked to stop; the same command with --resume goes on
  refuted,  ///< what was checked is wrong
};

struct TextFile {
  std::string name;
  std::string text;
};

/// What became of files that a study writes after its document.
struct More {
  std::string lines = {};  ///< that say where they are
  bool is_complete = true;
  std::vector<std::string> notices = {};
};

/// What a study has found.
struct Answer {
  std::string document = {};                   ///< JSON text
  std::string table = {};                      ///< for a terminal
  std::vector<TextFile> files = {};            ///< beside the document
  std::vector<analysis::Figure> figures = {};  ///< if they were asked for
  std::vector<std::string> notices = {};
  std::vector<std::string> warnings = {};  ///< that a quiet command omits
  bool is_alone = false;                   ///< whether nothing is printed beside the table
  /// Writes more files, with programs outside. Null: there are none.
  std::function<More(const Execution& execution)> write_more = {};
  AnswerEnd end = AnswerEnd::complete;
};

/// A table for other programs and for publications.
struct StudyTable {
  std::string name;  ///< of its files
  look::Table table;
  std::string caption;  ///< LaTeX
};

/// How a study is checked: with `rocking verify`.
struct StudyVerification {
  RunCheck (*verify)(const std::filesystem::path& folder, std::optional<std::uint64_t> sample,
                     const Execution& execution) = nullptr;  ///< null: it is not
  std::string_view progress = {};                            ///< what progress counts
  std::string_view unit = {};                                ///< what is made again
  std::string_view units_key = {};                           ///< of JSON
  std::string_view and_more = {};                            ///< what is always made again
};

/// A complete run whose page or figures are made.
struct RunShown {
  const Experiment& experiment;
  const Store& store;
  unsigned threads = 1;
  const std::optional<HazardCurve>& hazard;
};

struct Study {
  std::string_view name;                 ///< of the function in Python: `check_normal`
  std::string_view sentence;             ///< what it does
  std::string_view example;              ///< arguments of the command, after its name
  std::string_view text;                 ///< what the example does, in a few sentences
  std::string_view python_notes = {};    ///< of the function in Python, after the sentences of its keywords
  std::string_view python_example = {};  ///< a doctest
  SubjectKind subject = SubjectKind::experiment;
  bool takes_seed = false;             ///< whether `--seed` replaces that of the experiment
  std::string_view realisations{};     ///< what `--realisations` sets; empty: the flag does not exist
  bool has_long_table = false;         ///< whether `--all` prints more
  bool draws = false;                  ///< whether `--figure` draws what was found
  std::string_view progress = {};      ///< what progress counts; empty: there is none
  std::string_view more_notice = {};   ///< of a study that counts something else afterwards
  std::string_view file = {};          ///< the document in the folder of `-o`; empty: there is no such flag
  std::string_view label = "numbers";  ///< precedes its path where it is printed
  bool needs_folder = false;           ///< whether `-o` must be given
  std::string_view kept = {};          ///< what `--resume` goes on from; empty: it cannot
  const Document& document;
  base::Problem without_figures = {};  ///< what is wrong with a document that has no figure
  StudyVerification verification = {};
  bool is_shown_with_run = false;  ///< whether its document, in the folder of a run, has figures on the page of the run

  // The rest follows from the functions of the study (study_of).
  const StructType* question = nullptr;
  /// A question as a command line begins with it, or as a caller in Python does.
  std::shared_ptr<void> (*of_command)() = nullptr;
  std::shared_ptr<void> (*of_call)() = nullptr;
  /// Throws base::InputError where the question does not fit the subject, before any work is done.
  void (*check)(const Subject& subject, void* question) = nullptr;
  Answer (*find)(const Subject& subject, const void* question, const Circumstances& circumstances) = nullptr;
  /// Takes what an earlier call has finished from its document.
  void (*resume)(const Subject& subject, void* question, const Json& earlier) = nullptr;
  /// What progress counts afterwards, where their number is not known; empty: nothing. Null: nothing ever.
  std::string_view (*then)(const void* question) = nullptr;
  /// Names of the files that are written beside the document; null: none.
  std::vector<std::string> (*files)(const Subject& subject) = nullptr;
  /// Those of a document; `others` are drawn in the same call. Empty where it has nothing to draw.
  std::vector<analysis::Figure> (*figures)(const Json& document, std::span<const Json> others) = nullptr;
  /// Of a document; null: none.
  std::vector<StudyTable> (*tables)(const Json& document) = nullptr;
  /// That of a run with a suite of ground motions, whose figures and tables stand beside those of the run; empty: none.
  std::string (*document_of_run)(const RunShown& run) = nullptr;

  /// Name of its command: `check-normal`.
  [[nodiscard]] std::string command() const;
};

/// The flags of the command that asks this question, ` --hazard h.csv --years 1,50`: those whose value is neither empty nor
/// false.
[[nodiscard]] std::string flags_of(const StructType& fields, const void* question);

/// The figures that `draw` makes of what a document holds: `figures_in<cost_document, analysis::cost_figures>`.
template <auto document, auto draw>
[[nodiscard]] std::vector<analysis::Figure> figures_in(const Json& json, std::span<const Json>) {
  return draw(document().read(json));
}

/// The functions of a study whose question is a Question. Those after `find` may be null.
template <class Question>
struct StudyFunctions {
  Question (*of_command)() = nullptr;  ///< null: Question{}
  void (*check)(const Subject& subject, Question& question) = nullptr;
  Answer (*find)(const Subject& subject, const Question& question, const Circumstances& circumstances) = nullptr;
  void (*resume)(const Subject& subject, Question& question, const Json& earlier) = nullptr;
  std::string_view (*then)(const Question& question) = nullptr;
  std::vector<std::string> (*files)(const Subject& subject) = nullptr;
  std::vector<analysis::Figure> (*figures)(const Json& document, std::span<const Json> others) = nullptr;
  std::vector<StudyTable> (*tables)(const Json& document) = nullptr;
  std::string (*document_of_run)(const RunShown& run) = nullptr;
};

/// The study with these functions: `study_of<OrbitsQuestion, functions>({.name = "orbits", ...})`.
template <class Question, const StudyFunctions<Question>& functions>
[[nodiscard]] Study study_of(Study facts) {
  facts.question = &fields_of(static_cast<const Question*>(nullptr));
  facts.of_call = []() -> std::shared_ptr<void> { return std::make_shared<Question>(); };
  facts.of_command = facts.of_call;
  if constexpr (functions.of_command != nullptr) {
    facts.of_command = []() -> std::shared_ptr<void> { return std::make_shared<Question>(functions.of_command()); };
  }
  facts.check = [](const Subject& subject, void* question) {
    functions.check(subject, *static_cast<Question*>(question));
  };
  facts.find = [](const Subject& subject, const void* question, const Circumstances& circumstances) {
    return functions.find(subject, *static_cast<const Question*>(question), circumstances);
  };
  if constexpr (functions.resume != nullptr) {
    facts.resume = [](const Subject& subject, void* question, const Json& earlier) {
      functions.resume(subject, *static_cast<Question*>(question), earlier);
    };
  }
  if constexpr (functions.then != nullptr) {
    facts.then = [](const void* question) { return functions.then(*static_cast<const Question*>(question)); };
  }
  facts.files = functions.files;
  facts.figures = functions.figures;
  facts.tables = functions.tables;
  facts.document_of_run = functions.document_of_run;
  return facts;
}

}  // namespace rocking
