#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/io/labelled_mesh.hpp"
#include "gvd/mesh.hpp"
#include "gvd/sampling.hpp"
#include "gvd/segment.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

// Diagrams inside given regions: no cell crosses the border of a region, and distances are those of paths inside it.
namespace gvd {

struct ElementValues;

/// The region of each face, by a number from 0 on. A face with a negative number is left out: no generator reaches it.
using FaceRegions = IdVector<FaceId, std::int32_t>;

/// Orders regions by their numbers, with the faces that are left out behind all others.
inline std::uint32_t order_of(std::int32_t region) { return region < 0 ? ~0U : std::uint32_t(region); }

/// The regions of labels: an unlabelled face is left out.
FaceRegions to_regions(const IdVector<FaceId, GeneratorId>& labels);

/// Regions from a number for each vertex or each face of `mesh`. Of the numbers of its three corners, a face takes the
/// one that occurs most often, of equals the least. If all three differ, and no face beside it has that number, it
/// takes that of the neighbour across its longest side: no single face is a part of its own.
/// Throws Error{precondition} where the number of values differs, or one is no whole number of 32 bits. Cost: O(n).
FaceRegions make_face_regions(const Mesh& mesh, const SoupProperty& numbers);

/// Leaves the faces out whose number is not 0. Of vertices, the majority decides as for `make_face_regions`. A face
/// with a corner that is not 0, and no neighbour of its region left, joins another one.
/// Throws Error{precondition} where the number of values differs, one is no number, or no face is left. Cost: O(n).
void mask_regions(const Mesh& mesh, const SoupProperty& mask, FaceRegions& regions);

/// Replaces what was given for the faces that are in a region by their region: a mask may have changed it.
void update_numbers(const FaceRegions& regions, FaceRegions& given);

/// Numbers of the elements of the input, or of its mesh, for those of its mesh. The midpoint of a split edge, which the
/// file does not know, takes the least number of its neighbours.
SoupProperty to_region_numbers(const CheckedMesh& input, const ElementValues& given);

/// A mesh whose regions do not touch.
struct SeparatedMesh {
  Mesh mesh;                                  ///< the faces of the input, in their order, with their corners in order
  std::int32_t input_vertices = 0;            ///< number of the input's vertices, which come first
  IdVector<VertexId, VertexId> input_vertex;  ///< that each vertex is, or is a copy of
};

/// Doubles the vertices on the borders of regions: each connected part of a region becomes a component of its own, and
/// its border a boundary. The faces that are left out are one more region.
///
/// Properties: (1) faces keep their ids and corners, so that a surface point is one of both meshes, with the same
/// position; (2) parts of a region that meet at a vertex only come apart there; (3) of the faces at a vertex of the
/// input, those of the least region keep it, and those that are left out come last; of two parts of that region, the
/// one with the least face; (4) one region of all faces gives the input, unchanged.
/// Throws Error{precondition} where there is not one region for each face. Cost: O(n).
SeparatedMesh separate_regions(const Mesh& mesh, const FaceRegions& regions);

/// The diagram of `separated` with the labels and distances of the input's vertices alone: on borders those of the
/// least region. Other than that of `separated`, it can be written with the input.
Diagram restrict_to_input(const SeparatedMesh& separated, Diagram diagram);

struct RegionSamplingOptions {
  SamplingOptions sampling;  ///< `count`: of all generators, unless `each_region`
  bool each_region = false;  ///< `count` generators in each region
};

/// Generators inside regions.
struct RegionSamples {
  std::vector<SurfacePoint> points;  ///< by region, and in a region by part, in the order of its first face
  std::int32_t regions = 0;
  std::int32_t parts = 0;        ///< connected parts of regions
  std::int32_t empty_parts = 0;  ///< parts without a generator, because a region has more parts than generators
};

/// Samples each connected part of a region as a mesh of its own, with the same seed: no part depends on another one.
///
/// Counts are proportional to areas, rounded by the largest remainder. Each region has at least one generator, and each
/// part of a region too where `count` allows that; otherwise the largest parts have one each. In a part without area,
/// farthest points replace random ones. Sampling::covering_radius covers each part.
///
/// Throws Error{precondition} if there are fewer generators than regions, or no face is in a region; and what
/// `sample_generators` throws, with the number of the region. Cost: that of `sample_generators` in each part.
RegionSamples sample_regions(const SeparatedMesh& separated, const FaceRegions& regions,
                             const RegionSamplingOptions& options);

/// Moves points on borders into the least region there, so that each is seen from a face of it.
/// Throws Error{precondition} that names a point whose faces are all left out. Cost: O(valence) each.
void move_into_regions(const Mesh& mesh, const FaceRegions& regions, std::vector<SurfacePoint>& points);

struct LevelOptions {
  RegionSamplingOptions generators;
  DiagramOptions diagram;
  SegmentOptions labels;
};

/// The labels of the mesh's faces by generators that are sampled inside its regions; without regions, on the whole mesh
/// as `sample_generators` does. To be the regions of the next level of a hierarchy. Throws what its steps throw.
IdVector<FaceId, GeneratorId> label_level(const Mesh& mesh, const FaceRegions& regions, const LevelOptions& options);

/// The names of the numbers that files have for each face beside its label.
inline constexpr const char* kRegionName = "region";
std::string level_name(std::size_t level);  ///< of the labels of a level, from 1 on

/// Numbers of the input's faces for those of `cut`. Cost: O(n) for each.
std::vector<FaceNumbers> carry_to_cut_faces(const std::vector<FaceNumbers>& numbers, const CutMesh& cut);

/// `total` in whole shares proportional to `weights`, none below that of `least`: rounded by the largest remainder, of
/// equal ones for the first. The sum of `least` is at most `total`. Without weight the shares are even.
/// Cost: O(n^2) at worst, O(n log n) where few shares are raised to the least.
std::vector<std::int64_t> share_out(std::int64_t total, const std::vector<double>& weights,
                                    const std::vector<std::int64_t>& least);

}  // namespace gvd
