#pragma once

#include <cstdint>
#include <string>

#include "rocking/text/json.hpp"
#include "support/split_mix.hpp"

namespace rocking::fuzz {

/// Makes damaged documents from an undamaged one; the same ones for the same seed on every machine.
class JsonMutator {
 public:
  explicit JsonMutator(std::uint64_t seed) : random_(seed) {}

  /// The document with one to three changes, each at a place drawn from all places: a value removed, replaced by one
  /// that is wrong in type or size, copied from elsewhere, nudged; a key renamed, added; a list made longer, shorter,
  /// reversed.
  [[nodiscard]] Json damaged(Json document);

  /// The text with one to three changes of its bytes: flipped, cut out, doubled, replaced by NUL or by bytes that are
  /// not UTF-8; or cut short.
  [[nodiscard]] std::string damaged_text(std::string text);

 private:
  void change(Json& document);
  void change_value(Json& value, const Json& document);
  void change_members(Json& value);
  [[nodiscard]] Json strange_value();
  [[nodiscard]] std::size_t below(std::size_t bound) {
    return static_cast<std::size_t>(random_.bits() % static_cast<std::uint64_t>(bound));
  }

  support::SplitMix random_;
};

/// A report whose digest of the experiment fits again, so that a change of the experiment is not found by the digest
/// alone.
[[nodiscard]] Json sealed(Json report);

}  // namespace rocking::fuzz
