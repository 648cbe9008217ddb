#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "gvd/appearance.hpp"
#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/mesh.hpp"
#include "gvd/names.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// How faces cut by bisectors are labelled.
enum class FaceLabels {
  nearest,  ///< each face by itself, with the cell that has the largest share of it; borders are jagged
  smooth,   ///< so that the borders between regions become short
};
inline const Choices<FaceLabels> kFaceLabelNames{{"smooth", FaceLabels::smooth}, {"nearest", FaceLabels::nearest}};

struct SegmentOptions {
  FaceLabels labels = FaceLabels::smooth;
  Progress progress = {};  ///< may be empty
};

/// A label for every face.
struct Segmentation {
  IdVector<FaceId, GeneratorId> face_label;  ///< invalid where no generator reaches
  std::vector<GeneratorId> without_face;     ///< generators that own no face, ascending
  /// Faces labelled with another cell than that with the largest share, to keep labels connected.
  std::int32_t moved_faces = 0;
  std::int32_t given_faces = 0;     ///< faces given to generators that would otherwise own none
  std::int32_t smoothed_faces = 0;  ///< faces with another label than with FaceLabels::nearest
};

/// Labels the faces of a mesh by the cells of its diagram.
///
/// (a) A face that no bisector cuts gets the label of its cell. A cut face gets the label of the cell with the largest
/// share of its area; among equal shares, the smaller id wins. (b) Each label keeps one connected component: the
/// component with a face of its generator, or otherwise the component with the largest area. The faces of its other
/// components take the label of an adjacent face, preferably that of the cell with the largest share. (c) A generator
/// without a face is given a face of which its cell has a share, preferably the face in which it lies. The label that
/// loses the face must keep another one and stay connected. (d) Smooth labels: cut faces are relabelled so that the
/// borders become short. A face takes only labels of cells with a share of it. Among the faces around a generator that
/// have its label, the face with its largest share keeps the label. This is a minimum multiway cut, which is NP-hard.
/// With two regions the result has the least cost (length and, with little weight, shares); with more regions, no two
/// of them can lower the cost by an exchange that topology permits. See docs/developer/segment-borders.md.
///
/// Properties: (1) the faces of each label are connected through edges; (2) each generator owns a face or is listed in
/// `without_face`; (3) a face has no label exactly where no generator reaches it; (4) smooth borders are not longer
/// than nearest ones, and each region has the same topology as with nearest labels, so discs stay discs.
/// Throws Error{precondition} if the diagram was not made of this mesh, Error{interrupted} if the progress callback
/// cancels. Cost: O(n log n).
Segmentation segment_faces(const Mesh& mesh, const Diagram& diagram, const SegmentOptions& options = {});

/// The length of the edges between faces with different labels, in mesh units. Throws Error{precondition} if there is
/// not one label for each face. Cost: O(n).
double compute_border_length(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& face_label);

/// A mesh in which each face lies in a single cell.
struct CutMesh {
  Mesh mesh;                            ///< vertices of the input first, in their order
  IdVector<FaceId, FaceId> parent;      ///< the face of the input that contains each face; ascending
  IdVector<FaceId, GeneratorId> label;  ///< invalid where no generator reaches
  std::vector<FaceNumbers> numbers;     ///< further numbers of the faces; empty unless the caller adds some
  std::int32_t input_vertices = 0;      ///< number of the input's vertices
  std::int32_t uncut_faces = 0;         ///< faces left uncut because their pieces do not tile them; normally 0
};

/// Splits the faces of a mesh along the bisectors of its diagram.
///
/// If cuts of two faces have the same ends, the result would have an edge with four faces, so each such cut is split by
/// a vertex of its own at its midpoint. If rounding brings two branch points or bisectors together at a vertex, a
/// region would touch itself there, so a corner of its faces at the vertex, up to a thousandth of the edges, goes to
/// the region beside it.
///
/// Properties: (1) the surface is the same set of points, within rounding; (2) the faces on both sides of an edge share
/// the vertices on it, so the result has the topology of the input; (3) faces that no bisector touches do not change,
/// except faces at a vertex as above; (4) if a cell is a disc, then the faces with its label also form a disc as a
/// mesh. Only cells of a given region (`separate_regions`) that touches itself can still touch themselves.
/// Throws Error{precondition} if the diagram was not made of this mesh, Error{no_valid_result} if the result is not a
/// manifold, Error{interrupted} if `progress` cancels. Cost: O(n log n), and O(k^2) in a face with k corners of pieces.
CutMesh cut_faces(const Mesh& mesh, const Diagram& diagram, const Progress& progress = {});

/// The same, and the Error{no_valid_result} is returned.
OrError<CutMesh> try_to_cut_faces(const Mesh& mesh, const Diagram& diagram, const Progress& progress = {});

/// Labels and distances of the vertices of a cut mesh.
struct CutVertices {
  IdVector<VertexId, GeneratorId> label;  ///< a nearest generator; invalid if none reaches the vertex
  IdVector<VertexId, double> distance;    ///< mesh units; infinity if no generator reaches the vertex
};

/// Carries the labels and distances of the vertices of `mesh` over to `cut`. `cut` is the cut of `mesh` along
/// `diagram`. It may also be the cut of the mesh from which `separate_regions` made `mesh`.
///
/// The vertices of the input keep their labels and distances. A new vertex gets the smallest label of its faces, as
/// ties are always broken, and a distance interpolated linearly in the face in which it lies.
/// Throws Error{precondition} if the three do not belong together. Cost: O(n).
CutVertices carry_to_cut_vertices(const Mesh& mesh, const Diagram& diagram, const CutMesh& cut);

/// Carries the appearance of the faces of `mesh` over to `cut`, which is `mesh` cut along a diagram.
///
/// A face has the material of its parent. Texture coordinates are kept at the parent's corners and interpolated
/// linearly elsewhere. On an edge they depend only on the values at its ends: where both sides of an edge agreed they
/// still agree, and no seam is added.
/// Throws Error{precondition} if the three do not belong together. Cost: O(n).
Appearance carry_to_cut_faces(const Mesh& mesh, const Appearance& appearance, const CutMesh& cut);

/// Writes the diagram as `gvd-diagram/1` with one more member, `"face_labels"`: the label of each face, -1 for none. If
/// there are `numbers`, it also has `"face_numbers"`, an object with an array for each. Flushes and checks the stream.
/// Throws Error{unwritable_output}. Cost: O(n).
void write_segmentation_json(std::ostream& out, const Mesh& mesh, const Diagram& diagram,
                             const Segmentation& segmentation, const std::vector<FaceNumbers>& numbers = {});

/// Writes the diagram with the member `"cut_mesh"`: `{"vertices":[[x,y,z]],"faces":[[a,b,c]],"labels":[],"parents":[],
/// "vertex_labels":[],"vertex_distances":[]}`. Labels and parents belong to the faces; an infinite distance is null.
/// With `cut.numbers` it also has `"face_numbers"`. Flushes and checks the stream. Throws Error{unwritable_output}.
/// Cost: O(n).
void write_cut_json(std::ostream& out, const Mesh& mesh, const Diagram& diagram, const CutMesh& cut,
                    const CutVertices& vertices);

/// The size of the faces with one label.
struct RegionSize {
  std::int64_t faces = 0;
  double area = 0;  ///< square mesh units
};

/// Measures each region of a labelled mesh, segmented or cut. `regions` is the number of labels. Throws
/// Error{precondition} if there is not one label for each face, or if a label is out of range. Cost: O(n).
IdVector<GeneratorId, RegionSize> measure_regions(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& face_label,
                                                  std::size_t regions);

}  // namespace gvd
