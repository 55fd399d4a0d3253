#include "rocking/input/check_document.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "rocking/input/describe_experiment.hpp"
#include "rocking/text/schema.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_schema_problems = 20;

/// Every number that we write is smaller. Larger ones overflow whole numbers, and the axes of figures.
constexpr double largest_number = 1e18;

/// A value in the document and where it stands.
struct ValueAt {
  std::string pointer;
  const Json* value;
};

/// The place that the validator calls `<root>`, `[key]`, `[index]`, ... ; as much of it as exists.
ValueAt value_at(const Json& document, const std::string& root, const std::vector<std::string>& context) {
  ValueAt place{.pointer = root, .value = &document};
  for (std::size_t i = 1; i < context.size(); ++i) {
    const std::string key = context[i].substr(1, context[i].size() - 2);
    if (place.value->is_object() && place.value->contains(key)) {
      place.value = &place.value->at(key);
    } else if (place.value->is_array() && !key.empty() &&
               std::ranges::all_of(key, [](char c) { return '0' <= c && c <= '9'; }) &&
               std::stoul(key) < place.value->size()) {
      place.value = &place.value->at(std::stoul(key));
    } else {
      break;
    }
    place.pointer = child_pointer(place.pointer, key);
  }
  return place;
}

std::string without_full_stop(std::string text) {
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
  return text;
}

/// The validator tells for each value that contains a bad one that it is bad too: only the innermost are of use.
void keep_innermost(Problems& found) {
  Problems innermost;
  for (const base::Problem& problem : found) {
    const auto is_within = [&problem](const base::Problem& other) {
      return other.place.size() > problem.place.size() && other.place.starts_with(problem.place + '/');
    };
    const auto is_same = [&problem](const base::Problem& other) { return other.place == problem.place; };
    if (std::ranges::any_of(found, is_within) || std::ranges::any_of(innermost, is_same)) continue;
    innermost.push_back(problem);
  }
  found = std::move(innermost);
}

void refuse_huge_numbers(const Json& value, const std::string& place, Problems& problems) {
  if (problems.size() >= most_schema_problems) return;
  if (value.is_structured()) {
    for (const auto& [key, part] : value.items()) {
      if (part.is_structured()) {
        refuse_huge_numbers(part, child_pointer(place, key), problems);
      } else if (part.is_number_float() && !(std::abs(part.get<double>()) <= largest_number)) {
        problems.push_back({child_pointer(place, key), brief(part),
                            "exceeds 1e18 in absolute value, which does not occur in files of rocking", ""});
      }
    }
  }
}

}  // namespace

void check_document(const Json& document, std::string_view schema_name, const std::string& place, Problems& problems) {
  constexpr std::size_t most_errors = 400;  // of the validator, which has no bound of its own
  const nlohmann::json schema_document = nlohmann::json::parse(
      schema_name == "experiment" ? experiment_schema_text() : std::string(schema_text(schema_name).value()));
  const nlohmann::json copy = document;  // the validator knows no other kind of document
  valijson::Schema schema;
  valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_document), schema);
  valijson::ValidationResults results;
  const bool valid = valijson::Validator().validate(schema, valijson::adapters::NlohmannJsonAdapter(copy), &results);
  Problems found;
  if (!valid) {
    for (const auto& error : results) {
      if (found.size() == most_errors) break;
      const ValueAt at = value_at(document, place, error.context);
      found.push_back({at.pointer.empty() ? "/" : at.pointer, brief(*at.value),
                       "does not conform to the schema: " + without_full_stop(error.description),
                       "see `rocking schema " + std::string(schema_name) + "`"});
    }
  }
  keep_innermost(found);
  if (!valid && found.empty()) found.push_back({place, "", "does not conform to the schema", ""});
  refuse_huge_numbers(document, place, found);
  if (found.size() > most_schema_problems) found.resize(most_schema_problems);
  problems.insert(problems.end(), found.begin(), found.end());
}

}  // namespace rocking
