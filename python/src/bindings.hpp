#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "gvd/diagram.hpp"
#include "gvd/face_regions.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/io/view.hpp"
#include "gvd/sampling.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

// The classes of the module _gvd. Each result keeps the mesh that it belongs to alive.
namespace gvd::python {

namespace py = pybind11;

using SharedMesh = std::shared_ptr<CheckedMesh>;

/// Points of a mesh, as the package's functions take them.
struct PointList {
  std::vector<SurfacePoint> points;
};

/// Curves of a mesh as generators.
struct CurveSet {
  std::vector<GeneratorCurve> curves;
};

/// What the entries of a list are, as the package's `_points.py` tells them apart: kinds, ids of vertices and faces,
/// and coordinates.
using Entries = std::tuple<Array<std::int8_t>, Array<std::int64_t>, Array<double>>;

void append_entries(GeneratorList& list, const Entries& entries);

/// The options of every diagram, by their names in Python.
struct ComputeOptions {
  std::string method = "exact";
  std::optional<std::string> front;
  std::optional<double> chord_tolerance;
  int threads = 0;

  /// Throws Error{invalid_option} for an unknown name.
  DiagramOptions make() const;
};

/// How generators are sampled: `sampling` is farthest, random, vertices or poisson, and a covering `radius` goes before
/// it. Throws Error{invalid_option} for another name.
struct Sampler {
  SamplingOptions options;

  Sampler(const std::string& sampling, std::int64_t count, std::uint64_t seed, std::optional<double> radius,
          const ComputeOptions& compute);
};

/// What a diagram inside regions was made on.
struct PartedSurface {
  SeparatedMesh separated;
  Diagram diagram;                   ///< of the separated mesh
  std::vector<FaceNumbers> numbers;  ///< of the input's faces: regions, and labels of the coarser levels
  std::size_t levels = 0;

  /// With levels, adds the labels of the last one.
  void add_labels(const IdVector<FaceId, GeneratorId>& labels, std::vector<FaceNumbers>& to) const {
    if (levels > 0) to.push_back({level_name(levels), to_regions(labels)});
  }
};

/// A diagram, alone or as a part of another result, which then stays alive.
struct MeshDiagram {
  SharedMesh input;
  std::shared_ptr<const Diagram> part;
  std::shared_ptr<const PartedSurface> parted = {};  ///< null: the diagram is that of the input

  const Mesh& mesh() const { return input->mesh; }
  const Diagram& diagram() const { return *part; }
  /// The mesh and the diagram that has all of its vertices; other ones inside regions.
  const Mesh& surface() const { return parted ? parted->separated.mesh : input->mesh; }
  const Diagram& surface_diagram() const { return parted ? parted->diagram : *part; }
};
using SharedDiagram = std::shared_ptr<MeshDiagram>;

/// A file that does not hold a mesh in one of the formats of `OutputFormat`: its content by its extension.
using OwnFormats = std::vector<std::pair<std::string, std::function<void(std::ostream&)>>>;

/// How a file is written.
struct WriteOptions {
  std::string title;              ///< of the page
  bool no_curves = false;         ///< leave the bisectors out of formats that hold meshes
  bool ascii_ply = false;         ///< PLY as text
  bool region_materials = false;  ///< in OBJ, those of the regions in place of the mesh's own
};

/// Writes a mesh and its arrays by the file's extension: .html is the page, and `own` are formats of one result alone.
void write_result(const std::filesystem::path& path, LabelledMesh mesh, const OwnFormats& own,
                  const WriteOptions& options);

/// The page that shows a mesh, with its regions where it has some. Throws Error{invalid_option} where the library was
/// built without the page.
std::string make_page(const LabelledMesh& mesh, const std::string& title);

void bind_mesh(py::module_& module);
void bind_curves(py::module_& module);
void bind_distances(py::module_& module);
void bind_diagram(py::module_& module);
void bind_regions(py::module_& module);
void bind_remesh(py::module_& module);

}  // namespace gvd::python
