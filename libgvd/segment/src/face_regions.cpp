// Regions of faces, from numbers of faces or vertices.
//
// Atlases have labels of vertices. A face takes the number that most of its corners have, so a border between labels
// runs along edges near that of the vertices; where all three differ, the least number decides. A mask is read in the
// same way, as 0 and 1. A face that would be a region's only one there, for no better reason than the least number or a
// mask beside it, joins a neighbour: else it would be a connected part of its own, with a generator of its own.
#include "gvd/face_regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gvd/error.hpp"
#include "gvd/read_values.hpp"
#include "gvd/text.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// The most frequent one of three, of equals the least.
template <class T>
T majority(T a, T b, T c) {
  if (a == b || a == c) return a;
  return b == c ? b : std::min({a, b, c});
}

/// A number for each face, out of those of faces or vertices.
std::vector<double> to_faces(const Mesh& mesh, const SoupProperty& numbers) {
  const char* const element = numbers.of_vertices ? "vertex" : "face";
  const std::vector<double>& values = numbers.values;
  if (const auto wanted = numbers.of_vertices ? mesh.vertex_count() : mesh.face_count(); std::ssize(values) != wanted) {
    throw Error(ErrorCode::precondition,
                fmt::format("{}; give one for each {} ({})", counted(std::ssize(values), "number", "numbers"), element,
                            wanted));
  }
  for (std::int64_t i = 0; i < std::ssize(values); ++i) {
    if (std::isnan(values[i])) throw Error(ErrorCode::precondition, fmt::format("{} {} has no number", element, i), i);
  }
  if (!numbers.of_vertices) return values;
  std::vector<double> of_faces;
  for (const FaceId f : mesh.faces()) {
    const auto& [a, b, c] = mesh.vertices(f);
    of_faces.push_back(majority(values[a.index()], values[b.index()], values[c.index()]));
  }
  return of_faces;
}

/// Gives each face for which `may_change` holds, and beside which no face has the same region, that of the neighbour
/// across its longest side. Faces that are left out are no neighbours.
template <class MayChange>
void join_single_faces(const Mesh& mesh, FaceRegions& regions, const MayChange& may_change) {
  for (const FaceId f : mesh.faces()) {
    if (regions[f] < 0 || !may_change(f)) continue;
    std::int32_t joined = regions[f];
    double longest = 0;
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      const HalfedgeId twin = mesh.twin(h);
      const std::int32_t beside = twin.valid() ? regions[Mesh::face(twin)] : -1;
      if (beside == regions[f]) longest = kInfinity;
      if (beside < 0 || !(mesh.length(h) > longest)) continue;
      longest = mesh.length(h);
      joined = beside;
    }
    if (longest < kInfinity) regions[f] = joined;
  }
}

/// The values of the mesh's vertices, where the file has none for the midpoints of split edges.
std::vector<double> to_vertices(const CheckedMesh& input, const std::vector<double>& values) {
  std::vector<double> of_mesh;
  for (const VertexId v : input.mesh.vertices()) {
    double value = std::numeric_limits<double>::infinity();
    if (const std::int32_t given = input.input_vertex[v]; given >= 0) value = values[given];
    of_mesh.push_back(value);
  }
  // Only numbers of the file are passed on: midpoints may have midpoints beside them.
  for (const VertexId v : input.mesh.vertices()) {
    if (input.input_vertex[v] >= 0) continue;
    for_each_neighbour(input.mesh, v, [&](VertexId u, HalfedgeId) {
      if (input.input_vertex[u] >= 0) of_mesh[v.index()] = std::min(of_mesh[v.index()], of_mesh[u.index()]);
    });
  }
  return of_mesh;
}

}  // namespace

FaceRegions to_regions(const IdVector<FaceId, GeneratorId>& labels) {
  FaceRegions regions;
  for (const GeneratorId label : labels) regions.push_back(label.value());
  return regions;
}

std::string level_name(std::size_t level) { return fmt::format("label_{}", level); }

std::vector<FaceNumbers> carry_to_cut_faces(const std::vector<FaceNumbers>& numbers, const CutMesh& cut) {
  std::vector<FaceNumbers> carried;
  for (const FaceNumbers& given : numbers) {
    carried.push_back({given.name, {}});
    for (const FaceId parent : cut.parent) carried.back().values.push_back(given.values[parent]);
  }
  return carried;
}

FaceRegions make_face_regions(const Mesh& mesh, const SoupProperty& numbers) {
  FaceRegions regions;
  using Limits = std::numeric_limits<std::int32_t>;
  for (const double value : to_faces(mesh, numbers)) {
    if (!(value >= Limits::min() && value <= Limits::max() && value == std::floor(value))) {
      throw Error(ErrorCode::precondition,
                  fmt::format("the region of face {} is {}; give whole numbers of 32 bits", regions.size(), value),
                  regions.count());
    }
    regions.push_back(std::int32_t(value));
  }
  if (!numbers.of_vertices) return regions;
  join_single_faces(mesh, regions, [&](FaceId f) {
    const auto& [a, b, c] = mesh.vertices(f);
    const double x = numbers.values[a.index()], y = numbers.values[b.index()], z = numbers.values[c.index()];
    return x != y && y != z && z != x;
  });
  return regions;
}

void mask_regions(const Mesh& mesh, const SoupProperty& mask, FaceRegions& regions) {
  SoupProperty flags = mask;
  // Any two numbers but 0 count as one, so that the majority of corners is that of "not 0"; to_faces refuses NaN.
  for (double& value : flags.values) value = value == 0 || std::isnan(value) ? value : 1;
  const std::vector<double> left_out = to_faces(mesh, flags);
  for (const FaceId f : regions.ids()) {
    if (left_out[f.index()] != 0) regions[f] = -1;
  }
  if (flags.of_vertices) {
    join_single_faces(mesh, regions, [&](FaceId f) {
      return std::ranges::any_of(mesh.vertices(f), [&](VertexId v) { return flags.values[v.index()] != 0; });
    });
  }
  if (std::ranges::any_of(regions, [](std::int32_t region) { return region >= 0; })) return;
  throw Error(ErrorCode::precondition, "no face is left; the faces whose number is not 0 are left out");
}

void update_numbers(const FaceRegions& regions, FaceRegions& given) {
  for (const FaceId f : regions.ids()) {
    if (regions[f] >= 0) given[f] = regions[f];
  }
}

SoupProperty to_region_numbers(const CheckedMesh& input, const ElementValues& given) {
  const std::vector<double>& values = given.soup.values;
  if (given.of_mesh) return given.soup;
  if (given.soup.of_vertices) return SoupProperty{true, to_vertices(input, values)};
  SoupProperty of_faces{false, {}};
  for (const std::int32_t p : input.input_polygon) of_faces.values.push_back(values[p]);
  return of_faces;
}

}  // namespace gvd
