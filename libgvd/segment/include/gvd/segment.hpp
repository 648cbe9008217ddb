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

/// How faces that bisectors cut are labelled.
enum class FaceLabels {
  nearest,  ///< with the cell that has the largest share: each face by itself, so borders are jagged
  smooth,   ///< so that the borders between regions are short
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
  std::int32_t moved_faces = 0;  ///< faces labelled with a cell that does not have the largest share, for connectivity
  std::int32_t given_faces = 0;  ///< faces given to generators that would own none otherwise
  std::int32_t smoothed_faces = 0;  ///< faces with another label than FaceLabels::nearest gives; 0 with that
};

/// Labels the faces of a mesh by the cells of its diagram.
///
/// (a) A face that no bisector cuts gets the label of its cell. A cut one gets that of the cell with the largest share
/// of its area, of equals the smaller id. (b) Each label keeps one connected component: the one with a face of its
/// generator, or else the one with the largest area. The faces of its other components take the label of an adjacent
/// face, the one with the largest share. (c) A generator without a face is given one that its cell has a share of,
/// first of all the face that it lies in. The label that loses the face must keep another one and stay connected.
/// (d) Smooth labels: cut faces are relabelled so that the borders become short. A face takes only labels of cells with
/// a share of it. Of the faces round a generator with its label, the one with its largest share keeps it. It is a
/// minimum multiway cut, which is NP-hard. Two regions have the least cost (length and, with little weight, shares); of
/// more, no two can lower it by an exchange, unless topology forbids that. See docs/developer/segment-borders.md.
///
/// Properties: (1) the faces of each label are connected through edges; (2) each generator owns a face or is listed in
/// `without_face`; (3) a face has no label exactly where no generator reaches it; (4) smooth borders are not longer
/// than nearest ones, and a region has the topology that it has with nearest labels: discs stay discs.
/// Throws Error{precondition} if the diagram was not made of this mesh, Error{interrupted} if the progress callback
/// cancels. Cost: O(n log n).
Segmentation segment_faces(const Mesh& mesh, const Diagram& diagram, const SegmentOptions& options = {});

/// Length of the edges between faces with different labels, in mesh units. Cost: O(n).
/// Throws Error{precondition} where there is not one label for each face.
double compute_border_length(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& face_label);

/// A mesh whose faces each lie in one cell.
struct CutMesh {
  Mesh mesh;                            ///< vertices of the input first, in their order
  IdVector<FaceId, FaceId> parent;      ///< the face of the input that holds each face; ascending
  IdVector<FaceId, GeneratorId> label;  ///< invalid where no generator reaches
  std::vector<FaceNumbers> numbers;     ///< further ones of the faces; none unless the caller adds them
  std::int32_t input_vertices = 0;      ///< number of the input's vertices
  std::int32_t uncut_faces = 0;         ///< faces left whole because their pieces do not tile them; normally 0
};

/// Splits the faces of a mesh along the bisectors of its diagram.
///
/// If cuts of two faces have the same ends, the result would have one edge with four faces. Each such cut is therefore
/// split by a vertex of its own at its midpoint. Where rounding brings two branch points or bisectors together at one
/// vertex, a region would touch itself there; a thousandth of the edges at the vertex then goes to the region beside
/// it.
///
/// Properties: (1) the surface is the same set of points, within rounding; (2) the faces on both sides of an edge share
/// the vertices on it, so the result has the topology of the input; (3) faces that no bisector touches do not change,
/// but those at a vertex as above; (4) a cell that is a disc is one as a mesh, too: the faces with its label, with the
/// vertices that they share. Only a given region (`separate_regions`) that touches itself can still make its cells do
/// so.
/// Throws Error{precondition} if the diagram was not made of this mesh, Error{no_valid_result} if the result is not a
/// manifold, Error{interrupted} if `progress` cancels. Cost: O(n log n), and O(k^2) in a face with k corners of pieces.
CutMesh cut_faces(const Mesh& mesh, const Diagram& diagram, const Progress& progress = {});

/// Labels and distances of the vertices of a cut mesh.
struct CutVertices {
  IdVector<VertexId, GeneratorId> label;  ///< a nearest generator; invalid where none reaches
  IdVector<VertexId, double> distance;    ///< mesh units; infinity where no generator reaches
};

/// Carries the labels and distances of the vertices of `mesh` over to `cut`, which is `mesh` cut along `diagram`, or
/// the mesh that `separate_regions` made `mesh` of.
///
/// The vertices of the input keep theirs. A new one has the smallest label of its faces, as ties are broken, and the
/// distance that is linear between the corners of the face that it lies in.
/// Throws Error{precondition} if the three do not belong together. Cost: O(n).
CutVertices carry_to_cut_vertices(const Mesh& mesh, const Diagram& diagram, const CutMesh& cut);

/// Carries the appearance of the faces of `mesh` over to `cut`, which is `mesh` cut along a diagram.
///
/// A face has the material of its parent, and the texture coordinates at the parent's corners are those of the parent.
/// Elsewhere they are linear in the parent. On an edge they depend on the values at its ends alone: where both sides
/// of an edge agreed, they still do, and no seam is added.
/// Throws Error{precondition} if the three do not belong together. Cost: O(n).
Appearance carry_to_cut_faces(const Mesh& mesh, const Appearance& appearance, const CutMesh& cut);

/// Writes the diagram as `gvd-diagram/1` with one more member, `"face_labels"`: the label of each face, -1 for none.
/// Where there are `numbers`, `"face_numbers"` is an object with an array of each. The stream is flushed and checked.
/// Throws Error{unwritable_output}. Cost: O(n).
void write_segmentation_json(std::ostream& out, const Mesh& mesh, const Diagram& diagram,
                             const Segmentation& segmentation, const std::vector<FaceNumbers>& numbers = {});

/// Writes the diagram with the member `"cut_mesh"`: `{"vertices":[[x,y,z]],"faces":[[a,b,c]],"labels":[],"parents":[],
/// "vertex_labels":[],"vertex_distances":[]}`. Labels and parents are those of the faces; a distance is null for none.
/// With `cut.numbers` it has `"face_numbers"`, too. The stream is flushed and checked. Throws Error{unwritable_output}.
/// Cost: O(n).
void write_cut_json(std::ostream& out, const Mesh& mesh, const Diagram& diagram, const CutMesh& cut,
                    const CutVertices& vertices);

/// The faces that have one label.
struct RegionSize {
  std::int64_t faces = 0;
  double area = 0;  ///< square mesh units
};

/// The size of each region of a labelled mesh, be it segmented or cut. `regions` is the number of labels.
/// Throws Error{precondition} where there is not one label for each face, or one is out of range. Cost: O(n).
IdVector<GeneratorId, RegionSize> measure_regions(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& face_label,
                                                  std::size_t regions);

}  // namespace gvd
