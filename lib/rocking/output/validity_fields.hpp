#pragma once

#include <array>
#include <string>
#include <string_view>

#include "rocking/ensemble/result.hpp"
#include "rocking/fields/converted_type.hpp"

namespace rocking {

struct KindOfCase {
  std::string_view key;
  Cases Validity::*cases;
};

inline constexpr std::array kinds_of_case{KindOfCase{"left_ground", &Validity::left_ground},
                                          KindOfCase{"left_ground_before_fall", &Validity::left_ground_before_fall},
                                          KindOfCase{"painleve", &Validity::painleve},
                                          KindOfCase{"stopped", &Validity::stopped},
                                          KindOfCase{"in_transient", &Validity::in_transient},
                                          KindOfCase{"settled_late", &Validity::settled_late},
                                          KindOfCase{"past_balance", &Validity::past_balance},
                                          KindOfCase{"contradictions", &Validity::contradictions},
                                          KindOfCase{"clamped", &Validity::clamped}};

/// Calls visit(name, cases) for each kind of case, then for each reason for an unresolved response.
template <class SomeValidity, class Visit>
void for_each_case(SomeValidity& validity, const Visit& visit) {
  for (const auto& [key, cases] : kinds_of_case) visit(std::string(key), validity.*cases);
  for (auto& [reason, cases] : validity.unresolved) visit(std::string(to_string(reason)), cases);
}

/// The validity of a ConditionResult as it stands in documents.
[[nodiscard]] const StructType& validity_fields();

/// Its name.
template <>
struct TypeOf<section::Backing> : OnlyType<NamedType<section::Backing, section::backing_names>> {};
template <>
struct TypeOf<section::Reason> : OnlyType<NamedType<section::Reason, section::reason_names>> {};

/// By kind; a kind that is not in every report, only where it is not 0.
template <>
struct TypeOf<Clamps> {
  static const ValueType& get();
};

}  // namespace rocking
