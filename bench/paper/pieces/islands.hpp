#pragma once

#include <cstdint>
#include <vector>

#include "gvd/surface_point.hpp"
#include "pieces/piece_contacts.hpp"

namespace gvd::paper {

/// Smaller components are no islands: a fraction of the mesh's area. Where three generators are equally far from a
/// vertex, rounding leaves its label a triangle of some 1e-12 edges.
inline constexpr double kLeastIsland = 1e-12;

/// The connected components of all cells.
struct CellParts {
  std::vector<std::int32_t> part_of;   ///< [piece] its component, numbered from 0 in the order of their first pieces
  std::vector<GeneratorId> generator;  ///< [component] its label; invalid where no cell owns it
  std::vector<char> has_generator;     ///< [component] whether the generator lies in it
  std::vector<double> area;            ///< [component] square mesh units

  double total_area = 0;  ///< of all components

  /// A component of a cell without its generator, larger than kLeastIsland.
  bool is_island(std::int32_t part) const {
    const auto i = static_cast<std::size_t>(part);
    return generator[i].valid() && has_generator[i] == 0 && area[i] > kLeastIsland * total_area;
  }
};

/// Pieces of one label with a contact belong to one component. Cost: O(pieces + contacts).
CellParts find_cell_parts(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const Pieces& pieces,
                          const std::vector<Contact>& contacts);

}  // namespace gvd::paper
