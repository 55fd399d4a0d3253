#pragma once

#include "rocking/lanes/end.hpp"
#include "rocking/lanes/move.hpp"

namespace rocking::lanes {
namespace {

template <Kind kind, class Real>
void move_block(Block& block) {
  Move<kind, Real>(block).run();
}

template <Kind kind, class Real>
void end_block(Block& block) {
  End<kind, Real>(block).run();
}

template <class Real>
constexpr Kernels kernels_of(std::string_view name) {
  return {.name = name,
          .lanes = Row<Real>::lanes,
          .move = {move_block<Kind::rock, Real>, move_block<Kind::rock_with_friction, Real>,
                   move_block<Kind::rock_slide, Real>, move_block<Kind::rock_slide_briefly, Real>},
          .end = {end_block<Kind::rock, Real>, end_block<Kind::rock_with_friction, Real>,
                  end_block<Kind::rock_slide, Real>, end_block<Kind::rock_slide_briefly, Real>}};
}

}  // namespace
}  // namespace rocking::lanes
