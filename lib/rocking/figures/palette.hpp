#pragma once

#include <string_view>

#include "rocking/figures/figure.hpp"
#include "rocking/section/response_mode.hpp"

namespace rocking::analysis {

/// Style of a response mode in all figures: look_of.
[[nodiscard]] Style style_of(const section::ResponseMode& mode);

/// Style of all responses that are too rare to be shown separately.
[[nodiscard]] Style style_of_others();

/// Shading of a contact state behind a time history: `rest`, `slide`, `rock`, `rock_slide`, `overturned`.
[[nodiscard]] Style style_of_contact(std::string_view contact);

/// Style of curve `number`, counted from 0, of several curves of one kind; number 7 has the style of number 0.
[[nodiscard]] Style style_of_curve(std::size_t number);

/// Of the interval around a curve of this style.
[[nodiscard]] Style ribbon_of(Style style, double opacity = 0.2);

}  // namespace rocking::analysis
