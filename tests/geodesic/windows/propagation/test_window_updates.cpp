// Windows that follow changes of generators have the bits of new ones, and so has the record of all that were carried.
#include <vector>

#include "geodesic/windows/propagation/window_updates.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_window_updates {

std::vector<Window> windows_of(const WindowField& field, FaceId f) {
  std::vector<Window> windows;
  field.windows.for_each(f, [&](const Window& w) { windows.push_back(w); });
  return windows;
}

bool same(const Window& a, const Window& b) {
  return a.begin == b.begin && a.end == b.end && a.x == b.x && a.depth == b.depth && a.offset == b.offset &&
         a.generator == b.generator && a.halfedge == b.halfedge;
}

void require_same(const Mesh& mesh, const EditableWindows& updated, const EditableWindows& fresh) {
  REQUIRE(updated.field().distance == fresh.field().distance);
  REQUIRE(updated.field().label == fresh.field().label);
  REQUIRE(updated.field().carried == fresh.field().carried);
  REQUIRE(updated.record().mode == fresh.record().mode);
  REQUIRE(updated.record().halfedge == fresh.record().halfedge);
  REQUIRE(updated.record().multi_label == fresh.record().multi_label);
  for (const FaceId f : mesh.faces()) {
    const auto a = windows_of(updated.field(), f), b = windows_of(fresh.field(), f);
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) REQUIRE(same(a[i], b[i]));
  }
}

TEST_CASE("updated windows, and the records of those that were dropped, have the bits of new ones") {
  const std::vector<test::NamedMesh> meshes{{"several partitions", test::make_bumpy_sphere(5, 7)},
                                            {"ties", test::make_grid(60, 45)},
                                            {"thin faces", test::make_thin_faced_sphere(4, 7)},
                                            {"boundary", test::make_ring(120, 20)}};
  for (const auto& [name, mesh] : meshes) {
    std::vector<SurfacePoint> points = test::random_generators(mesh, 50, 1);
    const std::vector<SurfacePoint> targets = test::random_generators(mesh, 70, 2);
    auto working = std::make_unique<WorkingMesh>(mesh, points);
    EditableWindows windows(*working, 2, {});
    int local = 0;
    for (int i = 50; i < 70; ++i) {
      INFO(name << ", move " << i);
      const GeneratorId g(i % 7);
      const SurfacePoint from = std::exchange(points[g.index()], targets[static_cast<std::size_t>(i)]);
      auto after = std::make_unique<WorkingMesh>(mesh, points);
      const ChangedGenerators changed{{g}, {g}, {from, points[g.index()]}};
      const CommonElements common = find_common_elements(*working, *after, changed);
      const WindowChange change = windows.update({*working, *after, common, changed}, {});
      working = std::move(after);
      local += change.propagated < 25 ? 1 : 0;
      require_same(working->mesh(), windows, EditableWindows(*working, 1, {}));
    }
    CHECK(local > 10);
  }
}

}  // namespace gvd::test_window_updates
