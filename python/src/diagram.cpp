// Diagrams, their faces labelled or cut, and the files and pages that show them.
//
// Files are those of the commands, byte by byte: they come from the same writers with the same arrays.
#include <utility>

#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "gvd/charts.hpp"
#include "gvd/check.hpp"
#include "gvd/diagram_editor.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/io/diagram_json.hpp"
#include "gvd/io/write_file.hpp"
#include "gvd/segment.hpp"
#include "gvd/text.hpp"

namespace gvd::python {
namespace {

/// Of points or curves, the member `of` of a list.
template <class List, auto of>
MeshDiagram make_diagram(const SharedMesh& input, const List& generators, std::optional<std::vector<double>> weights,
                         const ComputeOptions& compute, const py::object& progress) {
  DiagramOptions options = compute.make();
  options.weights = std::move(weights).value_or(std::vector<double>());
  return run_unlocked(progress, [&](const Progress& reported) {
    options.progress = reported;
    return MeshDiagram{input, std::make_shared<const Diagram>(compute_diagram(input->mesh, generators.*of, options))};
  });
}

/// As gvd-segment does it: the steps are bound_results.hpp's.
MeshDiagram diagram_inside(const SharedMesh& input, const py::dict& given, const ComputeOptions& compute,
                           const py::object& progress) {
  RegionOptions regions;
  LevelOptions level;
  read_regions(Given(given), regions, level);
  level.diagram = compute.make();
  return run_unlocked(progress, [&](const Progress& reported) {
    level.diagram.progress = level.labels.progress = level.generators.sampling.progress = reported;
    return compute_diagram_inside(input, regions, level);
  });
}

MeshDiagram discs(const MeshDiagram& of, const ComputeOptions& compute, const py::object& progress) {
  DiagramOptions options = compute.make();
  return run_unlocked(progress, [&](const Progress& reported) {
    options.progress = reported;
    return make_cells_discs(of, options);
  });
}

Segmented segment(const MeshDiagram& of, const std::string& labels, const py::object& progress) {
  const FaceLabels chosen = choose("labels", labels, kFaceLabelNames);
  return run_unlocked(progress, [&](const Progress& reported) { return segment_diagram(of, {chosen, reported}); });
}

Cut cut(const MeshDiagram& of, const std::optional<std::string>& uv, const py::object& progress) {
  std::optional<ChartMap> charts;
  if (uv) charts = choose("uv", *uv, kChartMapNames);
  return run_unlocked(progress, [&](const Progress& reported) { return cut_diagram(of, charts, reported); });
}

py::tuple bisector(const py::object& self, std::int64_t index) {
  const MeshDiagram& of = self.cast<const MeshDiagram&>();
  const Bisector& b = of.diagram->bisectors.raw().at(index);
  std::vector<Vec3> positions;
  for (const SurfacePoint& point : b.points) positions.push_back(position(of.mesh(), point));
  return py::make_tuple(b.left.value(), b.right.value(), b.closed, py::make_tuple(b.ends[0].value(), b.ends[1].value()),
                        view_points(b.points, self), take(std::move(positions)));
}

/// Arrays over all branch points: their points, positions, distances and, as lists, generators.
py::tuple branch_points(const py::object& self) {
  const std::vector<BranchPoint>& all = self.cast<const MeshDiagram&>().diagram->branch_points.raw();
  const SurfacePoint* const first = all.empty() ? nullptr : &all.front().point;
  const auto member = [&](const auto& value) { return view_members(value, all.size(), sizeof(BranchPoint), self); };
  py::list generators;
  for (const BranchPoint& branch : all) {
    py::list ids;
    for (const GeneratorId g : branch.generators) ids.append(g.value());
    generators.append(py::tuple(ids));
  }
  return py::make_tuple(py::make_tuple(member(first ? &first->face : nullptr), member(first ? &first->bary : nullptr)),
                        view(all, &BranchPoint::position, self), view(all, &BranchPoint::distance, self), generators);
}

py::list cells(const MeshDiagram& of) {
  py::list result;
  for (const Cell& cell : of.diagram->cells) {
    py::list neighbours;
    for (const GeneratorId g : cell.neighbours) neighbours.append(g.value());
    result.append(py::make_tuple(cell.generator.value(), cell.area, cell.euler_characteristic, cell.components,
                                 cell.boundary_loops, py::tuple(neighbours)));
  }
  return result;
}

py::list charts(const Cut& made) {
  py::list result;
  const auto pair = [](const Vec2& p) { return py::make_tuple(p.x(), p.y()); };
  for (const Chart& chart : made.charts.charts) {
    result.append(py::make_tuple(chart.generator.value(), chart.faces, chart.area, chart.flipped_area, chart.torn_area,
                                 chart.unplaced_area, chart.stretch,
                                 py::make_tuple(pair(chart.box.min()), pair(chart.box.max())), pair(chart.origin)));
  }
  return result;
}

/// An editor and copies of its diagrams: each stays as it is when the next change is made.
class Editor {
 public:
  Editor(const SharedMesh& input, const PointList& generators, const ComputeOptions& compute,
         const py::object& progress)
      : input_(input) {
    DiagramOptions options = compute.make();
    options.progress = [this](std::string_view step, double fraction) { return (*reported_)(step, fraction); };
    change(progress, [&] { editor_.emplace(input_->mesh, generators.points, options); });
  }

  const MeshDiagram& diagram() const { return diagram_; }

  MeshDiagram move(std::int64_t g, const PointList& to, const py::object& progress) {
    return change(progress, [&] { editor_->move(find(g), to.points.at(0)); });
  }
  MeshDiagram add(const PointList& point, const py::object& progress) {
    return change(progress, [&] { editor_->add(point.points.at(0)); });
  }
  MeshDiagram remove(std::int64_t g, const py::object& progress) {
    return change(progress, [&] { editor_->remove(find(g)); });
  }

 private:
  GeneratorId find(std::int64_t g) const {
    if (g >= 0 && g < std::ssize(editor_->generators())) return GeneratorId(g);
    throw Error(ErrorCode::precondition, fmt::format("generator: there is no generator {}", g), g);
  }

  /// Throws Error{precondition} where another thread, or the progress function, is in the middle of a change.
  template <class Work>
  MeshDiagram change(const py::object& progress, const Work& work) {
    if (std::exchange(busy_, true)) throw Error(ErrorCode::precondition, "the editor is in the middle of a change");
    const struct Done {
      bool& busy;
      ~Done() { busy = false; }
    } done{busy_};
    auto made = run_unlocked(progress, [&](const Progress& reported) {
      reported_ = &reported;
      work();
      return std::make_shared<const Diagram>(editor_->diagram());
    });
    return diagram_ = {input_, std::move(made)};
  }

  SharedMesh input_;
  bool busy_ = false;                   // read and written with the interpreter's lock
  const Progress* reported_ = nullptr;  // of the change that is being made
  std::optional<DiagramEditor> editor_;
  MeshDiagram diagram_;
};

/// Adds the members `write` and `page`, which every result has.
template <class Result, class Class>
void bind_files(Class& bound) {
  bound.def("write", [](const Result& result, const std::filesystem::path& path, const WriteOptions& options) {
    run_unlocked(py::none(),
                 [&](const Progress&) { write_result(path, labelled(result), own_formats(result), options); });
  });
  bound.def("page", [](const Result& result, const std::string& title) {
    return run_unlocked(py::none(), [&](const Progress&) { return make_page(labelled(result), title); });
  });
}

/// A method that gives a view of the array at `get(result)`.
template <class Result, class Get>
auto member_view(Get get) {
  return [get](const py::object& self) { return view(get(self.cast<const Result&>()), self); };
}

/// The further numbers of the faces by their names, as views.
py::dict numbers_of(const py::object& self) {
  py::dict found;
  for (const FaceNumbers& each : self.cast<const Segmented&>().numbers)
    found[each.name.c_str()] = view(each.values, self);
  return found;
}

void bind_results(py::module_& module) {
  py::class_<Segmented> segmented(module, "Segmentation");
  segmented.def("labels", member_view<Segmented>([](const Segmented& s) -> auto& { return s.segmentation.face_label; }))
      .def("without_face",
           member_view<Segmented>([](const Segmented& s) -> auto& { return s.segmentation.without_face; }))
      .def("border_length",
           [](const Segmented& s) { return compute_border_length(s.of.surface(), s.segmentation.face_label); })
      .def("numbers", &numbers_of);
  bind_files<Segmented>(segmented);

  py::class_<Cut> cut_class(module, "Cut");
  cut_class.def("mesh", &Cut::mesh)
      .def("charts", &charts)
      .def("scale", [](const Cut& c) { return c.charts.scale; })
      .def("labels", member_view<Cut>([](const Cut& c) -> auto& { return c.cut.label; }))
      .def("parents", member_view<Cut>([](const Cut& c) -> auto& { return c.cut.parent; }))
      .def("vertex_labels", member_view<Cut>([](const Cut& c) -> auto& { return c.vertices.label; }))
      .def("distances", member_view<Cut>([](const Cut& c) -> auto& { return c.vertices.distance; }));
  bind_files<Cut>(cut_class);
}

}  // namespace

DiagramOptions ComputeOptions::make() const {
  DiagramOptions options;
  options.method = choose("method", method, kMethodNames);
  if (front) options.front = choose("front", *front, kFrontNames);
  if (chord_tolerance) options.chord_tolerance = *chord_tolerance;
  options.threads = threads;
  return options;
}

namespace {

std::vector<ViewScene> make_scenes(const LabelledMesh& mesh) {
  if (mesh.diagram != nullptr) {
    const bool is_diagram = mesh.face_label == &mesh.diagram->face_label;  // its cut faces have pieces, not labels
    return is_diagram ? std::vector{make_view_scene("Regions", mesh.surface(), *mesh.diagram)}
                      : make_region_scenes(mesh);
  }
  ViewScene scene;
  scene.mesh = &mesh.mesh;
  return {scene};
}

}  // namespace

std::string make_page(const LabelledMesh& mesh, const std::string& title) {
  ViewOptions options;
  options.title = title;
  return make_view_page(make_scenes(mesh), options);
}

void write_result(const std::filesystem::path& path, LabelledMesh mesh, const OwnFormats& own,
                  const WriteOptions& options) {
  const std::string extension = to_lower(path.extension().string());
  for (const auto& [format, write] : own) {
    if (extension == "." + format) return write_file(path, write);
  }
  if (extension == ".html") {
    const std::string page = make_page(mesh, options.title);
    return write_file(path, [&](std::ostream& out) { out << page; });
  }
  mesh.no_bisectors = options.no_curves;
  mesh.ascii_ply = options.ascii_ply;
  mesh.region_materials = options.region_materials;
  write_mesh(path, mesh);
}

void bind_diagram(py::module_& module) {
  py::class_<ComputeOptions>(module, "ComputeOptions")
      .def(py::init(
          [](std::string method, std::optional<std::string> front, std::optional<double> chord_tolerance, int threads) {
            return ComputeOptions{std::move(method), std::move(front), chord_tolerance, threads};
          }));
  py::class_<WriteOptions>(module, "WriteOptions")
      .def(py::init([](std::string title, bool no_curves, bool ascii_ply, bool region_materials) {
        return WriteOptions{std::move(title), no_curves, ascii_ply, region_materials};
      }));

  py::class_<MeshDiagram> diagram(module, "Diagram");
  diagram.def("labels", member_view<MeshDiagram>([](const MeshDiagram& d) -> auto& { return d.diagram->vertex_label; }))
      .def("distances",
           member_view<MeshDiagram>([](const MeshDiagram& d) -> auto& { return d.diagram->vertex_distance; }))
      .def("face_labels", member_view<MeshDiagram>([](const MeshDiagram& d) -> auto& { return d.diagram->face_label; }))
      .def("weights", member_view<MeshDiagram>([](const MeshDiagram& d) -> auto& { return d.diagram->weights; }))
      .def(
          "generators",
          [](const py::object& self) { return view_points(self.cast<const MeshDiagram&>().diagram->generators, self); })
      .def("branch_points", &branch_points)
      .def("bisector_count", [](const MeshDiagram& d) { return d.diagram->bisectors.size(); })
      .def("bisector", &bisector)
      .def("cells", &cells)
      .def("length", [](const MeshDiagram& d) { return d.diagram->length; })
      .def("unresolved_ends", [](const MeshDiagram& d) { return d.diagram->report.unresolved_ends; })
      .def("discs", &discs)
      .def("segment", &segment)
      .def("cut", &cut)
      .def("check", [](const MeshDiagram& d) {
        return run_unlocked(
            py::none(), [&](const Progress&) { return check_diagram(d.surface(), d.surface_diagram()).violations; });
      });
  bind_files<MeshDiagram>(diagram);
  bind_results(module);
  module.def("diagram", &make_diagram<PointList, &PointList::points>);
  module.def("diagram", &make_diagram<CurveSet, &CurveSet::curves>);
  module.def("diagram_inside", &diagram_inside);
  py::class_<Editor>(module, "DiagramEditor")
      .def(py::init<const SharedMesh&, const PointList&, const ComputeOptions&, const py::object&>())
      .def("diagram", &Editor::diagram)
      .def("move", &Editor::move)
      .def("add", &Editor::add)
      .def("remove", &Editor::remove);
}

}  // namespace gvd::python
