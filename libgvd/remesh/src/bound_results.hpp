#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "gvd/appearance.hpp"
#include "gvd/charts.hpp"
#include "gvd/diagram.hpp"
#include "gvd/face_regions.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/segment.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

// Results as the modules of Python and of the web hold them. Each keeps alive what it was made of.
namespace gvd {

using SharedMesh = std::shared_ptr<CheckedMesh>;

/// What a diagram inside regions was made on.
struct PartedDiagram {
  SeparatedMesh separated;
  Diagram diagram;                   ///< of the separated mesh
  std::vector<FaceNumbers> numbers;  ///< of the input's faces: regions, and labels of the coarser levels
  std::size_t levels = 0;

  /// With levels, adds the labels of the last one.
  void add_labels(const IdVector<FaceId, GeneratorId>& labels, std::vector<FaceNumbers>& to) const;
};

/// A diagram, alone or as a part of another result, which then stays alive.
struct MeshDiagram {
  SharedMesh input;
  std::shared_ptr<const Diagram> diagram;
  std::shared_ptr<const PartedDiagram> parted = {};  ///< null: the diagram is that of the input

  const Mesh& mesh() const { return input->mesh; }
  /// The mesh and the diagram that has all of its vertices; other ones inside regions.
  const Mesh& surface() const { return parted ? parted->separated.mesh : input->mesh; }
  const Diagram& surface_diagram() const { return parted ? parted->diagram : *diagram; }
};

struct Segmented {
  MeshDiagram of;
  Segmentation segmentation;
  std::vector<FaceNumbers> numbers = {};  ///< of the faces, inside regions
};

struct Cut {
  MeshDiagram of;
  CutMesh cut;
  CutVertices vertices;
  Appearance appearance;
  Charts charts = {};  ///< without their texture, which the appearance has

  SharedMesh mesh() const;
};

/// The regions that a diagram keeps to, and its generators.
struct RegionOptions {
  std::optional<std::vector<double>> within, mask;  ///< a number for each face, or else for each vertex
  std::vector<std::int32_t> levels;                 ///< numbers of generators, ascending; empty: one level
  std::vector<SurfacePoint> listed;                 ///< empty: they are sampled
};

/// A diagram inside regions: given ones, those of a mask, and those of the coarser levels of a hierarchy. `level` has
/// the options of every level. Throws what the steps of gvd-segment throw, with the name of the option.
MeshDiagram compute_diagram_inside(const SharedMesh& input, const RegionOptions& options, LevelOptions level);

/// The diagram with generators added until every cell is a disc, as gvd-segment --disc does it.
MeshDiagram make_cells_discs(const MeshDiagram& of, const DiagramOptions& options);

/// Labels the faces, and adds the numbers that they have inside regions.
Segmented segment_diagram(const MeshDiagram& of, const SegmentOptions& options);

/// Splits the faces along the bisectors; with `charts`, lays out the pieces too.
Cut cut_diagram(const MeshDiagram& of, const std::optional<ChartMap>& charts, const Progress& progress);

/// What the files of a result hold: the arrays of the commands.
LabelledMesh labelled(const MeshDiagram& of);
LabelledMesh labelled(const Segmented& made);
LabelledMesh labelled(const Cut& made);

/// What a result writes itself, in place of `write_mesh`, by the extension.
using OwnFormats = std::vector<std::pair<std::string, std::function<void(std::ostream&)>>>;

OwnFormats own_formats(const MeshDiagram& of);
OwnFormats own_formats(const Segmented& made);
OwnFormats own_formats(const Cut& made);

}  // namespace gvd
