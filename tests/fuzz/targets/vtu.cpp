// Feeds the reader of VTK's UnstructuredGrid in XML, and the repair behind it.
#include "fuzz/targets/round_trip.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gvd::fuzz::check_reading(data, size, gvd::MeshFormat::vtu);
  return 0;
}
