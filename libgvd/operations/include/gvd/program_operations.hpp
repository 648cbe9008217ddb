#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/generator_curve.hpp"
#include "gvd/generator_options.hpp"
#include "gvd/io/format.hpp"
#include "gvd/mesh_objects.hpp"
#include "gvd/mesh_property.hpp"
#include "gvd/observer.hpp"
#include "gvd/option_list.hpp"

// The operations for programs only: `mesh`, `saved_mesh`, `values`, `properties`, `curves` and `check`. The commands
// read files themselves.
namespace gvd {

/// A file that an operation reads, or its bytes in memory.
struct GivenFile {
  std::string file;      ///< empty: no file; with `content` the name for messages, whose extension tells the format
  bool content = false;  ///< the last array has the bytes of the file
  std::vector<ArrayView> arrays;
  /// The bytes in memory. Throws Error{invalid_option} if there is no array of bytes.
  std::string_view bytes() const;
};

/// The options of the operation `mesh`, which makes a mesh from a file or from two arrays: positions in three columns,
/// and polygons with their corners in three or more columns.
struct MeshCall : GivenFile {
  std::optional<MeshFormat> format;
  DefectPolicy on_defect = DefectPolicy::repair;
  std::optional<double> weld;  ///< mesh units
  std::optional<ErrorBound> drop_smaller_than;
};
void describe(OptionList& list, MeshCall& call);
/// Reads and repairs a mesh. Throws what `read_soup`, `weld_soup`, `build_mesh` and `drop_small_components` throw.
std::shared_ptr<const MeshObject> run(MeshCall& call, Observer& observer);

/// The options of the operation `saved_mesh`, which restores a mesh from its arrays, in the order in which a mesh
/// visits them, and from its figures that are lists of texts. The elements of the mesh keep their places in the input.
struct SavedMeshCall {
  std::vector<std::string> repairs, materials, material_files;
  std::vector<ArrayView> arrays;
};
void describe(OptionList& list, SavedMeshCall& call);
/// Restores a mesh. Throws Error{precondition} if the arrays do not belong to a mesh.
std::shared_ptr<const MeshObject> run(SavedMeshCall& call, Observer& observer);

/// The options of the operation `values`, which reads a file with a number for each vertex or face.
struct ValuesCall : GivenFile {};
void describe(OptionList& list, ValuesCall& call);

/// Lists of numbers by their names: "values", or "vertex NAME" and "face NAME".
class NumbersObject : public Object {
 public:
  std::string_view kind() const override { return "numbers"; }
  void visit(ObjectVisitor& visitor) const override;

  std::vector<std::pair<std::string, std::vector<double>>> numbers;
};
std::shared_ptr<const NumbersObject> run(ValuesCall& call, Observer& observer);

/// The options of the operation `properties`, which reads the properties of a mesh file except coordinates and texture.
struct PropertiesCall : ValuesCall {};
std::shared_ptr<const NumbersObject> run(PropertiesCall& call, Observer& observer);

/// The options of the operation `curves`, which finds curves of a mesh.
struct CurvesCall {
  GeneratorOptions generators;
};
void describe(OptionList& list, CurvesCall& call);

/// The result of `curves`: curves of a mesh, as polylines.
class CurvesOutcome : public Object {
 public:
  std::string_view kind() const override { return "curves"; }
  void visit(ObjectVisitor& visitor) const override;

  std::int64_t count = 0;
  std::vector<Vec3> positions;        ///< the points of all polylines
  std::vector<std::int64_t> offsets;  ///< the index of each polyline's first point, and the number of all points
  std::vector<std::int64_t> curve;    ///< for each polyline, the curve to which it belongs
};
std::shared_ptr<const CurvesOutcome> run(const MeshPtr& input, CurvesCall& call, Observer& observer);

/// The operation `check` has no options.
struct CheckCall {};
inline void describe(OptionList&, CheckCall&) {}

/// The result of `check`: the violated invariants of a diagram; empty for a valid diagram.
class CheckOutcome : public Object {
 public:
  std::string_view kind() const override { return "check"; }
  void visit(ObjectVisitor& visitor) const override {
    visitor.figure({"violations", "", "of the invariants of a diagram, a line each"}, violations);
  }

  std::vector<std::string> violations;
};
std::shared_ptr<const CheckOutcome> run(const DiagramObject& on, CheckCall& call, Observer& observer);

}  // namespace gvd
