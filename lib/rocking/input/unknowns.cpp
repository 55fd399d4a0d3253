#include "rocking/input/unknowns.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "rocking/input/reading_keys.hpp"
#include "rocking/input/swept_place.hpp"

namespace rocking {
namespace {

constexpr NumberRule any_end{.bounds = {}, .demand = "must be a number", .example = "0.0"};

/// A law with a density.
std::optional<Quantity> read_prior(ObjectReader& in) {
  if (!in.has("prior")) return std::nullopt;
  Quantity prior = 0.0;
  const std::size_t problems_before = in.problems().size();
  ReadingKeys(in, {.sweep = nullptr, .files = nullptr}).quantity({"prior", ""}, prior, any_end, Absent::error);
  if (in.problems().size() != problems_before) return std::nullopt;
  if (!is_drawn(prior) || std::holds_alternative<Values>(prior)) {
    in.reject("prior", "must be a law with a density",
              "give for example {\"normal\": {\"mean\": 0.3, \"sigma\": 0.05}}");
    return std::nullopt;
  }
  return prior;
}

Unknown read_unknown(ObjectReader& in, const Json& base) {
  const std::size_t problems_before = in.problems().size();
  Unknown unknown{.pointer = read_swept_place(in, base)};
  const bool is_place = in.problems().size() == problems_before;
  if (is_place && !base[Json::json_pointer(unknown.pointer)].is_number()) {
    in.reject("parameter", "is no number in this file",
              "write a number there, or give a number within, such as the mean");
  }
  unknown.from = in.number("from", any_end);
  unknown.to = in.number("to", any_end);
  if (in.problems().size() == problems_before && !(unknown.from < unknown.to)) {
    in.reject("to", "is not above \"from\"", "give the smallest value as \"from\" and the largest as \"to\"");
  }
  unknown.prior = read_prior(in);
  return unknown;
}

bool overlap(const std::string& a, const std::string& b) {
  return !a.empty() && !b.empty() && (is_within(a, b) || is_within(b, a));
}

}  // namespace

std::vector<Unknown> read_unknowns(const Json& list, const Json& base, const std::vector<SweepAxis>& axes,
                                   Problems& problems) {
  std::vector<Unknown> unknowns;
  if (!list.is_array() || list.empty() || list.size() > most_unknowns) {
    problems.push_back({"/unknown", brief(list), "must be a list of one to three entries",
                        "give for example [{\"parameter\": \"/friction/static\", \"from\": 0.2, \"to\": 0.6}]"});
    return unknowns;
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string place = "/unknown/" + std::to_string(i);
    ObjectReader in(list[i], place, problems);
    Unknown unknown = read_unknown(in, base);
    static_cast<void>(in.finish());
    const bool is_swept =
        std::ranges::any_of(axes, [&](const SweepAxis& axis) { return overlap(axis.pointer, unknown.pointer); });
    const bool is_double =
        std::ranges::any_of(unknowns, [&](const Unknown& other) { return overlap(other.pointer, unknown.pointer); });
    if (is_swept || is_double) {
      problems.push_back({place + "/parameter", '"' + unknown.pointer + '"',
                          is_swept ? "is also swept" : "is also set by an entry before it", "keep one of them"});
    }
    unknowns.push_back(std::move(unknown));
  }
  return unknowns;
}

}  // namespace rocking
