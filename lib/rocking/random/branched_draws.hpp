#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rocking/random/draws.hpp"
#include "rocking/random/source.hpp"

namespace rocking::random {

/// The largest number of a source that is drawn along the way.
inline constexpr auto last_source_along_the_way = static_cast<std::size_t>(Source::amplitude);

/// For each of these sources, at its number, the index from which on no draw has been made.
using FirstUnused = std::array<std::uint64_t, last_source_along_the_way + 1>;

/// From these indices on, the normal draws along the way are those of another realisation number, the branch number.
struct Branch {
  std::uint64_t number = 0;
  FirstUnused from{};
};

/// A draw of a source: this number in place of it.
struct GivenDraw {
  Source source;
  double number;
  std::uint64_t index = 0;
};

/// In what the draws of a realisation differ from those of its number.
struct DrawHistory {
  std::vector<GivenDraw> given;
  std::vector<Branch> branches;  ///< in the order in which they were made
};

/// The random numbers of one realisation, with the branches of its history, one after another. Without a history these
/// are the numbers of Draws, to the bit.
class BranchedDraws {
 public:
  /// The history must outlive this object and its copies.
  BranchedDraws(const Draws& draws, const DrawHistory* history = nullptr) : draws_(draws), history_(history) {}

  /// As Draws. Uniform numbers are not changed by branches.
  [[nodiscard]] double uniform(Source source, std::uint64_t index) const;
  [[nodiscard]] double standard_normal(Source source, std::uint64_t index) const;
  void standard_normals(Source source, std::uint64_t first_index, std::span<double> numbers) const;

 private:
  [[nodiscard]] const double* given(Source source, std::uint64_t index) const;
  /// The last branch that draws the number anew, counted from 1; 0 if none does.
  [[nodiscard]] std::size_t last_branch(Source source, std::uint64_t index) const;
  /// Its draws, or those of the realisation.
  [[nodiscard]] Draws origin(Source source, std::uint64_t index) const;

  Draws draws_;
  const DrawHistory* history_;
};

}  // namespace rocking::random
