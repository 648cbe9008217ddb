#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

// Objects, which operations take and return. An object names its parts, so that every door (the C interface, Python,
// JavaScript and the commands) reads them in the same way.
namespace gvd {

enum class ArrayType : std::int32_t { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// The type of numbers in memory. A typed id counts as its number.
template <class T>
constexpr ArrayType array_type() {
  if constexpr (std::is_same_v<T, double>) {
    return ArrayType::float64;
  } else if constexpr (std::is_same_v<T, bool>) {
    return ArrayType::uint8;
  } else if constexpr (std::is_same_v<T, std::int64_t>) {
    return ArrayType::int64;
  } else {
    static_assert(sizeof(T) == sizeof(std::int32_t) && !std::is_floating_point_v<T> && std::is_trivially_copyable_v<T>);
    return ArrayType::int32;
  }
}

/// Numbers of one type that somebody else owns, in one or two dimensions.
struct ArrayView {
  const void* data = nullptr;
  ArrayType type = ArrayType::float64;
  std::int32_t dimensions = 1;
  std::array<std::int64_t, 2> shape{0, 1};
  std::array<std::int64_t, 2> strides{0, 0};  ///< bytes from one element to the next
};

template <class T>
ArrayView view(const std::vector<T>& values) {
  return {values.data(), array_type<T>(), 1, {std::ssize(values), 1}, {sizeof(T), 0}};
}
/// A row of numbers for each element.
template <class T, std::size_t N>
ArrayView view(const std::vector<std::array<T, N>>& rows) {
  return {rows.data(), array_type<T>(), 2, {std::ssize(rows), N}, {sizeof(T) * N, sizeof(T)}};
}
inline ArrayView view(const std::vector<Vec3>& positions) {
  return {positions.data(), ArrayType::float64, 2, {std::ssize(positions), 3}, {sizeof(Vec3), sizeof(double)}};
}
template <class IdType, class T>
ArrayView view(const IdVector<IdType, T>& values) {
  return view(values.raw());
}
/// One member of each structure in a list.
template <class S, class T>
ArrayView view(const std::vector<S>& values, T S::*member) {
  const void* const first = values.empty() ? nullptr : &(values.front().*member);
  return {first, array_type<T>(), 1, {std::ssize(values), 1}, {sizeof(S), 0}};
}
template <class S, class T, std::size_t N>
ArrayView view(const std::vector<S>& values, std::array<T, N> S::*member) {
  const void* const first = values.empty() ? nullptr : &(values.front().*member);
  return {first, array_type<T>(), 2, {std::ssize(values), N}, {sizeof(S), sizeof(T)}};
}

template <class S>
ArrayView view(const std::vector<S>& values, Vec3 S::*member) {
  const void* const first = values.empty() ? nullptr : (values.front().*member).data();
  return {first, ArrayType::float64, 2, {std::ssize(values), 3}, {sizeof(S), sizeof(double)}};
}

/// Points that somebody else owns, at a constant stride in memory.
struct PointsView {
  PointsView(const std::vector<SurfacePoint>& points)  // NOLINT(google-explicit-constructor): like a string view
      : first(points.data()), count(std::ssize(points)), stride(sizeof(SurfacePoint)) {}
  template <class S>
  PointsView(const std::vector<S>& values, SurfacePoint S::*member)
      : first(values.empty() ? nullptr : &(values.front().*member)), count(std::ssize(values)), stride(sizeof(S)) {}

  ArrayView faces() const {
    return {first == nullptr ? nullptr : &first->face, ArrayType::int32, 1, {count, 1}, {stride, 0}};
  }
  ArrayView bary() const {
    const void* const numbers = first == nullptr ? nullptr : first->bary.data();
    return {numbers, ArrayType::float64, 2, {count, 3}, {stride, sizeof(double)}};
  }

  const SurfacePoint* first;
  std::int64_t count, stride;
};

/// How a door presents a part of an object: its name, whose levels are separated by dots, its unit, and a description.
struct Meaning {
  std::string_view name;
  std::string_view unit;  ///< empty: none
  std::string_view text;
};

/// A value that is no array; std::monostate if there is none.
using Figure = std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<double>,
                            std::vector<std::int64_t>, std::vector<std::string>, std::vector<std::vector<std::int64_t>>,
                            std::vector<std::vector<double>>, std::vector<bool>>;

/// A named column of a table. All columns of a table have equal length; an element that is an empty list is left out of
/// its row.
struct Column {
  std::string name;
  Figure values;  ///< a list of numbers, or of lists of numbers
};
using Table = std::vector<Column>;

/// A sequence of lists, such as curves of points or the neighbours of each cell.
template <class T>
struct Lists {
  std::int64_t count = 0;
  std::function<std::span<const T>(std::int64_t)> list;
};
using PointLists = Lists<SurfacePoint>;
using GeneratorLists = Lists<GeneratorId>;

/// How a file of an object is written.
struct FileOptions {
  std::string part;               ///< a part that has its own file (Object::part_writers); empty: the object itself
  std::string title = "gvd";      ///< of a page
  bool no_curves = false;         ///< leave the bisectors out of formats that hold meshes
  bool ascii_ply = false;         ///< PLY as text
  bool region_materials = false;  ///< in OBJ, write materials of the regions in place of the mesh's own
  int threads = 0;                ///< for a page; 0: as many as there are cores
};

/// Writers of formats, by extension without the dot.
using OwnWriters = std::map<std::string, std::function<void(std::ostream&)>, std::less<>>;

/// A file that will hold an object: how messages call it, and its format.
struct WrittenFile {
  std::string name;
  const Format* format;
};

class Object;
using PartMaker = std::function<std::shared_ptr<const Object>()>;

/// Receives the parts of an object, in the order of the JSON documents.
class ObjectVisitor {
 public:
  virtual ~ObjectVisitor() = default;
  virtual void figure(const Meaning&, const Figure&) {}
  virtual void array(const Meaning&, const ArrayView&) {}
  virtual void points(const Meaning&, const PointsView&) {}
  virtual void curves(const Meaning&, const PointLists&) {}
  virtual void lists(const Meaning&, const GeneratorLists&) {}
  virtual void table(const Meaning&, const Table&) {}
  /// `kind` is the kind of the part. `make` returns the part, or null if there is none.
  virtual void part(const Meaning&, std::string_view /*kind*/, const PartMaker& /*make*/) {}
};

/// A mesh, a diagram or the result of an operation.
///
/// Properties: (1) it never changes, except that a diagram may pass its editor on; (2) it keeps everything alive to
/// which it refers; (3) all objects of a kind visit the same names. A part that an object lacks is an empty array, an
/// empty figure or a null part, so a default-constructed object describes its kind.
class Object {
 public:
  virtual ~Object() = default;
  virtual std::string_view kind() const = 0;  ///< "mesh", "diagram", or the name of the operation
  virtual void visit(ObjectVisitor& visitor) const = 0;

  // The files of the object. The results of these functions refer to the object, which must outlive them.

  /// The content for files: the object can be written in any format that carries some of it.
  virtual Content content() const { return Content::nothing; }
  /// Throws Error{invalid_option} if a file would lose results that the caller asked for.
  virtual void check_file(const WrittenFile&) const {}
  /// The mesh for formats of meshes; nothing if there is none.
  virtual std::optional<LabelledMesh> labelled() const { return std::nullopt; }
  /// Formats of its own, by extension. They take precedence over formats of meshes.
  virtual OwnWriters own_writers() const { return {}; }
  /// The formats of a part that has its own files, such as "points"; empty if there is no such part.
  virtual OwnWriters part_writers(std::string_view /*part*/) const { return {}; }
  /// The HTML page that shows the object, by default the regions of `labelled`. Throws Error{invalid_option} if there
  /// is nothing to show, or if the library was built without pages.
  virtual std::string page(const FileOptions& options) const;
};

class OptionList;

void describe(OptionList& list, FileOptions& options);

/// Writes a complete file or none, in the format of the extension. Throws Error{invalid_option} if the format carries
/// nothing of the object, and what `check_file`, `write_mesh` and `write_file` throw.
void write_object(const std::filesystem::path& path, const Object& object, const FileOptions& options = {},
                  const Progress& progress = {});
/// The bytes of such a file. `format` is an extension such as "ply". An OBJ refers to no file of materials.
std::string file_bytes(const std::string& format, const Object& object, const FileOptions& options = {});

}  // namespace gvd
