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

// Diagrams inside given regions: no cell crosses the border of a region, and distances are lengths of paths inside it.
namespace gvd {

struct ElementValues;

/// The region of each face, as a number from 0. A face with a negative number is left out, so no generator reaches it.
using FaceRegions = IdVector<FaceId, std::int32_t>;

/// A sort key that orders regions by their numbers, with the faces that are left out last.
inline std::uint32_t order_of(std::int32_t region) { return region < 0 ? ~0U : std::uint32_t(region); }

/// Uses labels as regions. Unlabelled faces are left out.
FaceRegions to_regions(const IdVector<FaceId, GeneratorId>& labels);

/// Makes regions of a number for each vertex or each face of `mesh`. Given numbers of vertices, a face takes the most
/// frequent number of its three corners; if all three differ, it takes the least, unless no adjacent face has this
/// number. Then the face takes the number of the neighbour across its longest side, so that it does not become a part
/// of its own.
/// Throws Error{precondition} if the number of values is wrong, or a value is no whole number of 32 bits. Cost: O(n).
FaceRegions make_face_regions(const Mesh& mesh, const SoupProperty& numbers);

/// Leaves out the faces whose number is not 0. Given numbers of vertices, the majority of a face's corners decides. A
/// remaining face with a corner that is not 0, and without a remaining neighbour in its region, joins another region.
/// Throws Error{precondition} if the number of values is wrong, a value is NaN, or no face remains. Cost: O(n).
void mask_regions(const Mesh& mesh, const SoupProperty& mask, FaceRegions& regions);

/// Updates the given numbers of all faces that are in a region to this region, which a mask may have changed.
void update_numbers(const FaceRegions& regions, FaceRegions& given);

/// Converts numbers of the input's elements to numbers of its mesh's elements; numbers of the mesh stay as they are.
/// The midpoint of a split edge, which the file does not have, takes the least number of its neighbours.
SoupProperty to_region_numbers(const CheckedMesh& input, const ElementValues& given);

/// A mesh whose regions do not touch.
struct SeparatedMesh {
  Mesh mesh;                                  ///< has the faces of the input, with their order and their corners' order
  std::int32_t input_vertices = 0;            ///< number of the input's vertices, which come first
  IdVector<VertexId, VertexId> input_vertex;  ///< the vertex of the input that each vertex is, or is a copy of
};

/// Copies the vertices on the borders of regions, so that each connected part of a region becomes a component and its
/// border becomes a boundary. The faces that are left out count as one more region.
///
/// Properties: (1) faces keep their ids and corners, so that a surface point is valid in both meshes and has the same
/// position; (2) parts of a region that meet only at a vertex are separated there; (3) the input's vertex stays with
/// the least region at it, and in this region with the part that has the least face; faces that are left out come last;
/// (4) if all faces are in one region, the result is the input, unchanged.
/// Throws Error{precondition} if there is not one region for each face. Cost: O(n).
SeparatedMesh separate_regions(const Mesh& mesh, const FaceRegions& regions);

/// Reduces a diagram of `separated` to the labels and distances of the input's vertices, so that it can be written with
/// the input. A vertex on a border has the values of the least region at it.
Diagram restrict_to_input(const SeparatedMesh& separated, Diagram diagram);

struct RegionSamplingOptions {
  SamplingOptions sampling;  ///< `count`: the number of all generators, unless `each_region` is set
  bool each_region = false;  ///< `count` generators in each region
};

/// Generators inside regions.
struct RegionSamples {
  /// Sorted by region, then by connected part, in the order of the parts' first faces.
  std::vector<SurfacePoint> points;
  std::int32_t regions = 0;
  std::int32_t parts = 0;        ///< number of connected parts of regions
  std::int32_t empty_parts = 0;  ///< parts without a generator, in regions with more parts than generators
};

/// Samples each connected part of a region as a mesh of its own, with the same seed, so that no part depends on
/// another.
///
/// Counts are proportional to areas, rounded by the largest remainder. Each region gets at least one generator, and so
/// does each part of a region if `count` allows it; otherwise the largest parts get one each. In a part without area,
/// farthest points replace random ones. Sampling::covering_radius covers each part.
///
/// Throws Error{precondition} if there are fewer generators than regions, or no face is in a region; and what
/// `sample_generators` throws, with the number of the region. Cost: one call of `sample_generators` for each part.
RegionSamples sample_regions(const SeparatedMesh& separated, const FaceRegions& regions,
                             const RegionSamplingOptions& options);

/// Moves points on borders into the least region at them, by changing their face to a face of this region. Throws
/// Error{precondition} that names a point if all its faces are left out. Cost: O(valence) for each point.
void move_into_regions(const Mesh& mesh, const FaceRegions& regions, std::vector<SurfacePoint>& points);

struct LevelOptions {
  RegionSamplingOptions generators;
  DiagramOptions diagram;
  SegmentOptions labels;
};

/// Labels the mesh's faces by generators sampled inside its regions, or on the whole mesh if there are no regions. The
/// labels can be the regions of the next level of a hierarchy. Throws what its steps throw.
IdVector<FaceId, GeneratorId> label_level(const Mesh& mesh, const FaceRegions& regions, const LevelOptions& options);

/// The names of the numbers that files hold for each face beside its label.
inline constexpr const char* kRegionName = "region";
std::string level_name(std::size_t level);  ///< of the labels of a level; levels begin at 1

/// Gives the faces of `cut` the numbers of their parents. Cost: O(n) for each kind of numbers.
std::vector<FaceNumbers> carry_to_cut_faces(const std::vector<FaceNumbers>& numbers, const CutMesh& cut);

/// Divides `total` into whole shares proportional to `weights`, each at least as large as its number in `least`. Rounds
/// by the largest remainder; among equal remainders the first wins. The sum of `least` must be at most `total`. If all
/// weights are 0, the shares are even.
/// Cost: O(n^2) at worst, O(n log n) if few shares are raised to their least.
std::vector<std::int64_t> share_out(std::int64_t total, const std::vector<double>& weights,
                                    const std::vector<std::int64_t>& least);

}  // namespace gvd
