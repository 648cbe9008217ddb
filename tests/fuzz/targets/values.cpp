// Feeds the readers of values of vertices and faces: GIFTI, FreeSurfer's annotations and values, NumPy's arrays, text.
#include <bit>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz/targets/require.hpp"
#include "gvd/io/distance_writer.hpp"
#include "gvd/read_values.hpp"

namespace {

using namespace gvd;

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// Numbers come back with the same bits from an NPY, and as the nearest floats from the formats of 32 bits.
void check_written(const std::vector<double>& values) {
  const DistanceTable table{.rows = {values}, .nearest = std::vector<GeneratorId>(values.size())};
  std::ostringstream npy, gifti, freesurfer;
  write_distances_npy(npy, table);
  write_distances_gifti(gifti, table);
  write_distances_freesurfer(freesurfer, table, 0);
  fuzz::attempt({}, [&] {
    const std::vector<double> doubles = parse_values(npy.str(), "the written file");
    fuzz::require(doubles.size() == values.size(), "another number of values comes back from an NPY");
    for (const std::string& bytes : {gifti.str(), freesurfer.str()}) {
      const std::vector<double> singles = parse_values(bytes, "the written file");
      fuzz::require(singles.size() == values.size(), "another number of values comes back");
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double wanted = static_cast<float>(values[i]);
        fuzz::require(same_bits(wanted, singles[i]) || std::isnan(wanted), "a value comes back as another float");
        fuzz::require(same_bits(values[i], doubles[i]) || std::isnan(values[i]),
                      "a value comes back as another double");
      }
    }
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  std::vector<double> values;
  if (fuzz::attempt({ErrorCode::unreadable_input}, [&] { values = parse_values(bytes, "input"); })) {
    check_written(values);
  }
  return 0;
}
