#include <memory>
#include <string>
#include <vector>

#include "output.hpp"
#include "program.hpp"
#include "rocking/rocking.hpp"
#include "rocking/studies/studies.hpp"
#include "usage.hpp"

namespace rocking::program {
namespace {

constexpr const char* list_of_studies = "studies";

}  // namespace

void add_schema(CLI::App& app, Action& action) {
  const auto name = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("schema", "Print the JSON Schema of a format");
  command->footer(
      "Example: rocking schema experiment > experiment.schema.json\n"
      "An editor that supports JSON Schema then completes and checks experiment files.");
  std::vector<std::string> names = format_names();
  names.emplace_back(list_of_studies);
  command->add_option("NAME", *name, "Format; studies: what each study is asked")->required()->check(one_of(names));
  const auto as_table = std::make_shared<bool>(false);
  command->add_flag("--keys", *as_table, "Print a table of the keys and what they mean, in Markdown");
  const auto loudness = std::make_shared<Loudness>();
  add_loudness(*command, *loudness);
  command->final_callback([&action, name, as_table, loudness] {
    action = [name, as_table] {
      if (*as_table && !keys_of(*name)) throw UsageError("schema " + *name + ": there is no table of its keys");
      print_result(*as_table ? *keys_of(*name) : *name == list_of_studies ? studies_text() : *schema_of(*name));
      return ExitCode::done;
    };
  });
}

}  // namespace rocking::program
