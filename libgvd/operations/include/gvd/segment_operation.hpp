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
  std::optional<ChartMap> uv;  ///< of the texture coordinates, which are those of cut faces; none: no coordinates
  bool disc = false;           ///< generators are added until every cell is a disc
};

void describe(OptionList& list, LabelCall& call);

/// The options of the operation `segment`.
struct SegmentCall : LabelCall, DiagramParts {
  std::optional<std::int32_t> per_region;  ///< generators of each region, >= 1
  std::vector<std::int32_t> levels;        ///< numbers of generators, ascending; empty: one level

  /// Stores what follows from options: the number of generators, and that texture coordinates are those of cut faces.
  void complete();
};

void describe(OptionList& list, SegmentCall& call);

/// A segmented mesh: its own faces with labels, or pieces of them.
class SegmentOutcome : public Object {
 public:
  static constexpr Content kContent = Content::surface | Content::vertex_labels | Content::distances | Content::diagram;
  std::string_view kind() const override { return "segment"; }
  Content content() const override { return kContent; }
  void check_file(const WrittenFile& file) const override;
  void visit(ObjectVisitor& visitor) const override;

  const CheckedMesh& input() const { return *diagram->mesh(); }
  const PartedMesh& parted() const { return diagram->parted(); }
  /// The mesh that has the input's faces, with the vertices on borders of regions doubled, and its diagram.
  const Mesh& surface() const { return diagram->surface(); }
  const Diagram& of_surface() const { return *diagram->of_surface(); }
  /// What files hold: the input, or its pieces, with labels and distances.
  std::optional<LabelledMesh> labelled() const override;
  OwnWriters own_writers() const override;
  const IdVector<FaceId, GeneratorId>& face_labels() const;
  /// The numbers of the labelled mesh's faces beside their labels.
  const std::vector<FaceNumbers>& numbers() const { return cut ? cut->numbers : whole_numbers; }
  /// The edges between two regions, or beside faces that are left out.
  std::vector<std::vector<Vec3>> borders() const;

  std::shared_ptr<const DiagramObject> diagram = std::make_shared<DiagramObject>();
  std::vector<std::optional<double>> snap_distance;  ///< of the generators, from where they were given; or empty
  std::optional<BalancedDiagram> balanced;           ///< without its diagram
  std::optional<Segmentation> whole;                 ///< of the input's faces
  std::vector<FaceNumbers> whole_numbers;
  std::shared_ptr<const CutMesh> cut;  ///< null where whole faces are labelled
  CutVertices cut_vertices;
  Appearance appearance;         ///< of the pieces
  std::optional<Charts> charts;  ///< without their texture, which the appearance has
  ChartMap chart_map{};
  std::int64_t unreached_faces = 0;
  double border_length = 0;  ///< of whole faces
  struct Discs {
    std::int64_t added = 0, rounds = 0;
    bool search_cut_short = false;
  };
  std::optional<Discs> discs;
};

/// Labels or cuts the faces of a diagram's mesh. Throws what segment_faces, cut_faces and make_charts throw.
std::shared_ptr<const SegmentOutcome> run(const DiagramObject& on, LabelCall& call, Observer& observer);

/// Chooses generators, computes their diagram, and labels or cuts the faces. Options become what they stand for. Throws
/// what its steps throw.
std::shared_ptr<const SegmentOutcome> run(const MeshPtr& input, SegmentCall& call, Observer& observer);

}  // namespace gvd
