#include "mesher/sewn_edges.h"

#include <algorithm>
#include <utility>

#include "geometry/model.h"

namespace advlayers {
namespace {

// Each edge of the model once. Names that the model does not have stay: check() refuses them.
void replace(const Model& model, std::vector<EdgeId>& edges) {
  std::vector<EdgeId> replaced;
  for (const EdgeId given : edges) {
    const bool known = given.valid() && given.index() < model.edges().size();
    for (const EdgeId piece : known ? model.pieces(given) : std::vector<EdgeId>{given}) {
      const bool fresh = std::find(replaced.begin(), replaced.end(), piece) == replaced.end();
      if (fresh) replaced.push_back(piece);
    }
  }
  edges = std::move(replaced);
}

// The same text, with every "Edge7" replaced by what `name` makes of it.
template <class Name>
std::string renamed(const std::string& text, const Name& name) {
  const std::string kind = "Edge";
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = text.find(kind); at != std::string::npos; at = text.find(kind, done)) {
    const std::size_t digits = at + kind.size();
    const std::size_t end = std::min(text.find_first_not_of("0123456789", digits), text.size());
    result += text.substr(done, at - done);
    // A number too long for an edge is no edge's.
    const bool number = end > digits && end - digits < 10;
    result += number ? edge_name(name(EdgeId(std::stoi(text.substr(digits, end - digits)) - 1)))
                     : text.substr(at, end - at);
    done = end;
  }
  return result + text.substr(done);
}

}  // namespace

Settings in_edges_of(const Model& model, Settings settings) {
  if (!model.sewn()) return settings;
  for (WallSpec& wall : settings.walls) replace(model, wall.edges);
  for (SizeSpec& size : settings.sizes) replace(model, size.edges);
  for (PeriodicSpec& spec : settings.periodic) replace(model, spec.given_edges);
  for (std::vector<EdgeId>* edges : {&settings.match_edges, &settings.off_edges,
                                     &settings.boundary_edges, &settings.smooth_edges}) {
    replace(model, *edges);
  }
  return settings;
}

void name_given_edges(const Model& model, MeshResult& result) {
  if (!model.sewn()) return;
  const auto of_model = std::exchange(result.edge_segments, {});
  result.edge_segments.resize(model.given_edges());
  std::vector<EdgeId> name(of_model.size());
  for (std::size_t e = 0; e < model.given_edges(); ++e) {
    auto& segments = result.edge_segments[e];
    for (const EdgeId piece : model.pieces(EdgeId(e))) {
      const auto& own = of_model[piece.index()];
      segments.insert(segments.end(), own.begin(), own.end());
      if (!name[piece.index()].valid()) name[piece.index()] = EdgeId(e);
    }
  }
  const auto given_name = [&](EdgeId edge) {
    const bool piece = edge.index() >= model.given_edges() && edge.index() < name.size();
    return piece && name[edge.index()].valid() ? name[edge.index()] : edge;
  };
  for (WallReport& wall : result.walls) wall.edge = given_name(wall.edge);
  for (Diagnostic& said : result.diagnostics) {
    said.sentence.change([&](const std::string& value) { return renamed(value, given_name); });
  }
}

}  // namespace advlayers
