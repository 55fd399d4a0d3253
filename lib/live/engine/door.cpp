// The functions that the page calls. Texts and bytes go in through memory that the page has asked for; each function returns
// the length of its reply, which stands at rocking_reply(). What is wrong with an input is told through the import `fail`
// (thrown.cpp), after which the instance must not be used any more.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/page/animation.hpp"
#include "pages/animation_of.hpp"
#include "rocking/base/digest.hpp"
#include "rocking/ensemble/group_scheduler.hpp"
#include "rocking/ensemble/pair_in_progress.hpp"
#include "rocking/ensemble/reduction.hpp"
#include "rocking/ensemble/summary_bytes.hpp"
#include "rocking/input/read_question.hpp"
#include "rocking/lanes/units.hpp"
#include "rocking/output/mode_look.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/report.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::live {
namespace {

constexpr std::size_t condition = 0;      // of an experiment without a sweep
constexpr std::size_t most_numbers = 50;  // of realisations of a mode, to be shown

/// A page has no ground motions.
class NoRecords final : public RecordFields {
 public:
  [[nodiscard]] const ValueType& format_type() const override { return type_of<bool>(); }
  void file(FieldVisitor& in, const Key& file, const Key& /*digest*/, std::string& /*name*/) override {
    in.reject(file.name, {"is read by the program only", "give another kind of base motion"});
    in.ignore_others();
  }
  bool suite(FieldVisitor& /*in*/, const Key& /*key*/) override { return true; }
  void ground_motion(FieldVisitor& /*in*/, const GroundMotionReading& /*how*/,
                     const std::optional<Strength>& /*strength*/, Recorded& /*recorded*/) override {}
};

/// An experiment of one condition. Throws base::InputError with all that is wrong with it.
Experiment experiment_in(std::string_view text) {
  Problems problems;
  const Json document = parse_json(text, problems);
  NoRecords records;
  QuestionAsRead read = read_question(document, records, problems);
  check_relations(read.question.condition, problems);
  for (const char* key : {"sweep", "unknown"}) {
    if (document.contains(key)) problems.push_back({std::string("/") + key, "", "is read by the program only", ""});
  }
  if (!problems.empty()) throw base::InputError(problems);
  Experiment experiment{.title = read.question.title,
                        .seed = read.question.seed,
                        .conditions = {read.question.condition},
                        .canonical_text = read.canonical.dump()};
  check_experiment(experiment);
  check_strobe(experiment);
  return experiment;
}

/// An experiment and its state: realisations in progress, those that have been counted.
class Session {
 public:
  explicit Session(std::string_view text)
      : experiment_(experiment_in(text)),
        scheduler_(experiment_.seed, lanes::one_lane_kernels().front(), nullptr),
        reduction_(asked()) {}
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  [[nodiscard]] std::string facts() const {
    return Json({{"sha256", base::to_hex(base::sha256(experiment_.canonical_text))},
                 {"experiment", Json::parse(experiment_.canonical_text)},
                 {"realisations", realisations()},
                 {"periods", asked().horizon.periods()}})
        .dump();
  }

  [[nodiscard]] bool wants_more() const { return scheduler_.wants_more(); }
  [[nodiscard]] bool is_idle() const { return scheduler_.is_idle(); }

  void start(std::uint64_t first) {
    scheduler_.start(
        std::make_unique<PairInProgress>(experiment_, Pair{.condition = condition, .first = first}, realisations()));
  }

  /// Works for about a millisecond; the pairs that are done, as bytes.
  [[nodiscard]] std::string work() {
    std::vector<PairOutcome> done;
    for (const auto& group : scheduler_.work())
      done.push_back({.pair = group->pair(), .summaries = group->summaries()});
    if (done.empty()) return {};
    const Bytes bytes = to_bytes(done);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  /// Counts pairs that are done, in whatever order.
  void count(std::span<const std::byte> bytes) {
    for (PairOutcome& outcome : outcomes_from(bytes)) waiting_[outcome.pair.first] = std::move(outcome.summaries);
    while (!waiting_.empty() && waiting_.begin()->first == reduction_.realisations()) {
      const auto next = waiting_.extract(waiting_.begin());
      for (const Summary& summary : next.mapped()) {
        std::vector<std::uint64_t>& numbers = modes_[summary.mode];
        if (numbers.size() < most_numbers) numbers.push_back(reduction_.realisations());
        reduction_.add(summary);
      }
    }
    if (reduction_.is_complete() && !digest_) {
      base::Sha256Builder builder;
      builder.add(reduction_.digest());
      digest_ = builder.finish();
    }
  }

  /// What the realisations that have been counted say: at least one.
  [[nodiscard]] std::string result() const {
    const ConditionResult found = reduction_.result();
    const Report report =
        report_of(experiment_, {.conditions = {found}, .digest = digest_.value_or(base::Sha256{})}, {});
    Json modes = Json::array();
    for (const auto& [mode, numbers] : modes_) modes.push_back(mode_in(report, mode, numbers));
    return Json({{"realisations", reduction_.realisations()},
                 {"answer", response_line(report) + overturning_line(report)},
                 {"level", report.level()},
                 {"modes", modes},
                 {"digest", digest_ ? Json(base::to_hex(*digest_)) : Json()}})
        .dump();
  }

  /// A realisation with this response mode, as the script of the page of a report animates it, and its strobe points.
  [[nodiscard]] std::string motion(std::uint64_t number) const {
    const std::int64_t periods = asked().horizon.periods();
    const RealisationKey key{.condition = condition, .realisation = number};
    const RealisationResult result = realise(asked(), experiment_.seed, number);
    const section::ResponseMode mode = result.classification.mode;
    auto motion = pages::animation_of(experiment_, key,
                                      {.periods = periods,
                                       .shown_periods = pages::shown_periods(mode),
                                       .most_samples = analysis::most_samples_of_a_run,
                                       .samples_per_period = {}});
    if (!motion) return {};
    motion->name = to_string(mode) + ": " + motion->name;
    Json strobe = Json::array();
    for (const section::StrobePoint& point : result.strobe) strobe.push_back({point.tilt, point.tilt_rate});
    return Json({{"mode", to_string(mode)},
                 {"number", number},
                 {"transient", asked().horizon.transient_periods},
                 {"strobe", strobe},
                 {"motion", analysis::motion_json(*motion)}})
        .dump();
  }

 private:
  [[nodiscard]] const Condition& asked() const { return experiment_.conditions.front(); }
  [[nodiscard]] std::uint64_t realisations() const { return effective_realisations(asked()); }

  [[nodiscard]] static Json mode_in(const Report& report, const section::ResponseMode& mode,
                                    const std::vector<std::uint64_t>& numbers) {
    const AnyShare share = share_of(report.conditions.front(), mode);
    const ModeLook look = look_of(mode);
    return {{"name", to_string(mode)},
            {"meaning", meaning_of(mode)},
            {"count", share.count},
            {"estimate", share.estimate},
            {"text", per_cent(share.estimate) + " %" + (share.interval ? ' ' + per_cent(*share.interval) : "")},
            {"interval", share.interval ? Json({share.interval->low, share.interval->high}) : Json()},
            {"colour", look.colour},
            {"hatch", look.hatch},
            {"marker", look.marker},
            {"numbers", numbers}};
  }

  Experiment experiment_;
  GroupScheduler<PairInProgress> scheduler_;
  Reduction reduction_;
  std::map<std::uint64_t, std::vector<Summary>> waiting_;  ///< by the first of the pair
  std::map<section::ResponseMode, std::vector<std::uint64_t>> modes_;
  std::optional<base::Sha256> digest_;
};

std::string& reply() {
  static std::string text;
  return text;
}

std::size_t replied(std::string text) {
  reply() = std::move(text);
  return reply().size();
}

std::optional<Session>& session() {
  static std::optional<Session> current;
  return current;
}

}  // namespace
}  // namespace rocking::live

extern "C" {

using rocking::live::replied;
using rocking::live::session;

void* rocking_allocate(std::size_t size) { return std::malloc(size); }
void rocking_release(void* memory) { std::free(memory); }
const char* rocking_reply() { return rocking::live::reply().data(); }

std::size_t rocking_begin(const char* text, std::size_t size) {
  session().emplace(std::string_view(text, size));
  return replied(session()->facts());
}
bool rocking_wants_more() { return session()->wants_more(); }
bool rocking_is_idle() { return session()->is_idle(); }
void rocking_start(std::uint32_t first) { session()->start(first); }
std::size_t rocking_work() { return replied(session()->work()); }
void rocking_count(const std::byte* bytes, std::size_t size) { session()->count({bytes, size}); }
std::size_t rocking_result() { return replied(session()->result()); }
std::size_t rocking_motion(std::uint32_t number) { return replied(session()->motion(number)); }
}
