#include "mesher/small_parts.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include "sizing/size_field.h"

namespace advlayers {
namespace {

constexpr double kSmall = 0.1;     // of the size
constexpr std::size_t kNamed = 5;  // the others are counted

struct SmallPart {
  double extent;  // [mm]
  std::string name;
  bool operator<(const SmallPart& o) const { return extent < o.extent; }
};

// `all` names every part, `some` tells how many more there are.
void note(std::vector<SmallPart> parts, const char* code, const Sentence& all, const Sentence& some,
          std::vector<Diagnostic>& diagnostics) {
  if (parts.empty()) return;
  std::stable_sort(parts.begin(), parts.end());
  std::ostringstream text;
  for (std::size_t i = 0; i < std::min(parts.size(), kNamed); ++i) {
    text << (i > 0 ? ", " : "") << parts[i].name << " (" << parts[i].extent << " mm)";
  }
  Diagnostic diagnostic;
  diagnostic.severity = Severity::kInfo;
  diagnostic.code = code;
  diagnostic.sentence =
      parts.size() > kNamed ? some.about(text.str(), parts.size() - kNamed) : all.about(text.str());
  diagnostics.push_back(std::move(diagnostic));
}

// Edges that bound no face any more, as each is one point.
std::vector<SmallPart> below_tolerance(const Model& model) {
  std::vector<SmallPart> parts;
  for (std::size_t e = 0; e < model.edges().size(); ++e) {
    const Edge& edge = model.edges()[e];
    if (edge.degenerate && edge.length > 0.0 && edge.faces.empty()) {
      parts.push_back({edge.length, edge_name(EdgeId(e))});
    }
  }
  return parts;
}

}  // namespace

double width_of(const Model& model, FaceId face) {
  double around = 0.0;
  for (const auto& loop : model.face(face).loops) {
    for (const CoEdge& coedge : loop) around += model.edge(coedge.edge).length;
  }
  return around > 0.0 ? 2.0 * model.face(face).area / around : 0.0;
}

void note_small_parts(const Model& model, const Settings& settings,
                      const std::vector<FaceId>& faces, std::vector<Diagnostic>& diagnostics) {
  if (model.triangular()) return;
  const SizeField sizes(settings);
  std::vector<SmallPart> narrow, brief;
  std::set<EdgeId> edges;
  for (const FaceId face : faces) {
    for (const auto& loop : model.face(face).loops) {
      for (const CoEdge& coedge : loop) edges.insert(coedge.edge);
    }
    const double width = width_of(model, face);
    if (width > 0.0 && width < kSmall * sizes.of_face(face)) {
      narrow.push_back({width, face_name(face)});
    }
  }
  for (const EdgeId id : edges) {
    const Edge& edge = model.edge(id);
    if (edge.degenerate || edge.length >= kSmall * sizes.of_edge(id, edge.faces)) continue;
    brief.push_back({edge.length, edge_name(id)});
  }
  note(std::move(brief), "tiny-edges",
       Sentence("shorter than a tenth of the size, and the mesh edges with them: {}"),
       Sentence("shorter than a tenth of the size, and the mesh edges with them: {} and {} more"),
       diagnostics);
  note(below_tolerance(model), "below-tolerance",
       Sentence("shorter than the tolerance about them, and one point in the mesh: {}"),
       Sentence("shorter than the tolerance about them, and one point in the mesh: {} and {} more"),
       diagnostics);
  note(std::move(narrow), "sliver-faces",
       Sentence("narrower than a tenth of the size, and their elements with them: {}"),
       Sentence("narrower than a tenth of the size, and their elements with them: {} and {} more"),
       diagnostics);
}

}  // namespace advlayers
