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

bool Model::closed() const {
  std::vector<int> sides(edges_.size(), 0);
  for (const Face& face : faces_) {
    for (const auto& loop : face.loops) {
      for (const CoEdge& coedge : loop) ++sides[coedge.edge.index()];
    }
  }
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (!edges_[i].degenerate && sides[i] != 2) return false;
  }
  return !faces_.empty();
}

double Model::dihedral_angle(EdgeId e) const { return shape_->dihedral[e.index()]; }

std::string face_name(FaceId f) { return "Face" + std::to_string(f.value + 1); }
std::string edge_name(EdgeId e) { return "Edge" + std::to_string(e.value + 1); }

}  // namespace advlayers
