#pragma once

#include "rocking/dynamics/contact.hpp"
#include "rocking/section/period.hpp"

namespace rocking {

/// The state at an instant of the section, and the contact state then.
struct SectionState {
  section::StrobePoint point;
  dynamics::ContactState contact = dynamics::ContactState::rest;
};

}  // namespace rocking
