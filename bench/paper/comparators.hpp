#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/io/view.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd::paper {

/// What a comparator leaves wrong, counted and not repaired. Zero is the normal case.
struct Faults {
  /// Components of cells without their generator: the orphans of [28].
  std::int64_t islands = 0;
  double island_area = 0;  ///< square mesh units
  /// Generators that do not lie in their own cell.
  std::int64_t lost_generators = 0;
  /// Ends of bisectors that nothing continues, inside the mesh.
  std::int64_t open_ends = 0;
  /// Faces whose bisectors were joined without a rule of the method: its cap, or no valid branch point.
  std::int64_t forced_faces = 0;
  /// Vertices at which the distances or the heat underflow, so that no cell owns them.
  std::int64_t unreached_vertices = 0;
  double unowned_area = 0;  ///< of pieces without a generator, square mesh units
};

/// What a comparator returns.
struct Comparison {
  /// Filled in: generators, vertex_label, face_label, pieces, bisectors, length; area, components and neighbours of the
  /// cells. Empty: vertex_distance, branch_points, and the other members of the cells. So `compute_error_measure` can
  /// judge it, `check_diagram` can not. Bisectors have no branch points at their ends.
  Diagram diagram;
  double field_ms = 0;    ///< processor time of the distances, or of what stands for them
  double diagram_ms = 0;  ///< processor time of the cells and bisectors, without the collection of `diagram`
  int rounds = 1;         ///< how often cells were computed
  Faults faults;
};

/// A method that the paper compares itself with (sections 2.2 and 5.3 to 5.5), or one of ours beside it.
struct Comparator {
  std::string name;
  std::function<Comparison(const Mesh&, const std::vector<SurfacePoint>&)> run;
};

struct WindowVoronoiOptions {
  /// Whether each generator's windows are propagated over the whole mesh, without pruning by the other generators: what
  /// an algorithm like MMP does. The diagram is the same; time and memory are not.
  bool unpruned = false;
};

/// The geodesic Voronoi diagram from exact windows, with straight segments.
///
/// Source: C. Xu, Y.-J. Liu, Q. Sun, J. Li, Y. He, Polyline-sourced geodesic Voronoi diagrams on triangle meshes, 2014:
///   [27] in the paper, section 5.3.
/// All windows that enter a triangle are kept, and with its corners they are weighted points in its plane. Crossings
/// lie where their lower envelope changes generators along an edge. `WeightedFace` joins them in the triangle.
/// `field_ms`: the window propagation; `diagram_ms`: crossings and pieces. Generators may lie anywhere: they become
/// vertices first, which counts for neither. Faults: forced faces. One thread.
Comparison compute_window_voronoi(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                  const WindowVoronoiOptions& options = {});

struct DiffusionOptions {
  /// Time step, in squared mean edge lengths, > 0. 1 is what [7] and [8] recommend; more is smoother.
  double time_factor = 1;
  /// How often a face may be split in four around points where several cells meet, 0 to 12.
  int most_splits = 5;
};

/// The diffusion diagram: the cell of a generator is where most heat comes from it.
///
/// Source: P. Herholz, F. Haase, M. Alexa, Diffusion diagrams: Voronoi cells and centroids from diffusion, 2017: [8] in
///   the paper, section 5.4.
/// Two things differ from the account of section 5.4. Heat is compared, not distance. A face is split until its corners
/// and midpoints have two labels, not until anything is linear.
/// `field_ms`: matrix, factorisation, and a solution for each generator; `diagram_ms`: labels and envelopes. Faults:
/// faces in which the cap ended the split, and vertices that no heat reaches (HeatField says when). Generators may lie
/// anywhere: they become vertices first. Throws Error{invalid_option} if an option is out of its range.
Comparison compute_diffusion(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                             const DiffusionOptions& options = {});

/// The localized restricted Voronoi diagram: every cell is the component with its generator, and what lies in islands
/// is divided among the cells around.
///
/// Source: D.-M. Yan, G. Bao, X. Zhang, P. Wonka, Low-resolution remeshing using the localized restricted Voronoi
///   diagram, 2014: [28] in the paper, section 5.5.
/// A round clips the pieces of each island by the bisector planes between the cells that touch it, of which only
/// components with a generator count. Parts that still do not touch their own cell are islands of the next round.
/// [28] clusters locally before it clips, and has bisectors of straight distances everywhere. Here a border between two
/// islands can stay where both are divided: then it is no bisector of the cells on its sides.
/// `rounds`: the number of sweeps, at most `most_rounds`; 0 leaves the restricted Voronoi diagram as it is. An island
/// that no cell touches stays, and is counted: it lies on a component of the mesh without a generator. Generators may
/// lie anywhere.
Comparison compute_lrvd(const Mesh& mesh, const std::vector<SurfacePoint>& generators, int most_rounds = 100);

struct ComparatorOptions {
  DiffusionOptions diffusion;
  /// Whether to list the windows of each generator for itself too, which takes m times the time and the memory.
  bool unpruned_windows = true;
};

/// The library's methods first: exact, growth with circle fronts, growth with planar fronts, the paper's steps as
/// written. Then the comparators: exact windows with straight segments [27], the same unpruned, diffusion [8], RVD
/// [29], LRVD [28]. All use one thread.
std::vector<Comparator> list_comparators(const ComparatorOptions& options = {});

/// Those of list_comparators with these names, in their order here; all of them without names.
/// Throws Error{invalid_option} for a name that the list does not have.
std::vector<Comparator> pick_comparators(const std::vector<std::string>& names, const ComparatorOptions& options = {});

/// A scene of a comparator's diagram, which has no distances and no branch points: figures 10 and 11 as pictures. The
/// mesh must outlive the scene. Its figures are the length of the bisectors and the faults.
ViewScene make_comparison_scene(std::string name, const Mesh& mesh, const Comparison& comparison);

/// Gives each cell the neighbours that it has in any of the scenes, which have the same generators. Colours follow from
/// the neighbours, so that a cell has one colour in all scenes.
void share_neighbours(std::vector<ViewScene>& scenes);

}  // namespace gvd::paper
