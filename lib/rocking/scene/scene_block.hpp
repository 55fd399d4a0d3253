#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "rocking/base/number_rule.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/random/source.hpp"
#include "rocking/scene/quantity.hpp"

namespace rocking {

/// Bounds of a width and of a height [m].
inline constexpr double least_length = 1e-6;
inline constexpr double largest_length = 1e6;

/// A rectangle of uniform density.
struct UniformMass {
  friend bool operator==(const UniformMass&, const UniformMass&) = default;
};

/// Numbers beside a width and a height; what is absent is that of a uniform rectangle.
struct GivenCentre {
  std::optional<Quantity> height = std::nullopt;              ///< of the centre of mass above the base [m]
  std::optional<Quantity> offset = std::nullopt;              ///< to the right of the middle of the base [m]
  std::optional<Quantity> radius_of_gyration = std::nullopt;  ///< about the centre of mass [m]
  friend bool operator==(const GivenCentre&, const GivenCentre&) = default;
};

/// Numbers of a body whose outline is not given.
struct GivenEdges {
  std::array<Quantity, 2> edges{0.5, 0.5};  ///< distances of the left and the right edge from the centre of mass [m]
  Quantity centre_height = 2.0;             ///< of the centre of mass above the base [m]
  Quantity radius_of_gyration = 1.0;        ///< about the centre of mass [m]
  friend bool operator==(const GivenEdges&, const GivenEdges&) = default;
};

/// A rectangle of uniform density, one of those that make a body.
struct BlockPart {
  Quantity width = 1.0;   ///< [m]
  Quantity height = 1.0;  ///< [m]
  Quantity mass = 1.0;    ///< [kg]
  Quantity x = 0.0;       ///< of its middle [m]
  Quantity bottom = 0.0;  ///< above the floor [m]
  friend bool operator==(const BlockPart&, const BlockPart&) = default;
};
inline constexpr std::size_t most_parts = 32;

struct GivenParts {
  std::vector<BlockPart> parts;
  /// x of the left and the right end of the base [m]; absent: those of the parts that stand on the floor.
  std::optional<std::array<Quantity, 2>> base = std::nullopt;
  friend bool operator==(const GivenParts&, const GivenParts&) = default;
};

/// Where the mass of a block is, in one of the forms of a file.
using SceneMass = std::variant<UniformMass, GivenCentre, GivenEdges, GivenParts>;

/// Asked for: a rigid block, rectangular and of uniform density unless its mass is laid out otherwise. Each realisation
/// draws the numbers that have laws, and truncates lengths to the bounds.
struct SceneBlock {
  Quantity width = 1.0;   ///< B [m]; not used with edges or parts
  Quantity height = 4.0;  ///< H [m]; likewise
  double gravity = 9.81;  ///< g [m/s^2]
  SceneMass mass = {};
  friend bool operator==(const SceneBlock&, const SceneBlock&) = default;
};

/// Two shapes between which every block of a scene lies.
struct ShapeRange {
  dynamics::Geometry most_slender;  ///< smallest tan(psi) of an edge
  dynamics::Geometry squattest;     ///< largest tan(psi) of an edge
};

/// Two sizes between which every block of a scene lies.
struct SizeRange {
  dynamics::Geometry smallest;  ///< smallest R
  dynamics::Geometry largest;   ///< largest R
};

/// The block with the mean of each number. Its width and height are those of an outline to draw: of given edges a rectangle
/// between them with the centre of mass at half its height, of parts their extent.
[[nodiscard]] dynamics::Block mean_of(const SceneBlock& block);

/// Over the corners of the box in which the drawn numbers lie.
[[nodiscard]] ShapeRange shapes_of(const SceneBlock& block);
[[nodiscard]] SizeRange sizes_of(const SceneBlock& block);

/// A number of a block that may have a law.
struct BlockNumber {
  random::Source source;
  std::string_view name;   ///< in words
  std::string_view place;  ///< JSON pointer into an experiment file
  bool is_length = true;   ///< positive, and truncated to the bounds where it is drawn
};

/// Of number `k` of part `part`, in the order of the members of BlockPart.
[[nodiscard]] BlockNumber part_number(std::size_t part, std::size_t k);

/// Calls visit(BlockNumber, quantity) for each number that the form of the block has.
template <class ABlock, class Visit>
void for_each_block_number(ABlock& block, const Visit& visit) {
  using random::Source;
  auto& [width, height, gravity, mass] = block;
  const auto visit_mass = [&](auto& form) {
    using Form = std::remove_cvref_t<decltype(form)>;
    if constexpr (std::is_same_v<Form, GivenEdges>) {
      auto& [edges, centre_height, radius] = form;
      visit(BlockNumber{Source::left_edge, "distance of the left edge", "/block/edges_m/0"}, edges[0]);
      visit(BlockNumber{Source::right_edge, "distance of the right edge", "/block/edges_m/1"}, edges[1]);
      visit(BlockNumber{Source::centre_height, "height of the centre of mass", "/block/centre_height_m"},
            centre_height);
      visit(BlockNumber{Source::radius_of_gyration, "radius of gyration", "/block/radius_of_gyration_m"}, radius);
    } else if constexpr (std::is_same_v<Form, GivenParts>) {
      for (std::size_t i = 0; i < form.parts.size(); ++i) {
        auto& [part_width, part_height, part_mass, x, bottom] = form.parts[i];
        visit(part_number(i, 0), part_width);
        visit(part_number(i, 1), part_height);
        visit(part_number(i, 2), part_mass);
        visit(part_number(i, 3), x);
        visit(part_number(i, 4), bottom);
      }
      if (!form.base) return;
      visit(BlockNumber{Source::base_left, "left end of the base", "/block/base_m/0", false}, (*form.base)[0]);
      visit(BlockNumber{Source::base_right, "right end of the base", "/block/base_m/1", false}, (*form.base)[1]);
    } else {
      visit(BlockNumber{Source::block_width, "width of the block", "/block/width_m"}, width);
      visit(BlockNumber{Source::block_height, "height of the block", "/block/height_m"}, height);
      if constexpr (std::is_same_v<Form, GivenCentre>) {
        auto& [centre_height, offset, radius] = form;
        if (centre_height) {
          visit(BlockNumber{Source::centre_height, "height of the centre of mass", "/block/centre_height_m"},
                *centre_height);
        }
        if (offset) {
          visit(BlockNumber{Source::centre_offset, "offset of the centre of mass", "/block/centre_offset_m", false},
                *offset);
        }
        if (radius) {
          visit(BlockNumber{Source::radius_of_gyration, "radius of gyration", "/block/radius_of_gyration_m"}, *radius);
        }
      }
    }
  };
  std::visit(visit_mass, mass);
}

/// Whether any number of the block has a law.
[[nodiscard]] bool is_drawn(const SceneBlock& block);

/// Why no rigid body is like this: its centre of mass is not above its base, or its mass would have to lie beyond its
/// outline. Looks at the corners of the drawn numbers.
[[nodiscard]] std::optional<Refusal> refusal_of(const SceneBlock& block);

}  // namespace rocking
