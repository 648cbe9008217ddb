#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/face_regions.hpp"
#include "gvd/generator_options.hpp"
#include "gvd/given_regions.hpp"
#include "gvd/mesh_objects.hpp"
#include "gvd/object.hpp"
#include "gvd/observer.hpp"
#include "gvd/soup.hpp"

// What the operations that work inside regions share.
namespace gvd {

/// The regions that cells keep to. A diagram on the separated mesh respects them by itself.
struct PartedMesh {
  FaceRegions regions;               ///< empty: all faces are one
  SeparatedMesh separated;           ///< where there are regions
  std::vector<FaceNumbers> numbers;  ///< of the input's faces: the region, and the labels of coarser levels
  RegionSamples samples;             ///< without points; figures of what was sampled
  std::size_t levels = 0;            ///< of a segmentation, whose last one's labels are among the numbers of a result

  bool is_parted() const { return !regions.empty(); }
  bool is_left_out(FaceId f) const { return is_parted() && regions[f] < 0; }
  std::int64_t count_regions() const;
  std::int64_t count_left_out() const;  ///< faces
  /// The mesh of diagrams and distances, which has the input's faces, with the vertices on borders of regions doubled:
  /// surface points are those of both.
  const Mesh& surface(const Mesh& input) const { return is_parted() ? separated.mesh : input; }
  /// The vertex of the input that a vertex of the surface is, or is a copy of.
  VertexId input_vertex(VertexId v) const { return is_parted() ? separated.input_vertex[v] : v; }
  /// A diagram of the surface, with the vertices of the input alone.
  std::shared_ptr<const Diagram> on_input(std::shared_ptr<const Diagram> diagram) const;
};

/// The regions that are given, not yet separated. Throws what find_regions throws.
PartedMesh find_parted(const CheckedMesh& input, const GivenRegions& given, Observer& observer);

/// Separates the regions, where there are any.
void separate(const Mesh& input, PartedMesh& parted, Observer& observer);

/// Samples generators in each region, and notes how many have some. `each`: the number is that of each region.
std::vector<SurfacePoint> sample_inside(PartedMesh& parted, const SamplingOptions& sampling, bool each,
                                        Observer& observer);

/// As choose_generators, inside the regions; listed points on their borders are moved into one. Throws what that,
/// sample_regions and move_into_regions throw.
ResolvedGenerators choose_inside(const CheckedMesh& input, PartedMesh& parted, const GeneratorOptions& asked,
                                 const DiagramOptions& diagram, bool each, Observer& observer);

/// Where the points of a list are on a surface that is parted into regions.
struct PlacedPoints {
  std::vector<SurfacePoint> places;  ///< of the points, one point after the other
  std::vector<std::int32_t> point;   ///< whose place each one is
};

/// The places of points of the input. A point on the border of regions has one in each of those, since it belongs to
/// all of them; a point in faces that are left out has none.
PlacedPoints place_points(const Mesh& input, const PartedMesh& parted, const std::vector<SurfacePoint>& points);

/// "; 3 faces are left out" for a note; empty where none is.
std::string describe_left_out(const PartedMesh& parted);

/// The figures of regions, which are empty without any. `kept`: what they are to a result.
void visit_regions(ObjectVisitor& visitor, const PartedMesh& parted, const char* kept);
/// The same for cells, with the figures of what was sampled.
void visit_parted(ObjectVisitor& visitor, const PartedMesh& parted);

}  // namespace gvd
