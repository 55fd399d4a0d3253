#pragma once

#include "rocking/lanes/advance.hpp"

namespace rocking::lanes {
namespace {

template <Kind kind, class Real>
void advance_block(Block& block) {
  Advance<kind, Real>(block).run();
}

template <class Real>
constexpr Kernels kernels_of(std::string_view name) {
  return {.name = name,
          .lanes = Row<Real>::lanes,
          .advance = {advance_block<Kind::rock, Real>, advance_block<Kind::rock_with_friction, Real>,
                      advance_block<Kind::rock_slide, Real>, advance_block<Kind::rock_slide_briefly, Real>}};
}

}  // namespace
}  // namespace rocking::lanes
