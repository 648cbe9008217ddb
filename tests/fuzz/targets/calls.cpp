// Feeds the options of every operation, as JSON with arrays: what the C interface reads before it runs one. Those of a
// diagram run.
#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "fuzz/targets/require.hpp"
#include "gvd/diagram_operation.hpp"
#include "gvd/operation.hpp"
#include "gvd/operation_json.hpp"

namespace {

using namespace gvd;

/// An octahedron.
const MeshPtr& ball() {
  static const MeshPtr kBall = [] {
    const std::vector<Vec3> corners{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<std::array<VertexId, 3>> faces;
    for (const auto& [a, b, c] : {std::array{0, 2, 4}, std::array{2, 1, 4}, std::array{1, 3, 4}, std::array{3, 0, 4},
                                  std::array{2, 0, 5}, std::array{1, 2, 5}, std::array{3, 1, 5}, std::array{0, 3, 5}}) {
      faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
    }
    return std::make_shared<const CheckedMesh>(as_input(Mesh(corners, faces)));
  }();
  return kBall;
}

std::shared_ptr<const Object> make_diagram() {
  DiagramCall call;
  call.generators.count = 3;
  call.editable = true;
  Observer silent;
  silent.threads = 1;
  return run(ball(), call, silent);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string json(reinterpret_cast<const char*>(data), size);
  static const std::vector<double> kNumbers{0, 1, 2, 3, 4, 5, 0.5, 0.25};
  static const std::vector<std::array<double, 3>> kPositions{{1, 0, 0}, {0, 1, 0}};
  static const std::vector<std::array<double, 4>> kInFaces{{0, 1, 0, 0}, {9, 0, 0, 1}};
  const std::array arrays{view(kNumbers), view(kPositions), view(kInFaces), ArrayView{}};
  for (const Operation& operation : operations()) {
    const auto call = operation.call();
    OptionList list;
    call->describe(list);
    Given given;
    const bool is_read =
        fuzz::attempt({ErrorCode::invalid_option}, [&] { given = read_json_options(list, *ball(), json, arrays); });
    if (!is_read) continue;
    fuzz::attempt({}, [&] { options_json(list, given); });
    if (operation.on != "diagram") continue;
    fuzz::attempt({ErrorCode::invalid_option, ErrorCode::precondition}, [&] {
      Observer silent;
      silent.threads = 1;
      figures_json(*call->run(make_diagram(), silent));
    });
  }
  return 0;
}
