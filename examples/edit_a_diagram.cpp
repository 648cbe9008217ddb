// Moves, adds and removes generators of an exact diagram; each change computes what it has an effect on.
//
//   edit_a_diagram MESH
#include <gvd/diagram_editor.hpp>
#include <gvd/error.hpp>
#include <gvd/read_soup.hpp>
#include <gvd/sampling.hpp>
#include <gvd/soup.hpp>
#include <iostream>

int main(int argc, char** argv) try {
  if (argc != 2) throw gvd::Error(gvd::ErrorCode::invalid_option, "give one mesh");
  const gvd::Mesh mesh = gvd::build_mesh(gvd::read_soup(argv[1])).mesh;
  gvd::SamplingOptions sampling;
  sampling.count = 50;
  gvd::DiagramEditor editor(mesh, gvd::sample_generators(mesh, sampling));

  const auto print = [&](const char* what) {
    std::cout << what << ": " << editor.diagram().cells.size() << " cells, bisectors of length "
              << editor.diagram().length << ", " << editor.propagated() << " generators propagated\n";
  };
  print("start");
  const gvd::GeneratorId g(7);
  const gvd::FaceId face = editor.generators()[g.index()].face;
  editor.move(g, gvd::make_surface_point(face, {0.2, 0.3, 0.5}));
  print("moved");
  editor.add(gvd::vertex_point(mesh, gvd::VertexId(mesh.vertex_count() / 2)));
  print("added");
  editor.remove(g);  // the last generator gets its number
  print("removed");
  return 0;
} catch (const gvd::Error& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
