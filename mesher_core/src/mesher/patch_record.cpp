#include "mesher/patch_record.h"

#include <map>
#include <utility>

#include "measure/element_measures.h"
#include "measure/mesh_flaws.h"
#include "mend/inversion.h"
#include "mesher/triangle_cause.h"
#include "mesher/wall_shortfalls.h"

namespace advlayers {
namespace {

// Nodes nearer to each other than this part of the model are one for whatever reads the mesh.
constexpr double kSamePlace = 1e-10;

template <class Id, std::size_t kCount>
void add_named(const std::array<int, kCount>& counts, const std::array<Named<Id>, kCount>& names,
               std::map<std::string, int>& total) {
  for (const auto& [id, name] : names) {
    const int count = counts[static_cast<std::size_t>(id)];
    if (count > 0) total[name] += count;
  }
}

}  // namespace

PatchRecord::PatchRecord(PatchId id, std::vector<FaceId> faces) : faces_(std::move(faces)) {
  report_.patch = id;
  report_.faces = faces_;
}

void PatchRecord::renumber(PatchId id) {
  report_.patch = id;
  for (Diagnostic& note : diagnostics_) note.patch = id;
}

void PatchRecord::complain(Severity severity, std::string_view code, Sentence sentence) {
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.code = code;
  diagnostic.patch = report_.patch;
  diagnostic.layer = report_.layers;
  diagnostic.sentence = std::move(sentence);
  diagnostics_.push_back(std::move(diagnostic));
}

void PatchRecord::begin(const std::vector<Diagnostic>& notes) {
  diagnostics_.clear();
  take(notes);
}

void PatchRecord::take(const std::vector<Diagnostic>& told) {
  for (Diagnostic note : told) {
    note.patch = report_.patch;
    diagnostics_.push_back(std::move(note));
  }
}

void PatchRecord::add_layer(const LayerReport& layer) {
  report_.layers = layer.layer;
  add_named(layer.vetoes, kVetoes, report_.vetoes);
  add_named(layer.events, kEvents, report_.events);
}

void PatchRecord::measure(const RunContext& context, const MeshOfPatch& of,
                          std::vector<WallReport> walls) {
  count_elements(context, of);
  judge_inverted(of);
  judge_flaws(context, of);
  judge_walls(std::move(walls));
}

void PatchRecord::count_elements(const RunContext& context, const MeshOfPatch& of) {
  counts_ = FigureCounts();
  inverted_.clear();
  report_.quads = report_.triangles = 0;
  report_.triangles_by_cause = triangle_causes(context, of.mesh);
  for (std::size_t i = 0; i < of.mesh.face_capacity(); ++i) {
    context.check();
    const FaceH f(i);
    if (!of.mesh.alive(f)) continue;
    const ElementCorners element = corners_of(of.mesh, f);
    counts_.add(element, of.mesh.data(f).layer);
    if (is_inverted(of.mesh, f, of.surface)) {
      counts_.add_inverted();
      inverted_.push_back(f);
    }
    ++(element.count == 4 ? report_.quads : report_.triangles);
  }
}

// A wall that got fewer layers than its number, none that could be measured, or layers of another
// height, says so.
void PatchRecord::judge_walls(std::vector<WallReport> measured) {
  wall_reports_ = std::move(measured);
  std::vector<const WallReport*> missed;
  for (const WallReport& wall : wall_reports_) {
    for (Shortfall& shortfall : shortfalls_of(wall)) {
      if (shortfall.code == kHeightMissed) {
        missed.push_back(&wall);
      } else {
        complain(Severity::kWarning, shortfall.code, std::move(shortfall.sentence));
      }
    }
  }
  if (!missed.empty()) {
    complain(Severity::kWarning, kHeightMissed, missed_heights(std::move(missed)));
  }
}

// What was turned over in the triangulation may be mended by now: the finished mesh decides.
void PatchRecord::judge_inverted(const MeshOfPatch& of) {
  for (Diagnostic& diagnostic : diagnostics_) {
    if (diagnostic.code == "triangulation-inverted") diagnostic.severity = Severity::kInfo;
  }
  std::map<FaceId, std::vector<FaceH>> by_face;
  for (const FaceH f : inverted_) by_face[of.face_of(f)].push_back(f);
  for (const auto& [face, elements] : by_face) {
    complain(Severity::kError, "inverted-elements",
             Sentence("{}: {} elements are turned over against the surface", face_name(face),
                      elements.size()));
    diagnostics_.back().point = centroid(corners_of(of.mesh, elements.front()));
  }
}

// What a solver could not use.
void PatchRecord::judge_flaws(const RunContext& context, const MeshOfPatch& of) {
  const MeshFlaws flaws =
      find_mesh_flaws(context, of.mesh, kSamePlace * of.surface.model().diagonal());
  const auto tell = [&](const char* code, Severity severity, const std::vector<FaceH>& elements,
                        const Sentence& said) {
    if (elements.empty()) return;
    complain(severity, code, said.about(face_name(of.face_of(elements.front())), elements.size()));
    diagnostics_.back().point = centroid(corners_of(of.mesh, elements.front()));
  };
  tell("zero-areas", Severity::kError, flaws.flat, Sentence("{}: {} elements have no area"));
  tell("needles", Severity::kWarning, flaws.needles,
       Sentence("{}: {} elements have an angle below 0.1 degrees"));
  if (flaws.coincident.empty()) return;
  const VertexH first = flaws.coincident.front();
  complain(Severity::kError, "coincident-nodes",
           Sentence("{}: {} nodes lie in the place of another one",
                    face_name(of.mesh.data(first).point.face), flaws.coincident.size()));
  diagnostics_.back().point = of.mesh.position(first);
}

}  // namespace advlayers
