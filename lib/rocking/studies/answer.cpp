#include <algorithm>
#include <iterator>
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
    } else if (field->flag.kind == FlagKind::off && value.is_boolean()) {
      field->read(!value.get<bool>(), place, asked);
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

/// The texts of the caller, and files.
FileSource files_of(const StudySubject& about) {
  return [&texts = about.texts, read = files_seen_from("")](const std::string& name, std::size_t most) {
    const auto text = texts.find(name);
    return text == texts.end() ? read(name, most) : text->second;
  };
}

Json keywords_of(const Study& study) {
  Json keywords = Json::array();
  const std::shared_ptr<void> question = study.of_call();
  for (const Field& field : study.question->fields()) {
    if (keyword_of(field).empty()) continue;
    keywords.push_back({{"keyword", keyword_of(field)},
                        {"sentence", sentence_of_flag(field)},
                        {"is_required", field.flag.is_required},
                        {"is_path", field.flag.letter == "FILE" || field.flag.letter == "DIR"},
                        {"is_written", field.flag.kind == FlagKind::new_file},
                        {"schema", field.type->schema(field.rule)},
                        {"default", field.flag.kind == FlagKind::off ? Json(!field.json(question.get()).get<bool>())
                                                                     : field.json(question.get())}});
  }
  return keywords;
}

}  // namespace

StudyAnswer answer(std::string_view study, std::string_view question, const StudySubject& about, const Clocks& clocks,
                   const Execution& execution, const Provenance& provenance) {
  const Study& asked = study_named(study);
  const std::shared_ptr<void> wanted = asked.of_call();
  read_question(*asked.question, parse_json(std::string(question)), wanted.get());
  Subject subject{.experiment = about.experiment, .folder = about.files, .files = files_of(about)};
  for (std::size_t i = 0; i < about.runs.size(); ++i) {
    subject.runs.push_back({.folder = about.run_names.at(i), .stored = about.runs[i]});
  }
  try {
    asked.check(subject, wanted.get());
    if (!about.earlier.empty()) asked.resume(subject, wanted.get(), parse_json(about.earlier));
    Answer found = asked.find(subject, wanted.get(),
                              {.execution = execution,
                               .elapsed_seconds = clocks.elapsed_seconds,
                               .processor_seconds = clocks.processor_seconds,
                               .provenance = provenance});
    if (found.write_more) std::ranges::move(found.write_more(execution).notices, std::back_inserter(found.notices));
    return {.document = std::move(found.document), .notices = std::move(found.notices)};
  } catch (const base::InputError& error) {
    throw with_names(error, asked.question->fields(), keyword_of);
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
                    {"takes_seed", study->takes_seed},
                    {"realisations", study->realisations},
                    {"kept", study->kept},
                    {"has_progress", !study->progress.empty()},
                    {"document", study->document.title()},
                    {"keywords", keywords_of(*study)}});
  }
  return list.dump(2) + '\n';
}

}  // namespace rocking
