// Titles, swept texts and names of folders that a program could interpret as its own language.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "fuzz/attack/attack.hpp"

namespace rocking::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr const char* texts[] = {"'Tis rocking",
                                 "''",
                                 "\"",
                                 "`touch pwned`",
                                 "$(touch pwned)",
                                 "<b>bold</b>",
                                 "</title><script>alert(1)</script>",
                                 "&amp;",
                                 "a\nb",
                                 "\x1b[31mred",
                                 "\\",
                                 "%s%n",
                                 "@{}^_~",
                                 "Ü 地震 ٣",
                                 "\u202eright to left",
                                 "\u0085",
                                 " ",
                                 "]]>",
                                 "--title",
                                 "'; system 'touch pwned'",
                                 "\t",
                                 "{/Symbol a}",
                                 "# no",
                                 "=1+1",
                                 ",",
                                 "$x_1$",
                                 "\\input{x}",
                                 ".",
                                 "\x7f"};

std::string odd_text(Attack& attack) {
  if (attack.random.below(20) == 0) return std::string(3000, 'W');
  std::string text;
  for (int parts = 1 + attack.random.below(3); parts > 0; --parts) text += attack.one_of(texts);
  return text;
}

std::string odd_folder(Attack& attack) {
  std::string name = "f" + odd_text(attack).substr(0, 200);
  std::ranges::replace(name, '/', '|');
  if (attack.random.below(6) == 0) name += "\xff\xfe";
  if (attack.random.below(6) == 0)
    name += "/" + std::string(200, 'n') + "/" + std::string(200, 'm') + "/" + std::string(200, 'o');
  return name;
}

std::size_t pictures_in(const fs::path& folder) {
  std::size_t count = 0;
  if (!fs::is_directory(folder)) return count;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".svg") continue;
    std::ifstream file(entry.path());
    const std::string text(std::istreambuf_iterator<char>(file), {});
    if (text.find("<path") != std::string::npos && text.find("</svg>") != std::string::npos) ++count;
  }
  return count;
}

}  // namespace

void attack_texts(Attack& attack) {
  Json experiment = Json::parse(attack.read(attack.sound().folder / "quick.json"));
  experiment["realisations"] = 4;
  experiment["title"] = odd_text(attack);
  const bool swept = attack.random.below(3) == 0;
  if (swept) {
    const std::string record = "r" + std::to_string(attack.random.below(9)) + odd_folder(attack).substr(0, 60) + ".txt";
    std::string name = record;
    std::erase(name, '\xff');
    std::erase(name, '\xfe');
    std::ranges::replace(name, '/', '|');
    fs::path(name).has_filename() ? attack.write(name, attack.read(attack.sound().folder / "pulse.txt")) : void();
    experiment = {{"format", "rocking.experiment/1"},
                  {"title", experiment["title"]},
                  {"block", {{"width_m", 1.0}, {"height_m", 8.0}}},
                  {"excitation", {{"kind", "recorded"}, {"file", name}}},
                  {"sweep", Json::array({{{"parameter", "/excitation/file"}, {"values", {name, "pulse.txt"}}}})}};
    attack.write("pulse.txt", attack.read(attack.sound().folder / "pulse.txt"));
  }
  attack.write("odd.json", experiment.dump(1, ' ', false, Json::error_handler_t::replace));
  const std::string folder = odd_folder(attack);

  const Ending ran = attack.run({"run", "odd.json", "-j", "1", "-q", "-o", folder}, {0, 64, 65});
  if (ran.exit_code == 64 && ran.errors.find("too long for SQLite") == std::string::npos) attack.find(ran.errors);
  if (ran.exit_code != 0) return;  // a refusal is allowed
  attack.look_at_page(fs::path(folder) / "report.html");
  attack.run({"status", folder}, {0});
  const Ending told = attack.run({"report", folder, "--format", "csv,latex,html", "--json"}, {0});
  if (told.exit_code == 0 && !Json::accept(told.output)) attack.find("`report --json` prints no JSON");
  if (attack.random.below(5) == 0) {
    const Ending drawn = attack.run({"report", folder, "--format", "gnuplot", "-q"}, {0});
    if (drawn.exit_code == 0 && drawn.errors.empty() && pictures_in(attack.folder() / folder) == 0) {
      attack.find("no picture, and no word of it");
    }
  }
  if (attack.exists("pwned") || fs::exists(attack.folder() / folder / "pwned")) attack.find("a text was executed");
}

}  // namespace rocking::fuzz
