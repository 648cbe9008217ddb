#pragma once

#include <cstdint>
#include <vector>

#include "diagram/envelope/trace_envelope.hpp"
#include "diagram/graph/connected_tracer.hpp"
#include "geodesic/windows/window_field.hpp"
#include "mesh/common_elements.hpp"

namespace gvd {

/// The diagram before some generators changed, and where it differs from the present one.
struct KnownTrace {
  const Mesh& mesh;  ///< the working mesh before the change
  const TracedDiagram& traced;
  const CommonElements& common;
  const IdVector<FaceId, std::uint8_t>& is_changed;  ///< 1 for a face that is new, or whose sources have changed
  const std::vector<FaceId>& changed;                ///< faces that are new, or whose corners' distances have changed
};

/// The envelope tracer after a change of some generators. Edges and faces whose sources have not changed keep their
/// crossings and arcs. The result has the same bits as that of the envelope tracer.
class RetracingTracer final : public DiagramTracer {
 public:
  /// All arguments must outlive the tracer.
  RetracingTracer(const EnvelopeTracer& tracer, const WorkingMesh& working, const WindowField& field,
                  const KnownTrace& known)
      : tracer_(tracer), mesh_(working.mesh()), field_(field), known_(known) {}

  /// 1 for the faces that kept their arcs in the last call of `close_faces`.
  IdVector<FaceId, std::uint8_t> take_kept() { return std::move(kept_); }

  Crossings cross_edges(const NearestLabels& labels) const override;
  void cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                          Crossings& crossings) const override {
    tracer_.cross_at_most_once(edges, labels, crossings);
  }
  void close_faces(TracedDiagram& traced) override;

 private:
  bool is_known(HalfedgeId h) const;
  bool is_contested(HalfedgeId h, const NearestLabels& labels) const;
  bool has_known_crossings(FaceId f, const Crossings& crossings, std::vector<BoundaryCrossing>& now,
                           std::vector<BoundaryCrossing>& before) const;

  const EnvelopeTracer& tracer_;
  const Mesh& mesh_;
  const WindowField& field_;
  const KnownTrace& known_;
  IdVector<FaceId, std::uint8_t> kept_;
};

}  // namespace gvd
