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
      "in ~/.bashrc; the tabulator key then completes the words after `rocking`. zsh: source <(rocking completion zsh) "
      "in ~/.zshrc; fish: rocking completion fish | source in ~/.config/fish/config.fish.");
  const auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "Name of the shell")->required()->check(one_of({"bash", "zsh", "fish"}));
  command->final_callback([&app, &action, shell] {
    action = [&app, shell] {
      print_result(completion_script(app, *shell));
      return ExitCode::done;
    };
  });
}

}  // namespace rocking::program
