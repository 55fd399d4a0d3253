#pragma once

#include "rocking/lanes/advance.hpp"

namespace rocking::lanes {
namespace {

template <Kind kind, class Real>
void advance_block(Block& block) {
  Advance<kind, Real> lanes(block, 0);
  lanes.begin();
  lanes.expand();
  lanes.look();
  lanes.finish();
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
  first.finish();
  second.finish();
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
