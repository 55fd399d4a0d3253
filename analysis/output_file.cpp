#include "analysis/output_file.hpp"

#include "rocking/base/error.hpp"
#include "rocking/text/json.hpp"

namespace rocking::analysis {

Json parsed_output(std::string_view text) {
  std::vector<base::Problem> problems;
  Json output = parse_json(text, problems);
  if (!problems.empty()) throw base::InputError(std::move(problems));
  if (!output.is_object() || !output.contains("format") || !output["format"].is_string()) {
    throw base::InputError({.place = "/format",
                            .value = "",
                            .reason = "is missing: this is not a file that rocking wrote",
                            .remedy = "give the output of `rocking trajectory`, `bifurcation`, `cost --json`, "
                                      "`fragility --json` or `check-normal --json`"});
  }
  return output;
}

std::string format_of(const Json& output) { return output.at("format").get<std::string>(); }

}  // namespace rocking::analysis
