#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "arrays.hpp"
#include "bound_calls.hpp"
#include "bound_results.hpp"
#include "calls.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/io/view.hpp"
#include "gvd/sampling.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

// The classes of the module _gvd. Each result keeps the mesh that it belongs to alive.
namespace gvd::python {

namespace py = pybind11;

/// Points of a mesh, as the package's functions take them.
struct PointList {
  std::vector<SurfacePoint> points;
};

/// What the entries of a list are, as the package's `_points.py` tells them apart: kinds, ids of vertices and faces,
/// and coordinates.
using Entries = std::tuple<Array<std::int8_t>, Array<std::int64_t>, Array<double>>;

/// `name` stands for the list in messages.
GeneratorList make_list(const std::string& name, const Entries& entries);

/// An option as an argument of a call: "max_snap", "no_refine=True", "method='exact'".
std::string spell_argument(std::string_view name, std::string_view value);

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

/// Options by their names. Those that are missing or None keep their defaults.
class Given {
 public:
  explicit Given(const py::dict& options) : options_(options) {}

  bool has(const char* name) const { return options_.contains(name) && !options_[name].is_none(); }
  bool is_text(const char* name) const { return py::isinstance<py::str>(options_[name]); }
  const std::vector<SurfacePoint>& points(const char* name) const {
    return options_[name].cast<const PointList&>().points;
  }
  const SamplingOptions& sampling(const char* name) const { return options_[name].cast<const Sampler&>().options; }
  std::vector<double> numbers(const char* name) const {
    const auto values = options_[name].cast<Array<double>>();
    return {values.data(), values.data() + values.size()};
  }

  /// Throws Error{invalid_option} where the value has another type, or is out of its range.
  template <class T>
  void read(const char* name, T& value) const {
    if (!has(name)) return;
    try {
      value = options_[name].cast<T>();
    } catch (const py::cast_error&) {
      const std::string text = py::repr(options_[name]);
      throw Error(ErrorCode::invalid_option, fmt::format("{}: {} is of a wrong kind, or too large", name, text));
    }
  }

  /// Throws Error{invalid_option} for a name that is none of the choices.
  template <class T, class Choice>
  void read(const char* name, T& value, const Choices<Choice>& choices) const {
    if (has(name)) value = choose(name, options_[name].cast<std::string>(), choices);
  }

 private:
  const py::dict& options_;
};

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
void bind_remesh(py::module_& module);

}  // namespace gvd::python
