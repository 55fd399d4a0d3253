#pragma once

#include "rocking/input/ground_motion_files.hpp"
#include "rocking/input/object_reader.hpp"
#include "rocking/scene/keys.hpp"

namespace rocking {

/// What is needed to read a question beside the object in which the keys stand.
struct ReadingContext {
  const Json* sweep;         ///< as it is written; null: none
  GroundMotionFiles* files;  ///< null: none is looked at
};

/// Reads each key from an object of a file, and writes it to the canonical text.
class ReadingKeys final : public Keys {
 public:
  ReadingKeys(ObjectReader& in, const ReadingContext& context) : in_(in), context_(context) {}

  void text(const Key& key, std::string& value) override;
  void number(const Key& key, double& value, const NumberRule& rule, Absent absent) override;
  void whole_number(const Key& key, std::int64_t& value, const IntegerRule& rule, Absent absent) override;
  void numbers(const Key& key, std::vector<double>& values, const ListLength& length, const NumberRule& rule,
               Absent) override;
  void quantity(const Key& key, Quantity& value, const NumberRule& rule, Absent absent) override;
  void word(const Key& key, std::size_t& chosen, std::span<const std::string_view> names, Absent absent) override;
  void words(const Key& key, std::vector<std::size_t>& chosen, std::span<const std::string_view> names) override;
  void forms(const Key& key, Formed& value, std::span<const Form> forms, std::string_view remedy,
             Absent absent) override;
  void mode(const Key& key, std::optional<section::ResponseMode>& value) override;
  void seed(const Key& key, std::uint64_t& value) override;
  void sweep(const Key& key) override;
  void unknowns(const Key& key) override;
  void scatter(std::initializer_list<Scatter> of) override;
  bool one_of(std::span<const UnitKey> units, QuantityInUnit& value, Absent absent) override;
  void record_format(const Key& key, std::optional<RecordFormat>& value) override;
  void file(const Key& file, const Key& digest, std::string& name) override;
  bool suite(const Key& key) override;
  void ground_motion(const GroundMotionReading& how, const std::optional<Strength>& strength,
                     Recorded& recorded) override;

  void object(const Key& key, Absent absent, const Part& part) override;
  void number_or_object(const Key& key, bool is_object, const Part& number, const Part& object) override;
  void kinds(const Key& key, std::span<const std::string_view> names, std::size_t kind,
             const std::function<void(Keys&, std::size_t)>& part) override;

  bool stands(std::string_view key, bool) override { return in_.has(key); }
  [[nodiscard]] bool is_reading() const override { return true; }
  [[nodiscard]] Absent follows_from(std::span<const std::string_view> places) const override;
  void reject(std::string_view key, Refusal refusal) override;
  void exclude(std::string_view key, std::string_view other, Refusal refusal) override;
  void refuse(std::string_view key, std::string_view reason, std::string_view remedy) override;
  [[nodiscard]] std::size_t problem_count() const override { return in_.problems().size(); }

 private:
  void law(const Key& key, Quantity& value, const NumberRule& rule);

  ObjectReader& in_;
  ReadingContext context_;
};

}  // namespace rocking
