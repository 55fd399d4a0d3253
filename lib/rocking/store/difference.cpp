#include "rocking/store/difference.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace rocking {
namespace {

std::string spelled(bool value) { return value ? "1" : "0"; }
std::string spelled(std::uint64_t value) { return std::to_string(value); }
std::string spelled(std::int64_t value) { return std::to_string(value); }
std::string spelled(double value) { return std::to_string(std::bit_cast<std::uint64_t>(value)); }
std::string spelled(const base::Sha256& value) { return base::to_hex(value); }
template <class Named>
std::string spelled(const Named& value) {
  return std::string(to_string(value));
}
template <class Value>
std::string spelled(const std::optional<Value>& value) {
  return value ? spelled(*value) : "none";
}

struct Field {
  std::string name;
  std::string value;
};

std::vector<Field> fields_of(const Summary& summary) {
  std::vector<Field> fields;
  for_each_field(summary, [&fields](const auto& name, const auto& value) { fields.push_back({name, spelled(value)}); });
  return fields;
}

}  // namespace

std::vector<std::string> differing_fields(const Summary& a, const Summary& b) {
  const std::vector<Field> of_a = fields_of(a);
  const std::vector<Field> of_b = fields_of(b);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    if (of_a[i].value != of_b[i].value) names.push_back(of_a[i].name);
  }
  return names;
}

std::vector<Difference> merge(Store& into, const Store& from) {
  std::vector<Difference> conflicts;
  from.for_each([&](const RealisationKey& key, const Summary& summary) {
    const auto known = into.find(key);
    if (!known) return into.add(key, summary);
    const auto fields = differing_fields(*known, summary);
    if (!fields.empty()) conflicts.push_back({key, fields});
  });
  return conflicts;
}

}  // namespace rocking
