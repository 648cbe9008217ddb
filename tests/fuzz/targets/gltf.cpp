// Feeds the reader of glTF in JSON, with buffers in data URIs, and the repair behind it.
#include "fuzz/targets/round_trip.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gvd::fuzz::check_reading(data, size, gvd::MeshFormat::gltf);
  return 0;
}
