#include "fuzz/attack/attack.hpp"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "fuzz/attack/checks.hpp"

namespace rocking::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_message = 32768;

std::string quoted(const std::vector<std::string>& arguments) {
  std::string line = "rocking";
  for (const std::string& argument : arguments) {
    line += " '";
    for (const char sign : argument.substr(0, 100)) {
      const auto byte = static_cast<unsigned char>(sign);
      if (byte >= 0x20 && byte < 0x7f) {
        line += sign;
      } else {
        constexpr std::string_view digits = "0123456789abcdef";
        line += {'\\', 'x', digits[byte / 16], digits[byte % 16]};
      }
    }
    line += '\'';
  }
  return line;
}

std::string file_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::string lasting_text(const std::string& report) {
  auto document = Json::parse(report, nullptr, false);
  if (!document.is_object()) return {};
  document.erase("system");
  return document.dump();
}

Sound make_sound(const fs::path& program, const fs::path& folder) {
  constexpr const char* experiment = R"({
    "format": "rocking.experiment/1", "title": "quick",
    "block": { "width_m": 1.0, "height_m": 4.0 },
    "excitation": { "amplitude": 4.2, "frequency_ratio": 10.0 },
    "friction": { "static": 0.35, "kinetic": 0.30 },
    "fluctuation": { "friction": { "sigma": 0.03, "refreshes_per_period": 20 } },
    "horizon": { "transient_periods": 20, "sampled_periods": 40 },
    "sweep": [ { "parameter": "/excitation/amplitude", "values": [3.0, 4.2, 6.0] } ],
    "realisations": 40, "seed": "0x2012" })";
  fs::create_directories(folder);
  std::ofstream(folder / "quick.json") << experiment;
  std::ofstream(folder / "pulse.txt") << "# time, horizontal\n0.5, 0\n0.5, 2\n0.7, 2\n0.7, 0\n";
  const Ending ending = run_limited(program, {"run", "quick.json", "-q", "-j", "1", "-o", "out"}, folder, {});
  if (ending.exit_code != 0) throw std::runtime_error("the sound run does not work: " + ending.errors);
  return {.program = program, .folder = folder, .report = lasting_text(file_text(folder / "out/report.json"))};
}

void Attack::write(const fs::path& name, const std::string& bytes) const {
  std::ofstream(folder_ / name, std::ios::binary) << bytes;
}

std::string Attack::read(const fs::path& name) const { return file_text(folder_ / name); }

void Attack::copy_sound_run(const std::string& name) const {
  fs::copy(sound_.folder / "out", folder_ / name, fs::copy_options::recursive);
}

Ending Attack::run(const std::vector<std::string>& arguments, const std::set<int>& allowed) {
  const Ending ending = run_limited(sound_.program, arguments, folder_, {});
  const auto complain = [&](const std::string& what) { find(quoted(arguments) + "\n      " + what); };
  if (ending.out_of_time) {
    complain("does not end");
  } else if (!ending.exit_code) {
    complain(std::string("ended by the signal ") + strsignal(ending.signal));
  } else if (!allowed.contains(*ending.exit_code)) {
    complain("exit code " + std::to_string(*ending.exit_code) + ": " + ending.errors.substr(0, 300));
  }
  if (const std::string bad = control_character_in(ending.errors); !bad.empty()) complain("standard error has " + bad);
  if (const std::string bad = control_character_in(ending.output); !bad.empty()) complain("standard output has " + bad);
  const bool json = std::ranges::find(arguments, "--json") != arguments.end();
  if (json && !is_utf8(ending.output)) complain("JSON that is no UTF-8");
  if (ending.errors.size() > longest_message)
    complain("messages of " + std::to_string(ending.errors.size()) + " bytes");
  return ending;
}

void Attack::look_at_page(const fs::path& name) {
  if (!exists(name)) return;
  const std::string page = read(name);
  if (const std::string damage = damage_of_page(page); !damage.empty()) find("page: " + damage);
  for (const char* text : {"<script>alert", "<script>(1", "<b>bold"}) {
    if (page.find(text) != std::string::npos) find(std::string("page: text that is not escaped: ") + text);
  }
}

}  // namespace rocking::fuzz
