#include "diffusion/heat_envelope.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/barycentric.hpp"

namespace gvd::paper {

HeatEnvelope::HeatEnvelope(const Mesh& mesh, const HeatField& field, int most_splits)
    : mesh_(mesh), field_(field), most_splits_(most_splits), label_(static_cast<std::size_t>(mesh.vertex_count())) {
  std::vector<double> most(label_.size(), 0);
  for (std::size_t g = 0; g < field.heat.size(); ++g) {
    for (std::size_t v = 0; v < most.size(); ++v) {
      if (!(field.heat[g][v] > most[v])) continue;
      most[v] = field.heat[g][v];
      label_.raw()[v] = GeneratorId(g);
    }
  }
}

bool HeatEnvelope::cut(FaceId f, Pieces& pieces) {
  face_ = f;
  capped_ = false;
  const auto& corners = mesh_.vertices(f);
  const GeneratorId label = label_[corners[0]];
  if (label_[corners[1]] == label && label_[corners[2]] == label) {
    pieces.push_back({f, label, whole_face()});
    return false;
  }
  find_candidates(f);
  cut({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 0, pieces);
  return capped_;
}

/// A generator whose largest heat in the face is below another one's least heat there is left out.
void HeatEnvelope::find_candidates(FaceId f) {
  const auto& corners = mesh_.vertices(f);
  candidates_.clear();
  forms_.clear();
  double most_of_least = 0;
  for (const auto& heat : field_.heat) {
    const double least = std::min({heat[corners[0].index()], heat[corners[1].index()], heat[corners[2].index()]});
    most_of_least = std::max(most_of_least, least);
  }
  for (std::size_t g = 0; g < field_.heat.size(); ++g) {
    const auto& heat = field_.heat[g];
    const LinearForm form{heat[corners[0].index()], heat[corners[1].index()], heat[corners[2].index()]};
    const double most = *std::max_element(form.begin(), form.end());
    if (!(most > 0) || most < most_of_least) continue;
    candidates_.emplace_back(static_cast<std::int64_t>(g));
    forms_.push_back(form);
  }
}

/// The heat at the face's corners. Where no heat arrives, none of the candidates does: then it is the floor.
LinearForm HeatEnvelope::heat(GeneratorId g) const {
  const auto it = std::find(candidates_.begin(), candidates_.end(), g);
  if (it == candidates_.end()) return {HeatField::kFloor, HeatField::kFloor, HeatField::kFloor};
  return forms_[it - candidates_.begin()];
}

GeneratorId HeatEnvelope::warmest(const Bary& bary) const {
  GeneratorId best;
  double most = 0;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const double heat = interpolate(bary, forms_[i][0], forms_[i][1], forms_[i][2]);
    if (!(heat > most)) continue;
    most = heat;
    best = candidates_[i];
  }
  return best;
}

LinearForm HeatEnvelope::difference(GeneratorId a, GeneratorId b) const {
  const LinearForm first = heat(a), second = heat(b);
  return {first[0] - second[0], first[1] - second[1], first[2] - second[2]};
}

void HeatEnvelope::cut(const Triangle& triangle, int splits, Pieces& pieces) {
  const Triangle middles{mix(triangle[0], triangle[1], 0.5), mix(triangle[1], triangle[2], 0.5),
                         mix(triangle[2], triangle[0], 0.5)};
  std::array<GeneratorId, 3> label;
  std::set<GeneratorId> labels;
  for (std::size_t i = 0; i < 3; ++i) labels.insert(label[i] = warmest(triangle[i]));
  if (labels.size() == 1) {
    pieces.push_back({face_, label[0], {triangle.begin(), triangle.end()}});
    return;
  }
  for (const Bary& middle : middles) labels.insert(warmest(middle));
  if (labels.size() == 2) {
    cut_in_two(triangle, *labels.begin(), *labels.rbegin(), pieces);
  } else if (splits < most_splits_) {
    split(triangle, middles, splits + 1, pieces);
  } else {
    capped_ = true;
    join_in_centre(triangle, label, pieces);
  }
}

void HeatEnvelope::split(const Triangle& triangle, const Triangle& middles, int splits, Pieces& pieces) {
  for (std::size_t i = 0; i < 3; ++i) cut({triangle[i], middles[i], middles[(i + 2) % 3]}, splits, pieces);
  cut(middles, splits, pieces);
}

void HeatEnvelope::cut_in_two(const Triangle& triangle, GeneratorId a, GeneratorId b, Pieces& pieces) const {
  const Polygon polygon(triangle.begin(), triangle.end());
  for (const GeneratorId g : {a, b}) {
    Polygon part = clip_polygon(polygon, difference(g, g == a ? b : a), g == a);
    if (!part.empty()) pieces.push_back({face_, g, std::move(part)});
  }
}

/// Two labels at the corners: the line of these two. Three: their crossings with the sides meet in the centre.
void HeatEnvelope::join_in_centre(const Triangle& triangle, const std::array<GeneratorId, 3>& label,
                                  Pieces& pieces) const {
  const auto [least, most] = std::minmax({label[0], label[1], label[2]});
  if (label[0] == label[1] || label[1] == label[2] || label[2] == label[0]) {
    return cut_in_two(triangle, least, most, pieces);
  }
  Bary centre{};
  Triangle crossing;
  for (std::size_t i = 0; i < 3; ++i) {
    for (const Bary& corner : triangle) centre[i] += corner[i] / 3;
    const std::size_t j = (i + 1) % 3;
    const LinearForm form = difference(label[i], label[j]);
    const double from = evaluate(form, triangle[i]), to = evaluate(form, triangle[j]);
    crossing[i] = mix(triangle[i], triangle[j], from > to ? std::clamp(from / (from - to), 0.0, 1.0) : 0.5);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    pieces.push_back({face_, label[i], {triangle[i], crossing[i], centre, crossing[(i + 2) % 3]}});
  }
}

}  // namespace gvd::paper
