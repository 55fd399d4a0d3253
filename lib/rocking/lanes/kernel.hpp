#pragma once

#include "rocking/lanes/advance.hpp"

namespace rocking::lanes {
namespace {

/// The search for roots takes as long for one as for a register of them: a few lanes that ask for it had better wait for each
/// other. Not on the friction grid, where hardly any step asks for it and they would wait long.
template <Kind kind>
constexpr int fewest_in_doubt(int lanes) {
  return kind == Kind::rock_slide_briefly ? 1 : (lanes + 1) / 2;
}

template <Kind kind, class Real>
void advance_block(Block& block) {
  Advance<kind, Real> lanes(block, 0);
  lanes.begin();
  lanes.expand();
  lanes.look();
  typename Advance<kind, Real>::Search search;
  if (!lanes.has_others() || lanes.doubtful() >= fewest_in_doubt<kind>(Row<Real>::lanes)) {
    lanes.ask(search);
    search.search();
  }
  lanes.finish(search);
}

/// The lanes of two registers in turns: while one's numbers wait for each other, the other's come forward.
template <Kind kind, class Real>
void advance_block_in_turns(Block& block) {
  Advance<kind, Real> first(block, 0);
  Advance<kind, Real> second(block, Row<Real>::lanes);
  first.begin();
  second.begin();
  first.expand();
  second.expand();
  first.look();
  second.look();
  typename Advance<kind, Real>::Search search;
  const bool all_in_doubt = !first.has_others() && !second.has_others();
  if (all_in_doubt || first.doubtful() + second.doubtful() >= fewest_in_doubt<kind>(Row<Real>::lanes)) {
    first.ask(search);
    second.ask(search);
    search.search();
  }
  first.finish(search);
  second.finish(search);
}

template <class Real>
constexpr Kernels kernels_of(std::string_view name) {
  return {.name = name,
          .lanes = Row<Real>::lanes,
          .advance = {advance_block<Kind::rock, Real>, advance_block<Kind::rock_with_friction, Real>,
                      advance_block<Kind::rock_slide, Real>, advance_block<Kind::rock_slide_briefly, Real>}};
}

template <class Real>
constexpr Kernels kernels_in_turns(std::string_view name) {
  return {.name = name,
          .lanes = 2 * Row<Real>::lanes,
          .advance = {advance_block_in_turns<Kind::rock, Real>, advance_block_in_turns<Kind::rock_with_friction, Real>,
                      advance_block_in_turns<Kind::rock_slide, Real>,
                      advance_block_in_turns<Kind::rock_slide_briefly, Real>}};
}

}  // namespace
}  // namespace rocking::lanes
