#pragma once

#include <cstdint>
#include <vector>

#include "gvd/surface_point.hpp"
#include "piece_contacts.hpp"

namespace gvd::paper {

/// The connected components of all cells.
struct CellParts {
  std::vector<std::int32_t> part_of;   ///< [piece] its component, numbered from 0 in the order of their first pieces
  std::vector<GeneratorId> generator;  ///< [component] its label; invalid where no cell owns it
  std::vector<char> has_generator;     ///< [component] whether the generator lies in it
  std::vector<double> area;            ///< [component] square mesh units

  /// A component of a cell without its generator.
  bool is_island(std::int32_t part) const {
    const auto i = static_cast<std::size_t>(part);
    return generator[i].valid() && has_generator[i] == 0;
  }
};

/// Pieces of one label with a contact belong to one component. Cost: O(pieces + contacts).
CellParts find_cell_parts(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const Pieces& pieces,
                          const std::vector<Contact>& contacts);

}  // namespace gvd::paper
