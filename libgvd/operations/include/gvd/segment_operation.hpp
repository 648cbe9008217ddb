#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "gvd/charts.hpp"
#include "gvd/diagram_parts.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/mesh_objects.hpp"
#include "gvd/observer.hpp"
#include "gvd/parted_mesh.hpp"
#include "gvd/segment.hpp"

namespace gvd {

/// The options of the operation `label`, which works on a diagram.
struct LabelCall {
  SegmentOptions segmentation;
  bool cut = false;            ///< split faces along the bisectors
  std::optional<ChartMap> uv;  ///< the map of the texture coordinates, which only cut faces have; none: no coordinates
  bool disc = false;           ///< add generators until every cell is a disc
};

void describe(OptionList& list, LabelCall& call);

/// The options of the operation `segment`.
struct SegmentCall : LabelCall, DiagramParts {
  std::optional<std::int32_t> per_region;  ///< number of generators in each region, >= 1
  std::vector<std::int32_t> levels;        ///< numbers of generators, ascending; empty: one level

  /// Sets options that follow from others: the number of generators, and `cut` if there are texture coordinates.
  void complete();
};

void describe(OptionList& list, SegmentCall& call);

/// The result of `label` and `segment`: a segmented mesh, whose faces or pieces of faces have labels.
class SegmentOutcome : public Object {
 public:
  static constexpr Content kContent = Content::surface | Content::vertex_labels | Content::distances | Content::diagram;
  std::string_view kind() const override { return "segment"; }
  Content content() const override { return kContent; }
  void check_file(const WrittenFile& file) const override;
  void visit(ObjectVisitor& visitor) const override;

  const CheckedMesh& input() const { return *diagram->mesh(); }
  const PartedMesh& parted() const { return diagram->parted(); }
  /// The mesh of the diagram (PartedMesh::surface), and the diagram of this mesh.
  const Mesh& surface() const { return diagram->surface(); }
  const Diagram& of_surface() const { return *diagram->of_surface(); }
  /// The mesh for files: the input or its pieces, with labels and distances.
  std::optional<LabelledMesh> labelled() const override;
  OwnWriters own_writers() const override;
  const IdVector<FaceId, GeneratorId>& face_labels() const;
  /// Further numbers of the labelled mesh's faces, beside their labels.
  const std::vector<FaceNumbers>& numbers() const { return cut ? cut->numbers : whole_numbers; }
  /// The edges between two regions, or between a region and faces that are left out.
  std::vector<std::vector<Vec3>> borders() const;

  std::shared_ptr<const DiagramObject> diagram = std::make_shared<DiagramObject>();
  /// For each generator, how far it was moved to the surface; may be empty.
  std::vector<std::optional<double>> snap_distance;
  std::optional<BalancedDiagram> balanced;  ///< if the cells were balanced; without the diagram
  std::optional<Segmentation> whole;        ///< the labels of the input's faces, if whole faces are labelled
  std::vector<FaceNumbers> whole_numbers;
  std::shared_ptr<const CutMesh> cut;  ///< null if whole faces are labelled
  CutVertices cut_vertices;
  Appearance appearance;         ///< the texture and materials of the pieces
  std::optional<Charts> charts;  ///< without their texture, which is in `appearance`
  ChartMap chart_map{};
  std::int64_t unreached_faces = 0;
  double border_length = 0;  ///< of whole faces, mesh units
  struct Discs {
    std::int64_t added = 0, rounds = 0;
    bool search_cut_short = false;
  };
  std::optional<Discs> discs;
};

/// Labels or cuts the faces of a diagram's mesh. Throws what segment_faces, cut_faces and make_charts throw.
std::shared_ptr<const SegmentOutcome> run(const DiagramObject& on, LabelCall& call, Observer& observer);

/// Chooses generators, computes their diagram, and labels or cuts the faces. Replaces options such as `auto` in `call`
/// by the values used. Throws what its steps throw.
std::shared_ptr<const SegmentOutcome> run(const MeshPtr& input, SegmentCall& call, Observer& observer);

}  // namespace gvd
