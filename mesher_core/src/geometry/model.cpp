#include "geometry/model.h"

#include <TopoDS.hxx>
#include <algorithm>

#include "geometry/occt_shape.h"

namespace advlayers {

Model::Model() = default;
Model::~Model() = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(Model&&) noexcept = default;

const TopoDS_Face& Model::Shape::face(FaceId f) const {
  return TopoDS::Face(faces.FindKey(f.value + 1));
}

const TopoDS_Edge& Model::Shape::edge(EdgeId e) const {
  return TopoDS::Edge(edges.FindKey(e.value + 1));
}

const Pcurve* Model::Shape::pcurve(FaceId f, EdgeId e, int which) const {
  const std::vector<Pcurve>& of_face = pcurves[f.index()];
  const auto before = [](const Pcurve& p, const std::pair<EdgeId, int>& key) {
    return p.edge < key.first || (p.edge == key.first && p.which < key.second);
  };
  const auto it =
      std::lower_bound(of_face.begin(), of_face.end(), std::make_pair(e, which), before);
  return it != of_face.end() && it->edge == e && it->which == which ? &*it : nullptr;
}

// By EdgeId; 0 for poles, and for edges of no face.
std::vector<int> Model::side_counts() const {
  std::vector<int> sides(edges_.size(), 0);
  for (const Face& face : faces_) {
    for (const auto& loop : face.loops) {
      for (const CoEdge& coedge : loop) sides[coedge.edge.index()] += coedge.degenerate ? 0 : 1;
    }
  }
  return sides;
}

bool Model::closed() const {
  const std::vector<int> sides = side_counts();
  const auto two_or_none = [](int count) { return count == 2 || count == 0; };
  return !faces_.empty() && std::all_of(sides.begin(), sides.end(), two_or_none);
}

int Model::free_edges() const {
  const std::vector<int> sides = side_counts();
  return static_cast<int>(std::count(sides.begin(), sides.end(), 1));
}

std::size_t Model::given_edges() const { return sewn() ? shape_->pieces.size() : edges_.size(); }

bool Model::sewn() const { return !shape_->pieces.empty(); }

std::vector<EdgeId> Model::pieces(EdgeId given) const {
  if (given.index() < shape_->pieces.size()) return shape_->pieces[given.index()];
  return {given};
}

int Model::joined_edges() const {
  std::vector<int> given(edges_.size(), 0);
  for (const auto& pieces : shape_->pieces) {
    for (const EdgeId piece : pieces) ++given[piece.index()];
  }
  return static_cast<int>(
      std::count_if(shape_->pieces.begin(), shape_->pieces.end(), [&](const auto& pieces) {
        return std::any_of(pieces.begin(), pieces.end(),
                           [&](EdgeId piece) { return given[piece.index()] > 1; });
      }));
}

double Model::dihedral_angle(EdgeId e) const { return shape_->dihedral[e.index()]; }

std::string face_name(FaceId f) { return "Face" + std::to_string(f.value + 1); }
std::string edge_name(EdgeId e) { return "Edge" + std::to_string(e.value + 1); }

}  // namespace advlayers
