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

// The operations that only programs call: `mesh`, `saved_mesh`, `values`, `properties`, `curves` and `check`. Commands
// read files by themselves.
namespace gvd {

/// A file that an operation reads, or its bytes in memory.
struct GivenFile {
  std::string file;      ///< empty: none; with `content` its name for messages, whose extension counts
  bool content = false;  ///< the last array has the bytes
  std::vector<ArrayView> arrays;
  /// Throws Error{invalid_option} without an array of bytes.
  std::string_view bytes() const;
};

/// The options of the operation `mesh`, of a file or of two arrays: positions in three columns, and polygons, whose
/// corners are in three columns or more.
struct MeshCall : GivenFile {
  std::optional<MeshFormat> format;
  DefectPolicy on_defect = DefectPolicy::repair;
  std::optional<double> weld;  ///< mesh units
  std::optional<ErrorBound> drop_smaller_than;
};
void describe(OptionList& list, MeshCall& call);
/// Throws what read_soup, weld_soup, build_mesh and drop_small_components throw.
std::shared_ptr<const MeshObject> run(MeshCall& call, Observer& observer);

/// The options of the operation `saved_mesh`: a mesh out of the arrays that it consists of, in the order in which a
/// mesh names them, and its figures with lists of texts. So its elements keep their places in the input.
struct SavedMeshCall {
  std::vector<std::string> repairs, materials, material_files;
  std::vector<ArrayView> arrays;
};
void describe(OptionList& list, SavedMeshCall& call);
/// Throws Error{precondition} for arrays that are of no mesh.
std::shared_ptr<const MeshObject> run(SavedMeshCall& call, Observer& observer);

/// The options of the operation `values`: numbers that a file has for each vertex or face.
struct ValuesCall : GivenFile {};
void describe(OptionList& list, ValuesCall& call);

/// Numbers by their names: "values", or "vertex NAME" and "face NAME".
class NumbersObject : public Object {
 public:
  std::string_view kind() const override { return "numbers"; }
  void visit(ObjectVisitor& visitor) const override;

  std::vector<std::pair<std::string, std::vector<double>>> numbers;
};
std::shared_ptr<const NumbersObject> run(ValuesCall& call, Observer& observer);

/// The options of the operation `properties`: those of a file of a mesh, but for its coordinates and texture.
struct PropertiesCall : ValuesCall {};
std::shared_ptr<const NumbersObject> run(PropertiesCall& call, Observer& observer);

/// The options of the operation `curves`.
struct CurvesCall {
  GeneratorOptions generators;
};
void describe(OptionList& list, CurvesCall& call);

/// Curves of a mesh, as polylines.
class CurvesOutcome : public Object {
 public:
  std::string_view kind() const override { return "curves"; }
  void visit(ObjectVisitor& visitor) const override;

  std::int64_t count = 0;
  std::vector<Vec3> positions;        ///< of all polylines
  std::vector<std::int64_t> offsets;  ///< the place of each polyline's first point, and the number of all
  std::vector<std::int64_t> curve;    ///< that each polyline is of
};
std::shared_ptr<const CurvesOutcome> run(const MeshPtr& input, CurvesCall& call, Observer& observer);

/// The options of the operation `check`: there are none.
struct CheckCall {};
inline void describe(OptionList&, CheckCall&) {}

/// The violated invariants of a diagram; none for a sound one.
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
