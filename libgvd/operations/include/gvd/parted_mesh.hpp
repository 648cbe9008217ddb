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

// Meshes that are separated into regions, and the steps that operations inside regions share.
namespace gvd {

/// A mesh separated into regions. Cells and paths on the separated mesh never leave a region.
struct PartedMesh {
  FaceRegions regions;               ///< empty: all faces are one region
  SeparatedMesh separated;           ///< only with regions
  std::vector<FaceNumbers> numbers;  ///< for the input's faces: the region, and the labels of coarser levels
  RegionSamples samples;             ///< figures of the sampling; without the points
  std::size_t levels = 0;            ///< number of levels of a segmentation

  bool is_parted() const { return !regions.empty(); }
  bool is_left_out(FaceId f) const { return is_parted() && regions[f] < 0; }
  std::int64_t count_regions() const;
  std::int64_t count_left_out() const;  ///< number of faces
  /// The mesh for diagrams and distances. It has the input's faces, but vertices on borders of regions have several
  /// copies, so a surface point of one mesh is also a surface point of the other.
  const Mesh& surface(const Mesh& input) const { return is_parted() ? separated.mesh : input; }
  /// The vertex of the input for a vertex of the surface, which may be a copy.
  VertexId input_vertex(VertexId v) const { return is_parted() ? separated.input_vertex[v] : v; }
  /// Reduces a diagram of the surface to the vertices of the input.
  std::shared_ptr<const Diagram> on_input(std::shared_ptr<const Diagram> diagram) const;
};

/// Finds the given regions, without separating the mesh. Throws what `find_regions` throws.
PartedMesh find_parted(const CheckedMesh& input, const GivenRegions& given, Observer& observer);

/// Separates the regions, if there are any.
void separate(const Mesh& input, PartedMesh& parted, Observer& observer);

/// Samples generators in each region, and notes how many regions have some. `each`: the number of generators is per
/// region.
std::vector<SurfacePoint> sample_inside(PartedMesh& parted, const SamplingOptions& sampling, bool each,
                                        Observer& observer);

/// Chooses generators as `choose_generators` does, but inside the regions. Moves listed points on borders into a
/// region. Throws what `choose_generators`, `sample_regions` and `move_into_regions` throw.
ResolvedGenerators choose_inside(const CheckedMesh& input, PartedMesh& parted, const GeneratorOptions& asked,
                                 const DiagramOptions& diagram, bool each, Observer& observer);

/// The places of a list of points on a surface that is separated into regions.
struct PlacedPoints {
  std::vector<SurfacePoint> places;  ///< all places of the first point, then of the second, and so on
  std::vector<std::int32_t> point;   ///< for each place, the number of its point
};

/// Finds the places of points of the input. A point on a border belongs to several regions and has a place in each; a
/// point in faces that are left out has no place.
PlacedPoints place_points(const Mesh& input, const PartedMesh& parted, const std::vector<SurfacePoint>& points);

/// "; 3 faces are left out" for a note; empty if none is left out.
std::string describe_left_out(const PartedMesh& parted);

/// Visits the figures of regions, which are empty without regions. `kept` says what stays inside the regions.
void visit_regions(ObjectVisitor& visitor, const PartedMesh& parted, const char* kept);
/// Visits the figures of regions of cells, with the figures of the sampling.
void visit_parted(ObjectVisitor& visitor, const PartedMesh& parted);

}  // namespace gvd
