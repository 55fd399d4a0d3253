#pragma once

#include <string_view>

#include "analysis/figure.hpp"
#include "rocking/section/response_mode.hpp"

namespace rocking::analysis {

/// How a response mode looks in every figure. Colours are those of Okabe and Ito (2008), which those who see fewer colours
/// tell apart too; hatching, dashes and markers tell them apart in grey. Distinct for rest, chaotic, overturned, unresolved,
/// (1,1), (1,2), (1,3), (1,4), (1,5); other (m,n) share five further looks.
[[nodiscard]] Style style_of(const section::ResponseMode& mode);

/// Of responses that are too rare to be shown one by one.
[[nodiscard]] Style style_of_others();

/// How a state of contact is shaded behind a time history: `rest`, `slide`, `rock`, `rock_slide`, `overturned`.
[[nodiscard]] Style style_of_contact(std::string_view contact);

/// The `number`-th of several curves of one kind, counted from 0; the eighth looks like the first.
[[nodiscard]] Style style_of_curve(std::size_t number);

}  // namespace rocking::analysis
