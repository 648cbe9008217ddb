#include <cstdlib>

#include "models.hpp"
#include "support/catch.hpp"

namespace gvd::test_models {

using namespace paper;

const std::string kData = GVD_SOURCE_DIR "/data";

TEST_CASE("the first file at hand stands for a model, as it is where its size fits") {
  const FoundMesh found = Models({kData}, 1).find({"Ring", 1570, {"ring", "torus", "plate"}});
  CHECK(found.name == "torus.ply");
  CHECK(found.mesh.face_count() == 1600);
}

TEST_CASE("a mesh of another size is resampled, and its name says so") {
  const FoundMesh found = Models({kData}, 1).find({"Ring", 600, {"torus"}});
  CHECK(found.name == "torus.ply, resampled");
  CHECK(std::abs(found.mesh.face_count() - 600) <= 18);
  CHECK(Models({kData}, 1).find({"Ring", 1500, {"torus"}}).name == "torus.ply, resampled");
}

TEST_CASE("a scale multiplies the size of the paper's model, and of a mesh without one") {
  CHECK(Models({kData}, 0.5).find({"Ring", 1200, {"torus"}}).mesh.face_count() < 800);
  CHECK(Models({kData}, 0.5).find({"Ring", 0, {"torus"}}).mesh.face_count() < 1000);
}

TEST_CASE("the figure stands for a model that is not at hand") {
  CHECK(Models({}, 1).find({"Lucy", 0, {"lucy"}}).name == "figure.obj");
  CHECK(Models({kData}, 1).find({"Lucy", 0, {"lucy"}}).name == "figure.obj");
}

TEST_CASE("a mesh with a boundary is taken as it is") {
  CHECK(Models({kData}, 1).find({"Bowl", 5000, {"half_sphere"}}).name == "half_sphere.off");
}

}  // namespace gvd::test_models
