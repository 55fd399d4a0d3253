#include <memory>
#include <string>

#include "commands.hpp"
#include "output.hpp"
#include "rocking/output/documents.hpp"
#include "usage.hpp"

namespace rocking::program {

void add_schema(CLI::App& app, Action& action) {
  const auto name = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("schema", "Print the JSON Schema of a format");
  command->footer(
      "Example: rocking schema experiment > experiment.schema.json\n"
      "An editor that supports JSON Schema then completes and checks experiment files.");
  command->add_option("NAME", *name, "Format")->required()->check(one_of(format_names()));
  const auto as_table = std::make_shared<bool>(false);
  command->add_flag("--keys", *as_table, "Print a table of the keys and what they mean, in Markdown");
  const auto loudness = std::make_shared<Loudness>();
  add_loudness(*command, *loudness);
  command->final_callback([&action, name, as_table, loudness] {
    action = [name, as_table] {
      if (*as_table && !keys_of(*name)) throw UsageError("schema " + *name + ": there is no table of its keys");
      print_result(*as_table ? *keys_of(*name) : *schema_of(*name));
      return ExitCode::done;
    };
  });
}

}  // namespace rocking::program
