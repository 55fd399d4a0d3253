#include <algorithm>
#include <cctype>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/input/read_experiment.hpp"
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

/// The value of a keyword of which a question says nothing.
Json usual_value(const Field& field, const void* usual) {
  const Json value = field.json(usual);
  return field.flag.kind == FlagKind::off ? Json(!value.get<bool>()) : value;
}

/// Refuses what a command line refuses by the names of its flags: one that is missing, that needs or excludes another one, or
/// has another number of words.
void check_keywords(const StructType& fields, const Json& question, const void* usual) {
  std::vector<base::Problem> problems;
  const auto is_given = [&](const Field& field) {
    const auto said = question.find(keyword_of(field));
    return said != question.end() && !said->is_null() && *said != usual_value(field, usual);
  };
  const auto other = [&fields](std::string_view flag) {
    const auto& all = fields.fields();
    return std::ranges::find_if(
        all, [flag](const Field& each) { return each.flag.names.substr(0, each.flag.names.find(',')) == flag; });
  };
  for (const Field& field : fields.fields()) {
    const std::string keyword = keyword_of(field);
    const Flag& flag = field.flag;
    if (keyword.empty()) continue;
    if (!is_given(field)) {
      if (flag.is_required) problems.push_back({keyword, "", "is missing", "give it"});
      continue;
    }
    const Json& value = question[keyword];
    if (!flag.needs.empty() && !is_given(*other(flag.needs))) {
      const std::string needed = keyword_of(*other(flag.needs));
      problems.push_back({keyword, brief(value), "needs " + needed, "omit it, or give both"});
    }
    if (!flag.excludes.empty() && is_given(*other(flag.excludes))) {
      const std::string excluded = keyword_of(*other(flag.excludes));
      problems.push_back({keyword, brief(value), "excludes " + excluded, "give one of them"});
    }
    if (flag.count > 0 && value.size() != static_cast<std::size_t>(flag.count)) {
      problems.push_back({keyword, brief(value), "must be " + std::to_string(flag.count) + " numbers", ""});
    }
  }
  if (!problems.empty()) throw base::InputError(std::move(problems));
}

/// Throws unless a study has as many runs as it is about.
void check_runs(SubjectKind kind, const StudySubject& about) {
  const std::size_t runs = about.runs.size();
  const bool is_enough = kind == SubjectKind::two_runs ? runs == 2 : kind != SubjectKind::runs || runs > 0;
  if (is_enough && about.run_names.size() == runs) return;
  throw base::InputError(
      {"source", std::to_string(runs) + (runs == 1 ? " run" : " runs"),
       kind == SubjectKind::two_runs ? "must be two runs" : "must be at least one run, each with its name",
       "give a finished run, or the folder of one"});
}

/// The texts of the caller, and files.
FileSource files_of(const StudySubject& about) {
  return [&texts = about.texts, read = files_seen_from("")](const std::string& name, std::size_t most) {
    const auto text = texts.find(name);
    return text == texts.end() ? read(name, most) : text->second;
  };
}

/// The first sentence of the first line of a table, which is its answer, with a capital letter and a full stop.
std::string sentence_in(const std::string& table) {
  std::string text = table.substr(0, std::min(table.find('\n'), table.find(". ")));
  text.resize(text.find_last_not_of(". ") + 1);
  if (text.empty()) return text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + '.';
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
                        {"default", usual_value(field, question.get())}});
  }
  return keywords;
}

}  // namespace

StudyAnswer answer(std::string_view study, std::string_view question, const StudySubject& about,
                   const Execution& execution, const Provenance& provenance) {
  const Study& asked = study_named(study);
  const std::shared_ptr<void> wanted = asked.of_call();
  const Json said = parse_json(std::string(question));
  read_question(*asked.question, said, wanted.get());
  check_keywords(*asked.question, said, asked.of_call().get());
  check_runs(asked.subject, about);
  if (!about.earlier.empty() && asked.resume == nullptr) {
    throw base::InputError({"resume", "", "is not possible: this study keeps nothing to go on from", "omit it"});
  }
  Subject subject{.experiment = about.experiment, .folder = about.files, .files = files_of(about)};
  for (std::size_t i = 0; i < about.runs.size(); ++i) {
    subject.runs.push_back({.folder = about.run_names[i], .stored = about.runs[i]});
  }
  try {
    asked.check(subject, wanted.get());
    if (!about.earlier.empty()) asked.resume(subject, wanted.get(), parse_json(about.earlier));
    Answer found = asked.find(subject, wanted.get(), {.execution = execution, .provenance = provenance});
    if (found.write_more) std::ranges::move(found.write_more(execution).notices, std::back_inserter(found.notices));
    const std::string sentence = sentence_in(found.table);
    return {.document = std::move(found.document),
            .table = std::move(found.table),
            .sentence = sentence,
            .notices = std::move(found.notices)};
  } catch (const base::InputError& error) {
    throw with_names(error, asked.question->fields(), keyword_of);
  }
}

std::string studies_text() {
  Json list = Json::array();
  for (const Study* study : studies()) {
    list.push_back({{"name", study->name},
                    {"sentence", study->sentence},
                    {"notes", study->python_notes},
                    {"example", study->python_example},
                    {"subject", subject_names[static_cast<std::size_t>(study->subject)]},
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
