#include "rocking/study/study.hpp"

#include <algorithm>

#include "rocking/base/number_text.hpp"

namespace rocking {
namespace {

std::string word_of(const Json& value) {
  return value.is_number() ? base::shortest(value.get<double>()) : value.get<std::string>();
}

}  // namespace

std::string Study::command() const {
  std::string command(name);
  std::ranges::replace(command, '_', '-');
  return command;
}

std::string flags_of(const StructType& fields, const void* question) {
  std::string text;
  for (const Field& field : fields.fields()) {
    const Json value = field.json(question);
    const std::string flag = ' ' + std::string(field.flag.names.substr(0, field.flag.names.find(',')));
    if (flag == " " || value.is_null()) continue;
    if (value.is_boolean()) {
      text += value.get<bool>() ? flag : "";
      continue;
    }
    std::vector<std::string> words;
    for (const Json& each : value.is_array() ? value : Json::array({value})) {
      const bool is_joined = field.flag.kind == FlagKind::commas && !words.empty();
      if (is_joined) {
        words.back() += ',' + word_of(each);
      } else {
        words.push_back(word_of(each));
      }
    }
    for (const std::string& word : words) text += flag + ' ' + shell_word(word);
  }
  return text;
}

}  // namespace rocking
