#include "mesher/triangle_cause.h"

#include <vector>

#include "measure/core_region.h"

namespace advlayers {
namespace {

constexpr int kLastLoop = 6;  // elements

class Classifier {
 public:
  explicit Classifier(const SurfaceMesh& mesh) : mesh_(mesh), rest_of_(mesh.face_capacity(), -1) {}

  const char* cause(FaceH triangle) {
    if (!is_core(mesh_, triangle)) return "collapse";
    bool step = false, closing = false;
    for (const HalfedgeH h : mesh_.sides(triangle)) {
      if (is_free(mesh_, mesh_.to(h))) return "core";
      step = step || is_extrusion(mesh_, h);
      closing = closing || is_grown_from(h);
    }
    if (step) return "step";
    if (closing) return "closing";
    return size_of_rest(triangle) <= kLastLoop ? "last loop" : "collision";
  }

 private:
  // A layer went on from this edge, on its other side.
  bool is_grown_from(HalfedgeH h) const {
    const FaceH beside = mesh_.face(SurfaceMesh::twin(h));
    if (!beside.valid() || is_core(mesh_, beside)) return false;
    const int layer = mesh_.data(beside).layer;
    return mesh_.data(mesh_.from(h)).layer < layer && mesh_.data(mesh_.to(h)).layer < layer;
  }

  // Core elements joined to this one by edges.
  int size_of_rest(FaceH start) {
    if (rest_of_[start.index()] < 0) flood(start);
    return sizes_[static_cast<std::size_t>(rest_of_[start.index()])];
  }

  void flood(FaceH start) {
    const int rest = static_cast<int>(sizes_.size());
    std::vector<FaceH> queue{start};
    rest_of_[start.index()] = rest;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const HalfedgeH h : mesh_.sides(queue[i])) {
        const FaceH beside = mesh_.face(SurfaceMesh::twin(h));
        if (beside.valid() && is_core(mesh_, beside) && rest_of_[beside.index()] < 0) {
          rest_of_[beside.index()] = rest;
          queue.push_back(beside);
        }
      }
    }
    sizes_.push_back(static_cast<int>(queue.size()));
  }

  const SurfaceMesh& mesh_;
  std::vector<int> rest_of_;  // by face: index into sizes_; -1: not seen
  std::vector<int> sizes_;
};

}  // namespace

std::map<std::string, int> triangle_causes(const RunContext& context, const SurfaceMesh& mesh) {
  std::map<std::string, int> causes;
  Classifier classifier(mesh);
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    context.check();
    const FaceH f(i);
    if (mesh.alive(f) && mesh.is_triangle(mesh.halfedge(f))) ++causes[classifier.cause(f)];
  }
  return causes;
}

}  // namespace advlayers
