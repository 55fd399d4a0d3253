// Ground motion files that are not valid.

#include <filesystem>
#include <string>

#include "fuzz/attack/attack.hpp"
#include "fuzz/mutate_json.hpp"

namespace rocking::fuzz {
namespace {

constexpr const char* numbers[] = {"0",   "1e308", "-1e308",  "1e-308",   "nan", "inf", "-0", "1e400", "0x10", "1,5",
                                   "1d3", "--1",   "\x1b[2J", "\xff\xfe", "1 2", "#",   "",   "1e",    "+2",   "٣"};

std::string table(Attack& attack) {
  std::string text;
  const int lines = attack.random.below(40);
  const int columns = 1 + attack.random.below(4);
  double time = 0.0;
  for (int line = 0; line < lines; ++line) {
    time += attack.random.uniform(-0.001, 0.1);
    text += std::to_string(time);
    for (int column = 1; column < columns; ++column) {
      text += attack.random.below(2) == 0 ? ", " : " ";
      text += attack.random.below(30) == 0 ? attack.one_of(numbers) : std::to_string(attack.random.uniform(-9.0, 9.0));
    }
    text += attack.random.below(20) == 0 ? "\r" : "\n";
  }
  return text;
}

}  // namespace

void attack_records(Attack& attack) {
  Json excitation{{"kind", "recorded"}, {"file", "record.txt"}};
  if (attack.random.below(3) == 0) excitation["time_step_s"] = attack.random.uniform(0.001, 0.1);
  const Json experiment{
      {"format", "rocking.experiment/1"}, {"block", {{"width_m", 1.0}, {"height_m", 8.0}}}, {"excitation", excitation}};
  attack.write("recorded.json", experiment.dump(1));
  JsonMutator mutator(attack.random.bits());
  std::string record =
      attack.random.below(8) == 0 ? attack.read(attack.sound().program).substr(0, 20000) : table(attack);
  if (attack.random.below(2) == 0) record = mutator.damaged_text(record);
  if (attack.random.below(30) == 0) {
    std::filesystem::create_directory(attack.folder() / "record.txt");
  } else {
    attack.write("record.txt", record);
  }
  attack.run({"validate", "recorded.json"}, {0, 65, 66, 74});
  attack.run({"run", "recorded.json", "-q", "--max-time", "1s", "-o", "out"}, {0, 65, 66, 74, 75});
}

}  // namespace rocking::fuzz
