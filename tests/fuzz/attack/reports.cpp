// Reports and outputs that were edited.

#include <filesystem>
#include <string>
#include <vector>

#include "fuzz/attack/attack.hpp"
#include "fuzz/mutate_json.hpp"

namespace rocking::fuzz {

void attack_reports(Attack& attack) {
  attack.copy_sound_run("out");
  std::filesystem::remove(attack.folder() / "out/report.html");
  const std::string text = attack.read("out/report.json");
  JsonMutator mutator(attack.random.bits());
  attack.write("out/report.json",
               attack.random.below(4) == 0
                   ? mutator.damaged_text(text)
                   : sealed(mutator.damaged(Json::parse(text))).dump(1, ' ', false, Json::error_handler_t::replace));

  const std::vector<std::vector<std::string>> readers{{"verify", "out", "--sample", "2"},
                                                      {"fragility", "out"},
                                                      {"compare", "out", (attack.sound().folder / "out").string()},
                                                      {"replay", "out", "--condition", "0", "--realisation", "1"},
                                                      {"status", "out"},
                                                      {"figure", "out/report.json", "-o", "drawn"},
                                                      {"report", "out", "--format", "text", "--json"}};
  attack.run({"report", "out", "--format", attack.random.below(10) == 0 ? "html,gnuplot" : "csv,latex,text"}, {0, 65});
  attack.run({"report", "out", "--format", "html"}, {0, 65});
  attack.run(attack.one_of(readers), {0, 1, 65, 66});
  attack.look_at_page("out/report.html");
}

}  // namespace rocking::fuzz
