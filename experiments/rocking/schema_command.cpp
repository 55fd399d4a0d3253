#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "output.hpp"
#include "rocking/text/schema.hpp"
#include "usage.hpp"

namespace rocking::program {

void add_schema(CLI::App& app, Action& action) {
  const auto name = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("schema", "Print the JSON Schema of a format");
  command->footer(
      "Example: rocking schema experiment > experiment.schema.json\n"
      "An editor that supports JSON Schema then completes and checks experiment files.");
  std::vector<std::string> names;
  for (const Schema& schema : schemas()) names.emplace_back(schema.name);
  command->add_option("NAME", *name, "Format")->required()->check(one_of(names));
  const auto loudness = std::make_shared<Loudness>();
  add_loudness(*command, *loudness);
  command->final_callback([&action, name, loudness] {
    action = [name] {
      print_result(schema_text(*name).value());
      return ExitCode::done;
    };
  });
}

}  // namespace rocking::program
