#include <stdexcept>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/rocking.hpp"
#include "rocking/studies/studies.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

const Study& study_named(std::string_view name) {
  for (const Study* study : studies()) {
    if (study->name == name) return *study;
  }
  throw std::invalid_argument(std::string(name) + ": there is no study of this name");
}

/// Sets what a question says. Throws base::InputError with every keyword that is unknown or wrong.
void read_question(const StructType& fields, const Json& question, void* asked) {
  std::vector<base::Problem> problems;
  const ReadingPlace place{.pointer = "", .problems = &problems};
  for (const auto& [keyword, value] : question.items()) {
    const Field* field = nullptr;
    for (const Field& each : fields.fields()) {
      if (keyword_of(each) == keyword) field = &each;
    }
    if (field == nullptr) {
      place.at(keyword).reject(value, "is not a keyword of this question");
    } else if (!value.is_null() || !field->json(asked).is_null()) {
      field->read(value, {.pointer = keyword, .rule = field->rule, .problems = &problems}, asked);
    }
  }
  if (!problems.empty()) throw base::InputError(std::move(problems));
}

std::string_view name_of(SubjectKind kind) {
  switch (kind) {
    case SubjectKind::none: return "none";
    case SubjectKind::files: return "files";
    case SubjectKind::experiment: return "experiment";
    case SubjectKind::runs: return "runs";
    case SubjectKind::two_runs: return "two_runs";
  }
  return "";
}

Json keywords_of(const Study& study) {
  Json keywords = Json::array();
  const std::shared_ptr<void> question = study.of_call();
  for (const Field& field : study.question->fields()) {
    if (keyword_of(field).empty()) continue;
    keywords.push_back({{"keyword", keyword_of(field)},
                        {"sentence", field.sentence},
                        {"is_required", field.flag.is_required},
                        {"is_path", field.flag.letter == "FILE" || field.flag.letter == "DIR"},
                        {"schema", field.type->schema(field.rule)},
                        {"default", field.json(question.get())}});
  }
  return keywords;
}

}  // namespace

std::string answer(std::string_view study, std::string_view question, const StudySubject& about, const Clocks& clocks,
                   const Execution& execution, const Provenance& provenance) {
  const Study& asked = study_named(study);
  const std::shared_ptr<void> wanted = asked.of_call();
  read_question(*asked.question, parse_json(std::string(question)), wanted.get());
  Subject subject{.experiment = about.experiment, .folder = about.files};
  for (std::size_t i = 0; i < about.runs.size(); ++i) {
    const std::string which = about.runs.size() == 1 ? "the run" : i == 0 ? "the first run" : "the second run";
    subject.runs.push_back({.folder = which, .stored = about.runs[i]});
  }
  try {
    asked.check(subject, wanted.get());
    return asked
        .find(subject, wanted.get(),
              {.execution = execution,
               .elapsed_seconds = clocks.elapsed_seconds,
               .processor_seconds = clocks.processor_seconds,
               .provenance = provenance})
        .document;
  } catch (const UnfitQuestion& error) {
    throw base::InputError({.place = error.place().empty() ? std::string(study) : error.place(),
                            .value = "",
                            .reason = error.what(),
                            .remedy = "",
                            .where = {}});
  }
}

std::string studies_text() {
  Json list = Json::array();
  for (const Study* study : studies()) {
    list.push_back({{"name", study->name},
                    {"sentence", study->sentence},
                    {"notes", study->python_notes},
                    {"example", study->python_example},
                    {"subject", name_of(study->subject)},
                    {"has_progress", !study->progress.empty()},
                    {"document", study->document.title()},
                    {"keywords", keywords_of(*study)}});
  }
  return list.dump(2) + '\n';
}

}  // namespace rocking
