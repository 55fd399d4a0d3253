#include "support/json_schema.hpp"

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "rocking/studies/studies.hpp"

namespace rocking::support {

std::string objections(std::string_view schema_name, std::string_view text) {
  const auto schema_document = nlohmann::json::parse(schema_of(schema_name).value());
  const auto document = nlohmann::json::parse(text);
  valijson::Schema schema;
  valijson::SchemaParser parser;
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_document), schema);
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), &results)) return {};
  std::string lines;
  for (const auto& result : results) {
    for (const std::string& part : result.context) lines += part;
    lines += ": " + result.description + '\n';
  }
  return lines.empty() ? "refused" : lines;
}

}  // namespace rocking::support
