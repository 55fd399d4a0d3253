#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "rocking/fields/value_type.hpp"
#include "rocking/realisation/measures.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/shaking.hpp"

/// Events as people write and read them.
namespace rocking {

/// `overturning`, `tilt > 0.5 psi`, `slip > 0.05 m`, `displacement > 0.05 m`, as read_event() takes it.
[[nodiscard]] std::string event_text(const ResponseEvent& event);

/// What is wrong with a text, and what would do.
struct NoEvent {
  std::string reason;
  std::string remedy;
};
[[nodiscard]] std::variant<ResponseEvent, NoEvent> read_event(std::string_view text);

/// A tilt in degrees or radians as a share of psi, which all blocks of the conditions must have in common; other events as
/// they are. Throws base::InputError where they have not, or where it lies beyond balance.
[[nodiscard]] ResponseEvent in_units_of_balance(const ResponseEvent& event, const std::vector<Condition>& conditions);

/// Throws base::InputError where slip is asked of a block that cannot slide.
void check_friction(const ResponseEvent& event, const Condition& condition);

/// In questions: the same text.
[[nodiscard]] const ValueType& event_text_type();
/// The threshold of a peak tilt, slip or displacement; null: the event is another one. Sets the event where it is read.
[[nodiscard]] const ValueType& threshold_type(EventName name);

/// `overturning`, `a peak tilt above 0.5 psi`, `sliding more than 0.05 m`, `a displacement above 0.05 m`: what has a
/// probability or a rate.
[[nodiscard]] std::string words_of(const ResponseEvent& event);
/// `overturned`, `tilt > 0.5 psi`, `slip > 0.05 m`: heading of a column.
[[nodiscard]] std::string column_of(const ResponseEvent& event);

/// What the block does: `overturns`, `tilts beyond 0.5 psi`, `slides more than 0.05 m`, `ends more than 0.05 m away`.
[[nodiscard]] std::string does(const ResponseEvent& event);
/// The same without the third person, `overturn`, and in the past, `overturned`.
[[nodiscard]] std::string to_do(const ResponseEvent& event);
[[nodiscard]] std::string did(const ResponseEvent& event);
/// Behind these words: ` (6.2 degrees)`, ` (6.2 to 8.9 degrees)` of a tilt that is asked in psi; empty of another event, and
/// where no angle is known.
[[nodiscard]] std::string in_degrees(const ResponseEvent& event, const std::optional<BalanceAngles>& balance);

}  // namespace rocking
