#pragma once

#include "rocking/scene/keys.hpp"

namespace rocking {

/// The keys of `excitation`, kind by kind. `block`: mean block of the scene.
void keys_of(Keys& in, Excitation& excitation, const dynamics::Block& block);

/// An experiment without its sweep: one condition.
struct Question {
  std::string title;
  std::uint64_t seed = 0;
  Condition condition;
};

/// The keys of an experiment file after `format`, in the order of the canonical text. Reading, the checks of a condition
/// from C++, the schema and the table of keys in lib/docs/formats.md follow from this list. Each value stands by itself;
/// what values demand of each other: check_relations.
void keys_of(Keys& in, Question& question);

}  // namespace rocking
