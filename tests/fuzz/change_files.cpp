// change_files FILE SEED COUNT: makes COUNT changed copies of a report.json or of the output of a command, and reads
// each as the commands do. Prints how many were used and refused. A copy with any other result is written to
// changed-SEED.json, and the program ends with exit code 1.

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "fuzz/file_targets.hpp"
#include "fuzz/mutate_json.hpp"

int main(int argc, char** argv) {
  using namespace rocking::fuzz;
  if (argc != 4) {
    std::fputs("usage: change_files FILE SEED COUNT\n", stderr);
    return 64;
  }
  std::ifstream file(argv[1], std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto document = rocking::Json::parse(text);
  const bool is_report = document.value("format", "") == "rocking.report/1";
  const std::uint64_t first = std::strtoull(argv[2], nullptr, 0);
  const std::uint64_t count = std::strtoull(argv[3], nullptr, 0);
  std::uint64_t refused = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    JsonMutator mutator(seed);
    const std::string changed =
        seed % 4 == 0 ? mutator.damaged_text(text)
                      : sealed(mutator.damaged(document)).dump(1, ' ', false, rocking::Json::error_handler_t::replace);
    try {
      if (is_report) static_cast<void>(try_claims(changed));
      if ((is_report ? try_report(changed) : try_output(changed)) == Reading::refused) ++refused;
    } catch (const std::exception& error) {
      const std::string name = "changed-" + std::to_string(seed) + ".json";
      std::ofstream(name, std::ios::binary) << changed;
      std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
      return 1;
    }
  }
  std::printf("%llu used, %llu refused\n", static_cast<unsigned long long>(count - refused),
              static_cast<unsigned long long>(refused));
  return 0;
}
