// What a segmentation consists of: figures, tables of its regions and charts, arrays, and what files hold of it.

#include <ostream>
#include <utility>

#include "figures.hpp"
#include "gvd/diagram_parts.hpp"
#include "gvd/io/label_color.hpp"
#include "gvd/segment_operation.hpp"

namespace gvd {
namespace {

/// The figures of whole faces.
void tell_whole(const Figures& figure, const SegmentOutcome& made) {
  const Segmentation& whole = or_none(made.whole);
  figure("generators_without_face", "", "whose cells lie inside faces of others", each_of(whole.without_face));
  figure("moved_faces", "", "labelled with a cell that has not the largest share, to connect regions",
         whole.moved_faces);
  figure("given_faces", "", "given to generators that would own none", whole.given_faces);
  figure("smoothed_faces", "", "with another label than the nearest one has", whole.smoothed_faces);
  figure("border_length", "mesh units", "of the edges between regions", made.border_length);
  const double bisectors = made.diagram->length;
  figure("border_ratio", "", "that length by that of the bisectors",
         bisectors > 0 ? Figure(made.border_length / bisectors) : Figure());
}

Table list_regions(const SegmentOutcome& made) {
  const std::vector<SurfacePoint>& generators = made.diagram->generators;
  const Mesh& mesh = made.cut ? made.cut->mesh : made.input->mesh;
  const IdVector<GeneratorId, RegionSize> sizes = measure_regions(mesh, made.face_labels(), generators.size());
  Table table{{"label", each_of(sizes.ids())}};
  for (const FaceNumbers& numbers : made.parted.numbers) {
    table.push_back({numbers.name, each_of(generators, [&](const auto& point) { return numbers.values[point.face]; })});
  }
  table.push_back({"faces", each_of(sizes, &RegionSize::faces)});
  table.push_back({"area", each_of(sizes, &RegionSize::area)});
  return table;
}

std::vector<double> box_of(const Chart& chart) {
  if (chart.box.isEmpty()) return {};
  return {chart.box.min().x(), chart.box.min().y(), chart.box.max().x(), chart.box.max().y()};
}

Table list_charts(const std::vector<Chart>& charts, ChartMap map) {
  const auto share_of = [&](double Chart::*part) {
    return each_of(charts, [part](const Chart& chart) { return chart.area > 0 ? chart.*part / chart.area : 0; });
  };
  Table table{{"label", each_of(charts, &Chart::generator)}, {"faces", each_of(charts, &Chart::faces)},
              {"area", each_of(charts, &Chart::area)},       {"flipped_share", share_of(&Chart::flipped_area)},
              {"stretch", each_of(charts, &Chart::stretch)}, {"box", each_of(charts, box_of)}};
  if (map == ChartMap::flat) return table;
  table.push_back({"torn_share", share_of(&Chart::torn_area)});
  table.push_back({"origin", each_of(charts, [](const Chart& chart) {
                     return std::vector<double>{chart.origin.x(), chart.origin.y()};
                   })});
  return table;
}

void tell_charts(ObjectVisitor& visitor, const SegmentOutcome& made) {
  const Figures figure(visitor, "charts", made.charts.has_value());
  const Charts& charts = or_none(made.charts);
  figure("scale", "texture units per mesh unit", "of all charts", charts.scale);
  figure("covered_share", "", "of the texture", charts.covered);
  figure("flipped_share", "", "of the area: faces that are flipped", charts.share(&Chart::flipped_area));
  figure("torn_share", "", "of the area: faces that are torn off", charts.share(&Chart::torn_area));
  figure("unplaced_share", "", "of the area: faces without texture coordinates", charts.share(&Chart::unplaced_area));
  visitor.table({"charts.charts", "", "the connected parts of regions"}, list_charts(charts.charts, made.chart_map));
}

/// Colours in sRGB, 0 to 255.
class ColorsObject : public Object {
 public:
  explicit ColorsObject(std::vector<Rgb> colors) : colors_(std::move(colors)) { colors_.push_back(kUnlabelledColor); }
  std::string_view kind() const override { return "colors"; }
  void visit(ObjectVisitor& visitor) const override {
    visitor.array({"colors", "", "red, green and blue"},
                  {colors_.data(), ArrayType::uint8, 2, {std::ssize(colors_), 3}, {sizeof(Rgb), 1}});
  }

 private:
  std::vector<Rgb> colors_;
};

}  // namespace

const IdVector<FaceId, GeneratorId>& SegmentOutcome::face_labels() const {
  static const IdVector<FaceId, GeneratorId> kNone;
  return cut ? cut->label : whole ? whole->face_label : kNone;
}

std::optional<LabelledMesh> SegmentOutcome::labelled() const {
  if (!cut) {
    LabelledMesh mesh = label_mesh(input->mesh, *on_input, whole->face_label);
    mesh.diagram = diagram.get();
    mesh.diagram_mesh = &surface();
    mesh.face_numbers = &whole_numbers;
    mesh.appearance = &input->appearance;
    return mesh;
  }
  LabelledMesh mesh{cut->mesh,     &cut->label, &cut->parent, &cut_vertices.label, &cut_vertices.distance,
                    diagram.get(), &surface()};
  mesh.face_numbers = &cut->numbers;
  mesh.appearance = &appearance;
  return mesh;
}

std::vector<std::vector<Vec3>> SegmentOutcome::borders() const {
  std::vector<std::vector<Vec3>> borders;
  const Mesh& mesh = input->mesh;
  if (!parted.is_parted()) return borders;
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    if (!twin.valid() || parted.regions[Mesh::face(h)] == parted.regions[Mesh::face(twin)]) continue;
    borders.push_back({mesh.position(mesh.from(h)), mesh.position(mesh.to(h))});
  }
  return borders;
}

OwnWriters SegmentOutcome::own_writers() const {
  return {{"json", [this](std::ostream& out) {
             if (cut) return write_cut_json(out, input->mesh, *on_input, *cut, cut_vertices);
             write_segmentation_json(out, input->mesh, *on_input, *whole, whole_numbers);
           }}};
}

void SegmentOutcome::visit(ObjectVisitor& visitor) const {
  const Mesh& mesh = cut ? cut->mesh : input->mesh;
  visit_parted(visitor, parted);
  visit_balance(visitor, balanced);
  const Figures figure(visitor), disc(visitor, "disc", discs.has_value());
  figure("weights", "mesh units", "of the generators, where there are any",
         diagram->weights.empty() ? Figure() : Figure(diagram->weights));
  disc("added", "", "generators, so that every cell is a disc", or_none(discs).added);
  disc("rounds", "", "diagrams to which generators were added", or_none(discs).rounds);
  disc("search_cut_short", "", "whether fewer may do", or_none(discs).search_cut_short);
  figure("uncut_faces", "", "that could not be cut", cut ? Figure(plain(cut->uncut_faces)) : Figure());
  tell_whole(Figures(visitor, "", whole.has_value()), *this);
  figure("faces", "", "of the labelled mesh", mesh.face_count());
  figure("unreached_faces", "", "that no generator reaches", unreached_faces);
  visitor.table({"regions", "", "faces and area of each label"}, list_regions(*this));
  tell_charts(visitor, *this);

  visitor.points({"generators", "", "by their labels"}, diagram->generators);
  visitor.array({"face_labels", "", "the region of each face, or of each piece; -1: none"}, view(face_labels()));
  const IdVector<FaceId, FaceId> no_parents;
  visitor.array({"face_parents", "", "the face of the input that each piece is of; empty without cut"},
                view(cut ? cut->parent : no_parents));
  visitor.array({"vertex_labels", "", "the nearest generator of each vertex; -1: none"},
                view(cut ? cut_vertices.label : on_input->vertex_label));
  visitor.array({"vertex_distances", "mesh units", "the distance from it"},
                view(cut ? cut_vertices.distance : on_input->vertex_distance));
  for (const FaceNumbers& numbers : this->numbers()) {
    visitor.array({numbers.name, "", "of each face: its region, or its label at that level"}, view(numbers.values));
  }
  static const std::vector<Uv> kNone;
  visitor.array({"texture", "", "u and v of the three corners of each piece; empty without uv"},
                view(charts ? appearance.texture : kNone));
  visitor.part({"diagram", "", "of the generators, with the vertices of the input"}, "diagram", [this] {
    return std::make_shared<DiagramObject>(input, on_input, options, keep_separated(parted, diagram));
  });
  visitor.part({"colors", "", "of the labels, as in files and on pages; that of no label follows"}, "colors",
               [this]() -> std::shared_ptr<const Object> {
                 if (const auto shown = labelled()) return std::make_shared<ColorsObject>(region_colors(*shown));
                 return nullptr;
               });
  visitor.part({"cut_mesh", "", "the pieces of the faces, made with cut"}, "mesh",
               [this]() -> std::shared_ptr<const Object> {
                 if (!cut) return nullptr;
                 auto pieces = std::make_shared<CheckedMesh>(as_input(cut->mesh));
                 pieces->appearance = appearance;
                 return std::make_shared<MeshObject>(std::move(pieces));
               });
}

}  // namespace gvd
