#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/targets.hpp"
#include "rocking/api/checks.hpp"
#include "rocking/api/run.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/rocking.hpp"
#include "rocking/studies/cost/study.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/studies/infer/study.hpp"
#include "rocking/studies/orbits/study.hpp"
#include "rocking/studies/rare/study.hpp"

/// Questions of the public calls, whose values are chosen by bytes.
namespace rocking::fuzz {

/// Whether a question that is not refused is answered too, or stopped at once.
enum class Answering : std::uint8_t { full, stopped };

/// Values that bytes choose; 0 where they have ended.
class Choices {
 public:
  explicit Choices(std::string_view bytes) : bytes_(bytes) {}

  unsigned byte() {
    if (bytes_.empty()) return 0;
    const auto first = static_cast<unsigned char>(bytes_.front());
    bytes_.remove_prefix(1);
    return first;
  }
  bool yes() { return byte() % 2 == 1; }
  std::size_t below(std::size_t limit) { return byte() % limit; }

  /// Numbers that fit some question, and some that fit none.
  double number() {
    using Limits = std::numeric_limits<double>;
    static constexpr std::array numbers{0.0,
                                        1.0,
                                        0.5,
                                        0.1,
                                        2.0,
                                        4.0,
                                        1e-3,
                                        1e-4,
                                        0.05,
                                        0.9,
                                        0.8,
                                        0.95,
                                        3.0,
                                        10.0,
                                        1e3,
                                        1e-9,
                                        1e9,
                                        1e19,
                                        -1.0,
                                        -0.0,
                                        -1e-3,
                                        1e300,
                                        1e-300,
                                        Limits::quiet_NaN(),
                                        1e-16,
                                        1e-2,
                                        20.0,
                                        9.81e0,
                                        0.8501,
                                        1e308,
                                        Limits::infinity(),
                                        -Limits::infinity()};
    const unsigned choice = byte();
    if (choice < 128) return numbers.at(choice % numbers.size());
    return std::ldexp(static_cast<double>(byte()) - 64.0, static_cast<int>(choice % 40) - 20);
  }
  std::uint64_t whole() {
    static constexpr std::array<std::uint64_t, 16> numbers{
        0, 1, 2, 5, 12, 16, 20, 40, 1000, 1001, 100'000, 999'999'999, 1'000'000'000, 1ULL << 32U, 1ULL << 63U, ~0ULL};
    const unsigned choice = byte();
    return choice < 192 ? numbers.at(choice % numbers.size()) : choice - 192;
  }
  int small() { return static_cast<int>(byte()) - 8; }
  std::string text() {
    static constexpr std::array texts{"",
                                      "/excitation/amplitude",
                                      "/restitution",
                                      "4.0",
                                      "-4",
                                      "four",
                                      "/",
                                      "/~",
                                      "box-muller",
                                      "ziggurat",
                                      "columns",
                                      "auto",
                                      "m/s^2",
                                      "g",
                                      "one.at2",
                                      "two.txt",
                                      "{\"a\": 1}",
                                      "/excitation/amplitude/0",
                                      "/friction",
                                      "/excitation/frequency_ratio"};
    return texts.at(below(texts.size()));
  }

  template <class Make>
  auto list(std::size_t most, Make&& make) {
    std::vector<decltype(make())> list;
    for (std::size_t left = below(most + 1); left > 0; --left) list.push_back(make());
    return list;
  }
  template <class Make>
  auto maybe(Make&& make) {
    return yes() ? std::optional(make()) : std::nullopt;
  }

 private:
  std::string_view bytes_;
};

/// A run with two conditions.
inline StoredRun made_run(const std::string& keys, const std::string& swept) {
  StoredRun made{.experiment = read_small_experiment(
                     R"({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4}, "restitution": 0.9,
                         "realisations": 12, "unknown": [{"parameter": "/restitution", "from": 0.8, "to": 0.95}], )" +
                     keys + R"(, "sweep": [{"parameter": "/excitation/)" + swept + R"(", "values": [2, 4]}]})"),
                 .run = {}};
  made.run = run(made.experiment);
  return made;
}

inline constexpr std::string_view shaken_keys = R"("excitation": {"amplitude": 2, "frequency_ratio": 10},
    "horizon": {"transient_periods": 1, "sampled_periods": 5})";
inline constexpr std::string_view random_keys = R"(, "fluctuation": {"restitution": {"sigma": 0.01}})";

/// A block under two amplitudes without anything random, with a random restitution, and under two records.
inline const StoredRun& small_run(std::size_t choice) {
  static const std::array runs{
      made_run(std::string(shaken_keys) + std::string(random_keys), "amplitude"),
      made_run(R"("excitation": {"kind": "recorded", "suite": "*.at2"})" + std::string(random_keys), "scale"),
      made_run(std::string(shaken_keys), "amplitude")};
  return runs.at(choice % runs.size());
}

class QuestionTarget {
 public:
  QuestionTarget(std::string_view bytes, Answering answering)
      : choose_(bytes), stop_(answering == Answering::stopped), execution_{.stop = &stop_} {}

  void ask() {
    static constexpr std::array studies{&QuestionTarget::ask_fragility, &QuestionTarget::ask_rare,
                                        &QuestionTarget::ask_infer,     &QuestionTarget::ask_orbits,
                                        &QuestionTarget::ask_others,    &QuestionTarget::ask_numbers};
    try {
      (this->*studies.at(choose_.below(studies.size())))();
    } catch (const base::InputError& error) {
      demand(!error.problems().empty(), "a refusal has a reason");
      for (const base::Problem& problem : error.problems()) {
        demand(!problem.place.empty() && !problem.reason.empty(), "a problem has a place and a reason");
      }
    } catch (const base::Stopped&) {
    }
  }

 private:
  RareLevel level() {
    return {.intensity = choose_.number(),
            .probability = choose_.number(),
            .interval = {choose_.number(), choose_.number()},
            .relative_error = choose_.number(),
            .degrees_of_freedom = choose_.number()};
  }

  ResponseEvent event() {
    constexpr std::array names{EventName::overturning, EventName::tilt, EventName::slip, EventName::displacement};
    return {names[choose_.below(names.size())], choose_.number()};
  }

  void ask_fragility() {
    const StoredRun& of = small_run(choose_.below(2));
    FragilityQuestion question;
    question.events = choose_.list(2, [&] { return event(); });
    question.incremental = choose_.yes();
    question.hazard = choose_.maybe([&] {
      return HazardCurve{.name = "h", .intensity = "", .points = choose_.list(4, [&] {
                           return HazardPoint{.intensity = choose_.number(), .rate = choose_.number()};
                         })};
    });
    question.rare = choose_.list(2, [&] {
      RareOfCurve rare{.others = {}, .event = event(), .level = level()};
      rare.records = choose_.list(2, [&] { return RareOfCurve::OfRecord{.name = choose_.text(), .level = level()}; });
      return rare;
    });
    const RunFragility found = fragility(of.experiment, of.run, question, execution_);
    for (const ShownCurve& shown : found.curves) {
      if (shown.rate) expect_rate(*shown.rate, *question.hazard);
    }
    static_cast<void>(fragility_document().text(fragility_report({found})));
  }

  static void expect_rate(const AnnualRate& rate, const HazardCurve& hazard) {
    demand(rate.value >= 0.0 && rate.value <= hazard.points.front().rate * (1.0 + 1e-9),
           "a rate is part of the events");
  }

  void ask_rare() {
    const Experiment& experiment = small_run(0).experiment;
    RareQuestion request{.event = event()};
    request.relative_error = choose_.number();
    request.particles = choose_.whole();
    request.seconds = choose_.maybe([&] { return choose_.number(); });
    if (choose_.yes()) execution_.elapsed_seconds = [] { return 0.0; };
    request.earlier = choose_.list(3, [&] {
      const std::vector<rare::Repetition> some = choose_.list(3, [&] {
        return rare::Repetition{.estimate = choose_.number(), .ancestors = choose_.whole(), .work = choose_.number()};
      });
      RareEstimate all;
      const std::size_t many = choose_.byte() == 255 ? 100'000 : choose_.below(40);
      for (std::size_t i = 0; i < many && !some.empty(); ++i) all.repetitions.push_back(some[i % some.size()]);
      return all;
    });
    check_question(experiment, request);
    request.relative_error = std::max(request.relative_error, 0.5);
    request.particles = 20;
    for (const RareEstimate& found : rare_probabilities(experiment, request, execution_)) {
      demand(!found.probability || *found.probability >= 0.0, "a probability is not negative");
      demand(found.interval.low <= found.interval.high, "an interval has its ends in order");
    }
  }

  TestedCondition tested() {
    return {.parameters = choose_.list(2,
                                       [&] {
                                         return Parameter{choose_.text(), WrittenPart{choose_.text()}};
                                       }),
            .counts = choose_.list(3, [&] { return choose_.whole(); })};
  }

  void ask_infer() {
    Experiment experiment = small_run(0).experiment;
    if (choose_.byte() == 255) experiment.canonical_text.clear();
    if (choose_.byte() == 255) experiment.unknowns.resize(choose_.below(5), experiment.unknowns.front());
    if (choose_.byte() == 255) experiment.unknowns.push_back({.pointer = choose_.text(), .from = choose_.number()});
    InferQuestion request;
    request.tests.groups = choose_.list(3, [&] { return ModeGroup{.name = "other", .modes = {}}; });
    request.tests.conditions = choose_.list(2, [&] { return tested(); });
    request.tests.candidates = choose_.list(1, [&] { return tested(); });
    request.next_tests = choose_.whole();
    request.seconds = choose_.maybe([&] { return choose_.number(); });
    if (choose_.yes()) execution_.elapsed_seconds = [] { return 0.0; };
    request.earlier = choose_.list(2, [&] {
      const auto counts = [&] { return choose_.list(3, [&] { return choose_.whole(); }); };
      return infer::DesignPoint{.at = choose_.list(2, [&] { return choose_.number(); }),
                                .counts = choose_.list(3, counts)};
    });
    const Inference found = infer_unknowns(experiment, request, execution_);
    demand(found.answer.has_value(), "what is not stopped has an answer");
    demand(found.answer->fit.p_value > 0.0 && found.answer->fit.p_value <= 1.0, "a p-value is a probability");
  }

  void ask_orbits() {
    const Experiment& experiment = small_run(2).experiment;
    const auto number = [&] { return choose_.number(); };
    OrbitsQuestion request{.longest = choose_.small(), .branches = choose_.yes()};
    request.from = choose_.maybe(number);
    request.to = choose_.maybe(number);
    request.most_points = choose_.whole();
    request.most_branches = choose_.whole();
    static_cast<void>(checked(experiment, request));
  }

  void ask_others() {
    const StoredRun& of = small_run(choose_.below(3));
    const auto number = [&] { return choose_.number(); };
    switch (choose_.below(6)) {
      case 0: {
        const TrajectoryRequest request{.condition = choose_.whole(), .realisation = choose_.whole()};
        return static_cast<void>(trajectory(of.experiment, request, execution_));
      }
      case 1: {
        CostQuestion request;
        request.seconds = number();
        request.sample = choose_.maybe([&] { return choose_.whole(); });
        request.tolerances = choose_.list(4, number);
        return check_question(of.experiment, request);
      }
      case 2: {
        MotionQuestion request{.files = {}, .vertical = choose_.maybe([&] { return choose_.text(); })};
        request.format = choose_.text();
        request.units = choose_.maybe([&] { return choose_.text(); });
        request.time_step = choose_.maybe(number);
        request.gravity = number();
        request.damping = number();
        request.periods = choose_.list(3, number);
        return static_cast<void>(motion(request));
      }
      case 3: {
        const Shard shard{.part = choose_.whole(), .parts = choose_.whole()};
        Execution execution{.threads = static_cast<unsigned>(choose_.whole())};
        if (choose_.yes()) execution.shard = shard;
        return static_cast<void>(plan(of.experiment, execution));
      }
      case 4: return static_cast<void>(replay(of, {.condition = choose_.whole(), .realisation = choose_.whole()}));
      default: {
        const Provenance provenance{.duration_s = number(), .threads = static_cast<unsigned>(choose_.whole())};
        static_cast<void>(report(of.experiment, of.run, provenance));
      }
    }
  }

  void ask_numbers() {
    const std::uint64_t successes = choose_.whole();
    const std::uint64_t trials = choose_.whole();
    const double confidence = choose_.number();
    if (choose_.yes()) {
      const SamplerQuestion question{.n = std::min<std::uint64_t>(trials, 1001),
                                     .mean = choose_.number(),
                                     .sigma = choose_.number(),
                                     .distribution = choose_.yes() ? FluctuationLaw::lognormal : FluctuationLaw::normal,
                                     .sampler = choose_.text()};
      return static_cast<void>(check_normal(question));
    }
    for (const stats::Interval& interval :
         {clopper_pearson(successes, trials, confidence), wilson(successes, trials, confidence)}) {
      demand(interval.low >= 0.0 && interval.low <= interval.high && interval.high <= 1.0,
             "an interval of a probability");
    }
  }

  Choices choose_;
  std::atomic<bool> stop_;
  Execution execution_;
};

/// Each question is refused with its problems, stopped, or answered with numbers that can be. Answers take long: of a
/// fuzzer's questions, one in 500 is answered.
inline void try_question(std::string_view bytes) {
  static std::uint64_t asked = 0;
  QuestionTarget(bytes, asked++ % 500 == 0 ? Answering::full : Answering::stopped).ask();
}

/// The same, answered in any case.
inline void answer_question(std::string_view bytes) { QuestionTarget(bytes, Answering::full).ask(); }

}  // namespace rocking::fuzz
