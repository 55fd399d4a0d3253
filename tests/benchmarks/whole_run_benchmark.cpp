// Processor time of a whole run, compared with Boost.odeint: whole_run_benchmark PROGRAM [ROUNDS]
//
// PROGRAM is `rocking`. The processor time that `rocking run -j 1` takes for one more realisation is the difference of
// two sizes, so that start and end of the program, its report and its page do not count; they are printed on their own.
// Boost.odeint simulates the same scenes from the middles of sixteen equal parts of the range of initial tilts, to the
// same horizon, without classifying anything. Both use the tolerance at which the median error of the end states after
// 20 periods is at most `wanted_error`. Each round measures both, one after the other. The table has the least times of all
// rounds, which other work on the machine disturbs least, their ratio, and the least and the largest ratio of a round.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "benchmarks/follow.hpp"
#include "rocking/lanes/kernels.hpp"
#include "support/temporary_folder.hpp"

namespace {

using namespace rocking::benchmarks;

constexpr double wanted_error = 2e-11;
constexpr double aimed_seconds = 0.4;  // of the smaller run; the larger one takes four times as long

struct Horizon {
  int transient;
  int sampled;

  [[nodiscard]] int periods() const { return transient + sampled; }
};

struct Task {
  Case scene;
  Horizon horizon;
  double tolerance;
};

enum class Page : std::uint8_t { none, drawn };
enum class Reruns : std::uint8_t { none, usual };

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Processor seconds of a command that must succeed; what it prints is dropped.
double seconds_of_command(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process");
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error(words[0] + " failed");
  }
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

void write_experiment(const std::string& path, const Task& task, int realisations, Reruns reruns) {
  std::ofstream file(path);
  file << R"({ "format": "rocking.experiment/1", "title": "whole run", "seed": "0x2012",
  "block": { "width_m": 1.0, "height_m": 4.0 },
  "excitation": { "kind": "harmonic", "amplitude": )"
       << task.scene.amplitude << R"(, "frequency_ratio": 10.0 },
  "initial": { "tilt": { "uniform": [0.04, 0.36] } },
  )";
  if (task.scene.slides) file << R"("friction": { "static": 0.40, "kinetic": 0.35 }, )";
  if (task.scene.sigma > 0.0) file << R"("fluctuation": { "friction": { "sigma": )" << task.scene.sigma << " } }, ";
  file << R"("horizon": { "transient_periods": )" << task.horizon.transient << R"(, "sampled_periods": )"
       << task.horizon.sampled << R"( }, "accuracy": { "tolerance": )" << task.tolerance << R"(, "rerun_every": )"
       << (reruns == Reruns::usual ? 10 : 0) << R"( }, "realisations": )" << realisations << " }\n";
}

/// Processor seconds of `rocking run -j 1`.
class Runs {
 public:
  explicit Runs(std::string program) : program_(std::move(program)) {}

  [[nodiscard]] double seconds(const Task& task, int realisations, Page page, Reruns reruns = Reruns::usual) const {
    const std::string experiment = folder_ / "experiment.json";
    write_experiment(experiment, task, realisations, reruns);
    std::vector<std::string> words{program_, "run", experiment,    "-o", folder_ / "out",
                                   "-j",     "1",   "--overwrite", "-q", "--no-progress"};
    if (page == Page::none) words.emplace_back("--no-page");
    return seconds_of_command(std::move(words));
  }

 private:
  std::string program_;
  rocking::support::TemporaryFolder folder_;
};

/// Processor seconds of Boost.odeint for a realisation, from one of the initial tilts after the other.
double odeint_seconds(const Task& task, double tolerance) {
  const std::clock_t begin = std::clock();
  for (int start = 0; start < starts; ++start) {
    auto question = question_of(task.scene, start);
    question.periods = task.horizon.periods();
    if (follow_by_odeint(question, tolerance).tilt > 1e300) std::abort();  // the result is used
  }
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / starts;
}

double least(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

void compare(const Runs& runs, const Task& task, double odeint_tolerance, int rounds) {
  int few = 100;
  while (runs.seconds(task, few, Page::none) < aimed_seconds) few *= 2;
  const int many = 4 * few;
  const auto difference = [&](Reruns reruns) {
    return (runs.seconds(task, many, Page::none, reruns) - runs.seconds(task, few, Page::none, reruns)) / (many - few);
  };
  std::vector<double> ours;
  std::vector<double> without_reruns;
  std::vector<double> odeint;
  std::vector<double> ratios;
  for (int round = 0; round < rounds; ++round) {
    ours.push_back(difference(Reruns::usual));
    odeint.push_back(odeint_seconds(task, odeint_tolerance));
    ratios.push_back(odeint.back() / ours.back());
    without_reruns.push_back(difference(Reruns::none));
  }
  std::printf("%-22s %4d + %3d %10.1f %12.1f %10.1f %8.1f %8.1f %8.1f\n", task.scene.name.c_str(),
              task.horizon.transient, task.horizon.sampled, 1e6 * least(ours), 1e6 * least(without_reruns),
              1e6 * least(odeint), least(odeint) / least(ours), least(ratios),
              *std::max_element(ratios.begin(), ratios.end()));
  std::fflush(stdout);
}

/// As the system names it.
std::string processor() {
  std::ifstream facts("/proc/cpuinfo");
  for (std::string line; std::getline(facts, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

void print_fixed_cost(const Runs& runs, const Task& task) {
  constexpr int repetitions = 100;
  double bare = 0.0;
  double with_page = 0.0;
  for (int i = 0; i < repetitions; ++i) bare += runs.seconds(task, 1, Page::none);
  for (int i = 0; i < repetitions / 10; ++i) with_page += runs.seconds(task, 1, Page::drawn);
  std::printf("one realisation, without page: %.1f ms; with page: %.1f ms (means)\n", 1e3 * bare / repetitions,
              1e4 * with_page / repetitions);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) {
    std::fputs("usage: whole_run_benchmark PROGRAM [ROUNDS]\n", stderr);
    return 64;
  }
  const Runs runs(arguments[1]);
  const int rounds = count > 2 ? std::atoi(arguments[2]) : 5;
  std::printf("%s; lanes: %s\n", processor().c_str(),
              std::string(rocking::lanes::available_kernels().back().name).c_str());
  std::printf("%-22s %10s %10s %12s %10s %8s %8s %8s\n", "", "", "us a", "without", "odeint us", "ratio", "", "");
  std::printf("%-22s %10s %10s %12s %10s %8s %8s %8s\n", "scene", "periods", "realis.", "reruns", "a realis.", "",
              "least", "most");
  for (const Case& scene : usual_cases()) {
    const double ours = calibrate(scene, follow_by_ours, wanted_error).tolerance;
    const double odeint = calibrate(scene, follow_by_odeint, wanted_error).tolerance;
    for (const Horizon horizon : {Horizon{500, 120}, Horizon{40, 60}}) {
      compare(runs, {scene, horizon, ours}, odeint, rounds);
    }
  }
  print_fixed_cost(runs, {usual_cases()[0], {40, 60}, 1e-10});
  return 0;
}
