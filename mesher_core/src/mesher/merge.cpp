#include "mesher/merge.h"

#include <algorithm>

#include "base/error.h"

namespace advlayers {
namespace {

constexpr int kUnused = -1;

class Merger {
 public:
  Merger(const RunContext& context, const PatchJobs& jobs, const Discretization& boundary)
      : jobs_(jobs), boundary_(boundary), context_(context) {}
  MeshResult run();

 private:
  void number_boundary_nodes();
  void add_nodes(const SurfaceMesh& mesh, std::vector<int>& number);
  void add_parents(const SurfaceMesh& mesh, const std::vector<int>& number);
  void add_elements(const PatchJob& job, const std::vector<int>& number);
  void add_edge_segments();
  void add_inner_segments(const SurfaceMesh& mesh, const std::vector<int>& number);

  const PatchJobs& jobs_;
  const Discretization& boundary_;
  const RunContext& context_;
  std::vector<int> boundary_number_;  // by NodeId
  std::vector<char> edge_used_;       // by EdgeId: a meshed patch has it on its border
  MeshResult result_;
};

void Merger::number_boundary_nodes() {
  boundary_number_.assign(boundary_.nodes.size(), kUnused);
  edge_used_.assign(boundary_.edges.size(), 0);
  for (const auto& job : jobs_) {
    if (!job->meshed()) continue;
    const SurfaceMesh& mesh = job->mesh();
    for (std::size_t i = 0; i < mesh.vertex_capacity(); ++i) {
      context_.check();
      const VertexH v(i);
      if (!mesh.alive(v) || !mesh.data(v).node.valid()) continue;
      boundary_number_[mesh.data(v).node.index()] = 0;
      const HalfedgeH border = mesh.outgoing(v);
      if (!mesh.is_border(border)) continue;
      const EdgeId edge = mesh.curve(border);
      if (edge.valid()) edge_used_[edge.index()] = 1;
    }
  }
  for (std::size_t i = 0; i < boundary_number_.size(); ++i) {
    if (boundary_number_[i] == kUnused) continue;
    boundary_number_[i] = static_cast<int>(result_.nodes.size());
    result_.nodes.push_back(boundary_.nodes[i].xyz);
    result_.node_layer.push_back(0);
    result_.node_parent.push_back(kUnused);
  }
}

void Merger::add_nodes(const SurfaceMesh& mesh, std::vector<int>& number) {
  number.assign(mesh.vertex_capacity(), kUnused);
  for (std::size_t i = 0; i < number.size(); ++i) {
    context_.check();
    const VertexH v(i);
    if (!mesh.alive(v)) continue;
    const VertexData& data = mesh.data(v);
    if (data.node.valid()) {
      number[i] = boundary_number_[data.node.index()];
      continue;
    }
    number[i] = static_cast<int>(result_.nodes.size());
    result_.nodes.push_back(data.point.xyz);
    result_.node_layer.push_back(data.layer);
    result_.node_parent.push_back(kUnused);
  }
}

void Merger::add_parents(const SurfaceMesh& mesh, const std::vector<int>& number) {
  for (std::size_t i = 0; i < number.size(); ++i) {
    context_.check();
    const VertexH v(i);
    if (!mesh.alive(v) || mesh.data(v).node.valid()) continue;
    const VertexH parent = mesh.data(v).parent;
    if (parent.valid() && mesh.alive(parent)) {
      result_.node_parent[static_cast<std::size_t>(number[i])] = number[parent.index()];
    }
  }
}

void Merger::add_elements(const PatchJob& job, const std::vector<int>& number) {
  const SurfaceMesh& mesh = job.mesh();
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    context_.check();
    const FaceH f(i);
    if (!mesh.alive(f)) continue;
    std::array<int, 4> corner{};
    std::size_t count = 0;
    for (const HalfedgeH h : mesh.sides(f)) {
      corner[count++] = number[mesh.from(h).index()];
    }
    if (count == 4) {
      result_.quads.push_back(corner);
      result_.quad_face.push_back(job.face_of(f));
      result_.quad_layer.push_back(mesh.data(f).layer);
    } else {
      result_.triangles.push_back({corner[0], corner[1], corner[2]});
      result_.triangle_face.push_back(job.face_of(f));
      result_.triangle_layer.push_back(mesh.data(f).layer);
    }
  }
}

void Merger::add_edge_segments() {
  for (std::size_t e = 0; e < boundary_.edges.size(); ++e) {
    if (!edge_used_[e]) continue;
    const auto& nodes = boundary_.edges[e].nodes;
    for (std::size_t k = 1; k < nodes.size(); ++k) {
      const int from = boundary_number_[nodes[k - 1].index()];
      const int to = boundary_number_[nodes[k].index()];
      // Where the edge is one line with another of its face, no element may be beside it.
      if (from != kUnused && to != kUnused) result_.edge_segments[e].push_back({from, to});
    }
  }
}

// Mesh edges on the model's edges inside a patch, in no order.
void Merger::add_inner_segments(const SurfaceMesh& mesh, const std::vector<int>& number) {
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); i += 2) {
    context_.check();
    const HalfedgeH h(i);
    if (!mesh.alive(h) || !mesh.curve(h).valid() || mesh.is_border(h) ||
        mesh.is_border(SurfaceMesh::twin(h))) {
      continue;
    }
    result_.edge_segments[mesh.curve(h).index()].push_back(
        {number[mesh.from(h).index()], number[mesh.to(h).index()]});
  }
}

MeshResult Merger::run() {
  number_boundary_nodes();
  result_.edge_segments.resize(boundary_.edges.size());
  std::vector<int> number;
  for (const auto& job : jobs_) {
    if (job->meshed()) {
      add_nodes(job->mesh(), number);
      add_parents(job->mesh(), number);
      add_elements(*job, number);
      add_inner_segments(job->mesh(), number);
    }
    result_.patches.push_back(job->report());
    for (Diagnostic& diagnostic : job->diagnostics()) {
      result_.diagnostics.push_back(std::move(diagnostic));
    }
  }
  add_edge_segments();
  return std::move(result_);
}

}  // namespace

MeshResult merge(const RunContext& context, const PatchJobs& jobs, const Discretization& boundary) {
  return Merger(context, jobs, boundary).run();
}

}  // namespace advlayers
