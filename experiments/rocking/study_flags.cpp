#include "study_flags.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "rocking/base/number_text.hpp"
#include "usage.hpp"

namespace rocking::program {
namespace {

/// The JSON type of a value: `number`, `integer`, `string`, `boolean`, `array`; that of an optional value is the value's.
std::string kind_of(const Json& schema) {
  if (schema.contains("anyOf")) return kind_of(schema["anyOf"][0]);
  if (!schema.contains("type")) return "string";
  const Json& type = schema["type"];
  return type.is_array() ? type[0].get<std::string>() : type.get<std::string>();
}

void set(const Field& field, const Json& value, void* question) {
  std::vector<base::Problem> problems;
  const Rule rule = field.flag.kind == FlagKind::words ? Rule{} : field.rule;
  field.read(value, {.pointer = "", .rule = rule, .problems = &problems}, question);
  if (!problems.empty()) {
    const auto& [place, wrong, reason, remedy, where] = problems.front();
    throw CLI::ValidationError(std::string(field.flag.names),
                               value.dump() + ": " + reason + (remedy.empty() ? "" : "; " + remedy));
  }
}

CLI::Validator whole_numbers_of(const Rule& rule) {
  const auto whole = [](double number) { return static_cast<std::uint64_t>(number); };
  constexpr std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
  return whole_number(whole(rule.least.value_or(0.0)), rule.most ? whole(*rule.most) : largest);
}

template <class Value>
CLI::Option* add_value(CLI::App& command, const Field& field, void* question) {
  return command.add_option_function<Value>(
      std::string(field.flag.names), [&field, question](const Value& value) { set(field, Json(value), question); },
      std::string(field.sentence));
}

/// The texts that a schema allows; empty: any.
std::vector<std::string> choices_in(const Json& schema) {
  if (schema.contains("anyOf")) return choices_in(schema["anyOf"][0]);
  return schema.contains("enum") ? schema["enum"].get<std::vector<std::string>>() : std::vector<std::string>{};
}

void add_to_help(CLI::Option& option, const std::string& words) {
  option.description(option.get_description() + "; " + words);
}

/// Help tells no bound that is beyond any use.
void tell_bounds(CLI::Option& option, Rule rule) {
  constexpr double beyond_use = 1e15;
  if (rule.most && *rule.most > beyond_use) rule.most.reset();
  if (const std::string bounds = bounds_in_words(rule); !bounds.empty()) add_to_help(option, bounds);
}

void check_by_rule(CLI::Option& option, const std::string& kind, const Json& schema, const Rule& rule) {
  if (const auto choices = choices_in(schema); !choices.empty()) {
    option.check(one_of(choices));
  } else if (kind == "integer") {
    option.check(whole_numbers_of(rule));
    tell_bounds(option, rule);
  } else if (kind == "number" && (rule.least || rule.above || rule.most || rule.below)) {
    if (rule.least && rule.most) option.check(number(*rule.least, *rule.most));
    tell_bounds(option, rule);
  }
}

CLI::Option* add_list(CLI::App& command, const Field& field, const std::string& item, void* question) {
  CLI::Option* option = item == "string" ? add_value<std::vector<std::string>>(command, field, question)
                                         : add_value<std::vector<double>>(command, field, question);
  if (field.flag.kind == FlagKind::words) option->delimiter(',');
  if (field.flag.count > 0) option->expected(field.flag.count);
  if (field.flag.kind == FlagKind::commas || field.flag.kind == FlagKind::repeated) {
    option->expected(1)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
  if (field.flag.kind == FlagKind::commas) option->delimiter(',');
  return option;
}

std::string written(const Json& value) {
  if (value.is_number_float()) return base::shortest(value.get<double>());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// As the flag would give it; empty for none.
std::string default_of(const Field& field, const void* question) {
  const Json value = field.json(question);
  if (value.is_null() || value.is_boolean() || value.is_array()) return "";
  return written(value) + (field.flag.kind == FlagKind::duration ? "s" : "");
}

/// A list is too long for the column of the flags.
void tell_default_list(CLI::Option& option, const Json& values) {
  std::string words;
  for (const Json& value : values) words += ' ' + written(value);
  if (!words.empty()) add_to_help(option, "default:" + words);
}

CLI::Option* add_flag(CLI::App& command, const Field& field, void* question) {
  const FlagKind flag = field.flag.kind;
  if (flag == FlagKind::on || flag == FlagKind::off) {
    const auto set_it = [&field, question, flag] { set(field, Json(flag == FlagKind::on), question); };
    return command.add_flag_callback(std::string(field.flag.names), set_it, sentence_of_flag(field));
  }
  const Json schema = field.type->schema(field.rule);
  const std::string kind = kind_of(schema);
  CLI::Option* option = nullptr;
  if (kind == "array") {
    const std::string item = kind_of(schema["items"]);
    option = add_list(command, field, item, question);
    if (flag != FlagKind::words) check_by_rule(*option, item, schema["items"], field.rule);
    tell_default_list(*option, field.json(question));
  } else if (flag == FlagKind::duration) {
    option = add_value<double>(command, field, question)->transform(duration());
  } else {
    option = kind == "integer"  ? add_value<std::uint64_t>(command, field, question)
             : kind == "number" ? add_value<double>(command, field, question)
                                : add_value<std::string>(command, field, question);
    check_by_rule(*option, kind, schema, field.rule);
  }
  return option->type_name(std::string(field.flag.letter))->default_str(default_of(field, question));
}

}  // namespace

void add_flags(CLI::App& command, const StructType& fields, void* question) {
  std::vector<std::pair<CLI::Option*, const Field*>> options;
  for (const Field& field : fields.fields()) {
    if (!field.flag.names.empty()) options.emplace_back(add_flag(command, field, question), &field);
  }
  for (const auto& [option, of] : options) {
    const Field& field = *of;
    if (field.flag.is_required) option->required();
    if (!field.flag.needs.empty()) option->needs(command.get_option(std::string(field.flag.needs)));
    if (field.flag.excludes.empty()) continue;
    option->excludes(command.get_option(std::string(field.flag.excludes)));
    add_to_help(*option, "not with " + std::string(field.flag.excludes));
  }
}

std::vector<std::filesystem::path> new_files(const StructType& fields, const void* question) {
  std::vector<std::filesystem::path> files;
  for (const Field& field : fields.fields()) {
    if (field.flag.kind != FlagKind::new_file) continue;
    if (const Json path = field.json(question); path.is_string()) files.emplace_back(path.get<std::string>());
  }
  return files;
}

base::InputError with_flags(const base::InputError& error, const StructType& fields) {
  return with_names(error, fields.fields(), [](const Field& field) {
    return std::string(field.flag.names.substr(0, field.flag.names.find(',')));
  });
}

}  // namespace rocking::program
