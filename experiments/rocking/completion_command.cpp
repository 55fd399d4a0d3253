#include <memory>
#include <string>

#include "output.hpp"
#include "program.hpp"
#include "usage.hpp"

namespace rocking::program {

void add_completion(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("completion", "Print a script that completes commands, flags and files");
  command->footer(
      "Example: eval \"$(rocking completion bash)\"\n"
      "in ~/.bashrc; the tabulator key then completes the words after `rocking`.");
  const auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "Name of the shell")->required()->check(one_of({"bash"}));
  command->final_callback([&app, &action, shell] {
    action = [&app, shell] {
      print_result(bash_completion(app));
      return ExitCode::done;
    };
  });
}

}  // namespace rocking::program
