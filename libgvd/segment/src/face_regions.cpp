// Makes regions of faces from numbers of faces or vertices.
//
// Atlases label vertices. A face takes the number that most of its corners have, so the border between two regions runs
// along edges near the border between the vertices; if all three corners differ, the least number decides. A mask is
// read in the same way, as 0 and 1. The least number or a mask can leave a single face cut off from the rest of its
// region. Such a face joins a neighbour, because otherwise it would be a connected part of its own, with a generator of
// its own.
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

/// The most frequent of three values; if all differ, the least.
template <class T>
T majority(T a, T b, T c) {
  if (a == b || a == c) return a;
  return b == c ? b : std::min({a, b, c});
}

/// Converts numbers of faces or vertices to numbers of faces.
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

/// Moves each face that has no neighbour in its own region into the region of the neighbour across its longest side, if
/// `may_change` holds for the face. Faces that are left out do not count as neighbours.
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

/// Converts values of the file's vertices to values of the mesh's vertices, including the midpoints of split edges.
std::vector<double> to_vertices(const CheckedMesh& input, const std::vector<double>& values) {
  std::vector<double> of_mesh;
  for (const VertexId v : input.mesh.vertices()) {
    double value = std::numeric_limits<double>::infinity();
    if (const std::int32_t given = input.input_vertex[v]; given >= 0) value = values[given];
    of_mesh.push_back(value);
  }
  // Takes only numbers of the file, because a midpoint may have midpoints as neighbours.
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
  // All numbers other than 0 become 1, so that corners with different numbers count together; to_faces refuses NaN.
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
