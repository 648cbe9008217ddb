#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd::paper {

/// Pieces that cover the faces of a mesh, ascending by face. A face that is not cut is one piece. The generator is
/// invalid where no cell owns the piece. Pieces of one face do not overlap.
using Pieces = std::vector<FacePiece>;

/// A line that two pieces have in common: in a face, or on the edge between two faces.
struct Contact {
  std::int32_t left;            ///< index of the piece on the left from `begin` to `end`
  std::int32_t right;           ///< index of the other piece
  FaceId face;                  ///< of the left piece
  std::array<double, 3> begin;  ///< barycentric coordinates in `face`
  std::array<double, 3> end;
};

/// Contacts shorter than this are left out, and lines closer than this are one: relative to the face or edge.
inline constexpr double kLeastContact = 1e-9;

/// All contacts, each once. Cost: O(n + k) for n pieces and k pairs of sides in faces with several pieces.
std::vector<Contact> find_contacts(const Mesh& mesh, const Pieces& pieces);

}  // namespace gvd::paper
