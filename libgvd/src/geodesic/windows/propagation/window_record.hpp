#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "geodesic/windows/window.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// A digest of all windows that were carried from a halfedge, in their order and with their buckets. If two runs have
/// the same records along a closed strip of faces, the faces on one side of the strip have had the same effect on the
/// other side in both runs.
struct HalfedgeRecord {
  std::uint64_t digest = 0;
  std::uint32_t count = 0;  ///< number of windows; those that end at the boundary are counted, too

  bool operator==(const HalfedgeRecord&) const = default;
};

/// Properties of the mesh as a whole on which each window depends; see FaceFrames.
struct PropagationMode {
  bool has_needles = false, has_thin_faces = false;
  int drift = 0;  ///< the power of two in the drift of directions, if there are thin faces

  bool operator==(const PropagationMode&) const = default;
};

/// The windows that a propagation has carried, for later updates (window_updates.hpp).
struct WindowRecord {
  IdVector<HalfedgeId, HalfedgeRecord> halfedge;
  PropagationMode mode;
  IdVector<FaceId, std::uint8_t> multi_label;  ///< 1 for faces that have, or at some time had, several labels
};

/// For propagations that are not updated later. All calls compile to nothing.
struct NoRecorder {
  static bool allows(HalfedgeId) { return true; }
  static void record(HalfedgeId, const Window&, double) {}
};

/// Records windows, and keeps windows out of closed faces. Each partition writes the records of its own halfedges.
class WindowRecorder {
 public:
  /// `is_open` is 1 for faces that windows may enter. Both arguments must outlive this object.
  WindowRecorder(const IdVector<FaceId, std::uint8_t>& is_open, IdVector<HalfedgeId, HalfedgeRecord>& records)
      : is_open_(&is_open), records_(&records) {}

  /// Windows without a halfedge end at the boundary.
  bool allows(HalfedgeId h) const { return !h.valid() || (*is_open_)[Mesh::face(h)] != 0; }
  [[gnu::always_inline]] void record(HalfedgeId h, const Window& w, double settled) const {
    HalfedgeRecord& record = (*records_)[h];
    ++record.count;
    const std::uint64_t window = bits(w.begin) * kOdd[0] + bits(w.end) * kOdd[1] + bits(w.x) * kOdd[2] +
                                 bits(w.depth) * kOdd[3] + bits(w.offset) * kOdd[4] + bits(settled) * kOdd[5];
    record.digest = std::rotl((record.digest ^ window) * kOdd[0], 29) + static_cast<std::uint64_t>(w.generator.value());
  }

 private:
  /// Multipliers of splitmix64 (Steele, Lea and Flood, 2014), xxHash64 (Collet, 2012) and MurmurHash3 (Appleby, 2008).
  static constexpr std::uint64_t kOdd[] = {0x9e3779b97f4a7c15u, 0xc2b2ae3d27d4eb4fu, 0x165667b19e3779f9u,
                                           0x85ebca77c2b2ae63u, 0x27d4eb2f165667c5u, 0xff51afd7ed558ccdu};
  static std::uint64_t bits(double number) {
    std::uint64_t result = 0;
    std::memcpy(&result, &number, sizeof(result));
    return result;
  }

  const IdVector<FaceId, std::uint8_t>* is_open_;
  IdVector<HalfedgeId, HalfedgeRecord>* records_;
};

}  // namespace gvd
