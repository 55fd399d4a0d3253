#pragma once

#include <memory>
#include <string>
#include <vector>

#include "campaign.hpp"
#include "drawing.hpp"
#include "machine.hpp"
#include "rocking/study/study.hpp"
#include "study_file.hpp"

namespace rocking::program {

/// A study as it is asked on a command line.
struct StudyCommand {
  explicit StudyCommand(const Study& asked)
      : study(asked), question(asked.of_command()), file(std::string(asked.file), std::string(asked.label)) {}

  const Study& study;
  std::string experiment;
  std::vector<std::string> folders;
  std::shared_ptr<void> question;
  StudyFile file;
  std::string figures;  ///< folder; empty: nothing is drawn
  StyleRequest style;
  Overrides overrides;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
};

/// Finds the answer, prints it, and writes its files.
[[nodiscard]] ExitCode carry_out(StudyCommand& command);

}  // namespace rocking::program
