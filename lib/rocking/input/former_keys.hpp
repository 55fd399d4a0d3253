#pragma once

#include "rocking/scene/number_rule.hpp"
#include "rocking/text/json.hpp"

namespace rocking {

/// Gives a former key of an experiment, `accuracy.repeat_every`, its present name, also where a sweep names it. Returns
/// whether it was there. Where both names are given, the former one stays, as an unknown key.
bool rename_former_keys(Json& document);

/// Gives the places of problems the former name again.
void name_former_keys(Problems& problems);

}  // namespace rocking
