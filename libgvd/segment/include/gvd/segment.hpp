#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// A label for every face.
struct Segmentation {
  IdVector<FaceId, GeneratorId> face_label;  ///< invalid where no generator reaches
  std::vector<GeneratorId> without_face;     ///< generators that own no face, ascending
  std::int32_t moved_faces = 0;  ///< faces that another cell has the largest part of: moved to keep labels connected
  std::int32_t given_faces = 0;  ///< faces given to a generator that had the largest part of none
};

/// Labels the faces of a mesh by the cells of its diagram.
///
/// A face that no bisector cuts takes its cell; a cut one takes the cell with the largest part of its area (of equals
/// the smaller id). Then, of each label, the part with the generator's own face stays, or else the part with the
/// largest area, and the faces of other parts go to a label next to them, the one with the largest share first. At last
/// a generator without a face is given one that its cell has a part of, the face that it lies in first, where the label
/// that loses the face keeps another one and stays connected.
///
/// Properties: (1) the faces of each label are connected through edges; (2) each generator owns a face or is listed in
/// `without_face`; (3) a face has no label exactly where no generator reaches it.
/// Throws Error{precondition} where the diagram was not made of this mesh. Cost: O(n log n).
Segmentation segment_faces(const Mesh& mesh, const Diagram& diagram);

/// A mesh whose faces each lie in one cell.
struct CutMesh {
  Mesh mesh;                            ///< vertices of the input first, in their order
  IdVector<FaceId, FaceId> parent;      ///< the face of the input that holds each face; ascending
  IdVector<FaceId, GeneratorId> label;  ///< invalid where no generator reaches
  std::int32_t uncut_faces = 0;         ///< faces left whole because their pieces do not fit together; normally 0
};

/// Splits the faces of a mesh along the bisectors of its diagram.
///
/// Where the cuts of two faces with the same three corners would become one edge with four faces, each gets a vertex of
/// its own in its middle.
///
/// Properties: (1) the surface stays the same set of points, within rounding; (2) a vertex on an edge is shared by the
/// faces on both sides, so the result has the topology of the input; (3) faces that no bisector touches stay as they
/// are. Throws Error{precondition} where the diagram was not made of this mesh. Cost: O(n log n), and O(k^2) in a face
/// with k corners of pieces.
CutMesh cut_faces(const Mesh& mesh, const Diagram& diagram);

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
