#include "mesher/patch_job.h"

#include <algorithm>
#include <utility>

#include "measure/core_region.h"
#include "mend/split_inside.h"
#include "mesh/validate.h"
#include "mesher/element_faces.h"
#include "mesher/mapped_face.h"
#include "mesher/narrow_strip.h"
#include "mesher/periodic_faces.h"
#include "mesher/wall_report.h"
#include "triangulate/target_size.h"
#include "triangulate/triangulate.h"

namespace advlayers {
namespace {

// Only layers that run until fronts meet were not asked for one by one.
LayerCells layer_cells(const WallPlan& walls) {
  if (walls.stop_at_isotropy) return LayerCells::kStay;
  const bool counted = std::any_of(walls.edges.begin(), walls.edges.end(), [](const auto& entry) {
    const EdgePlan& plan = entry.second;
    return plan.condition == EdgeCondition::kWall && plan.growth.layers_left != kUntilClosed;
  });
  return counted ? LayerCells::kStay : LayerCells::kTraded;
}

// Layers that run on along an edge (walls_run_on.h) were not asked for there.
bool asks_for(const Settings& settings, EdgeId edge) {
  return settings.walls_all || settings.others == OtherEdges::kWall ||
         std::any_of(settings.walls.begin(), settings.walls.end(), [edge](const WallSpec& spec) {
           return std::find(spec.edges.begin(), spec.edges.end(), edge) != spec.edges.end();
         });
}

}  // namespace

PatchJob::PatchJob(PatchId id, std::vector<FaceId> faces, const Model& model,
                   const Settings& settings)
    : faces_(std::move(faces)),
      record_(id, faces_),
      settings_(&settings),
      evaluator_(model),
      surface_(evaluator_, faces_, feature_rule(settings)) {
  for (const FaceId face : faces_) area_ += model.face(face).area;
  for (const FaceId face : faces_) {
    const Sentence& defect = model.face(face).defect;
    if (defect.empty()) continue;
    record_.complain(Severity::kError, "face-defect",
                     Sentence("{} is not meshed: {}", face_name(face), defect));
    stage_ = Stage::kDefective;
  }
}

void PatchJob::plan(const RunContext& context) {
  context.check();
  if (stage_ == Stage::kDefective) return;
  const bool planned = record_.guard("face-not-meshed", [&] {
    walls_ = plan_walls(context, evaluator_, *settings_, faces_);
    matches_ = plan_matches(context, evaluator_, faces_, walls_);
    plan_mapped();
    if (!mapped_) strip_ = find_narrow_strip(context, evaluator_, faces_, walls_, *settings_);
  });
  if (planned) return;
  stage_ = Stage::kDefective;
  if (faces_.size() > 1) failed_ = faces_;
}

std::vector<EdgeId> PatchJob::triangulate(const RunContext& context,
                                          const Discretization& boundary) {
  if (stage_ == Stage::kDefective) return {};
  record_.begin(matches_.notes);
  failed_.clear();
  std::vector<EdgeId> coarse;
  bool in_rows = false;
  bool meshed = record_.guard("face-not-meshed", [&] {
    resolve_heights(context, evaluator_, boundary, walls_);
    if (walls_.edges.empty()) {
      record_.complain(
          Severity::kInfo, "no-boundary",
          Sentence("{} has no boundary edge that layers could grow from", patch_name(faces_)));
    }
    in_rows = fill_mapped(context, boundary) || fill_in_rows(context, boundary) ||
              fill_as_offered(context, boundary);
    if (!in_rows) make_triangles(context, boundary, coarse);
  });
  if (!meshed && failed_.empty() && faces_.size() > 1) failed_ = faces_;
  // A face without width: its neighbours meet along what it is.
  if (meshed && mesh_.vertex_capacity() == 0) {
    meshed = false;
    record_.complain(Severity::kInfo, "below-tolerance",
                     Sentence("{} is narrower than the tolerance of its edges: it holds no "
                              "element, and its neighbours meet there",
                              patch_name(faces_)));
  }
  stage_ = !meshed ? Stage::kUnmeshed : in_rows ? Stage::kInRows : Stage::kGrowing;
  return coarse;
}

// `coarse` are the edges that it finds cut too coarsely, whether it is meshed or not.
void PatchJob::make_triangles(const RunContext& context, const Discretization& boundary,
                              std::vector<EdgeId>& coarse) {
  try {
    // Layers and core need a surface to walk on; nodes that were given need a mesh to lie in.
    const auto with = [&](Density density) {
      return advlayers::triangulate(context, surface_, evaluator_, boundary, *settings_, density);
    };
    const bool given = settings_->initial_nodes != nullptr;
    Triangulation made = with(given ? Density::kAsked : Density::kCoarse);
    if (given && made.initial_nodes == 0) made = with(Density::kCoarse);
    mesh_ = std::move(made.mesh);
    coarse = std::move(made.coarse_edges);
    initial_nodes_ = made.initial_nodes;
    record_.take(made.diagnostics);
  } catch (const BoundaryTooCoarse& error) {
    coarse = error.edges();
    throw;
  } catch (const FacesNotTriangulated& error) {
    coarse = error.edges();
    failed_ = error.faces();
    throw;
  }
}

void PatchJob::plan_mapped() {
  const auto& asked = settings_->mapped_faces;
  mapped_.reset();
  offered_.reset();
  if (std::find(asked.begin(), asked.end(), faces_.front()) == asked.end()) {
    const bool plain = std::all_of(walls_.edges.begin(), walls_.edges.end(), [](const auto& entry) {
      return entry.second.condition == EdgeCondition::kOff;
    });
    if (plain && faces_.size() == 1 && settings_->core == CoreElements::kQuads &&
        settings_->initial_nodes == nullptr) {
      offered_ = find_four_sides(evaluator_, faces_.front());
    }
    return;
  }
  if (faces_.size() == 1) mapped_ = find_mapped_sides(evaluator_, faces_.front());
  if (mapped_) {
    for (const MatchEnd& end : ends_of_mapped(evaluator_, *mapped_, walls_)) {
      matches_.ends.push_back(end);
    }
    return;
  }
  Diagnostic note;
  note.severity = Severity::kWarning;
  note.code = "not-mapped";
  note.sentence =
      Sentence("{} is not mapped: its outline has no four corners, and it is no ring in a plane",
               face_name(faces_.front()));
  matches_.notes.push_back(std::move(note));
}

bool PatchJob::fill_mapped(const RunContext& context, const Discretization& boundary) {
  if (!mapped_) return false;
  std::optional<MappedMesh> made =
      mesh_mapped(context, evaluator_, surface_, boundary, *mapped_, walls_,
                  SizeField(*settings_).of_face(faces_.front()));
  if (!made) {
    record_.complain(Severity::kWarning, "not-mapped",
                     Sentence("{} is not mapped: its sides are cut into different numbers of "
                              "segments, or rows between them would fold",
                              face_name(faces_.front())));
    return false;
  }
  mesh_ = std::move(made->mesh);
  stops_ = std::move(made->stops);
  record_.tell_layers(made->layers);
  return true;
}

bool PatchJob::fill_as_offered(const RunContext& context, const Discretization& boundary) {
  if (!offered_) return false;
  std::optional<MappedMesh> made =
      mesh_mapped(context, evaluator_, surface_, boundary, *offered_, walls_,
                  SizeField(*settings_).of_face(faces_.front()));
  if (!made || !fits(context, evaluator_, surface_, made->mesh, *settings_)) return false;
  mesh_ = std::move(made->mesh);
  stops_.clear();
  return true;
}

// A strip too narrow for layers is finished at once: each of its walls' columns has met the other.
bool PatchJob::fill_in_rows(const RunContext& context, const Discretization& boundary) {
  std::optional<SurfaceMesh> rows;
  if (strip_) {
    rows = mesh_in_rows(context, evaluator_, surface_, boundary, *strip_, walls_, *settings_);
  }
  stops_.clear();
  if (!rows) return false;
  mesh_ = std::move(*rows);
  for (std::size_t i = 0; i < mesh_.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (mesh_.data(v).node.valid()) stops_.push_back({v, Stop::kCollision, 1});
  }
  return true;
}

std::optional<LayerReport> PatchJob::advance(const RunContext& context) {
  std::optional<LayerReport> report;
  if (stage_ != Stage::kGrowing) return report;
  const bool sound = record_.guard("layers-stopped", [&] {
    if (!layers_) begin_layers(context);
    report = layers_->advance();
  });
  if (!sound || !report) {
    stage_ = Stage::kGrown;
    return std::nullopt;
  }
  record_.add_layer(*report);
  return report;
}

void PatchJob::begin_layers(const RunContext& context) {
  layers_ = std::make_unique<PatchLayers>(context, id(), mesh_, surface_, walls_);
  if (!walls_.stop_at_isotropy) return;
  const auto size = std::make_shared<TargetSize>(evaluator_, *settings_);
  layers_->set_local_size([size](const SurfacePoint& p) { return size->at(p); });
}

// The layers watch the mesh for edges to swap; what follows is no business of theirs.
void PatchJob::end_layers() {
  if (stage_ == Stage::kGrowing) stage_ = Stage::kGrown;
  if (!layers_) return;
  record_.take(layers_->diagnostics());
  stops_ = layers_->stops();
  layers_.reset();
  thaw_core_edges(mesh_);
}

void PatchJob::finish(const RunContext& context, const Discretization& boundary) {
  if (stage_ == Stage::kFinished) return;
  end_layers();
  if (stage_ == Stage::kInRows) stage_ = Stage::kFinished;
  if (stage_ != Stage::kGrown) return;
  const std::string broken = find_connectivity_fault(context, mesh_);
  if (!broken.empty() && !mend_without_layers(context, broken, boundary)) return;
  const bool done = record_.guard("core-not-improved", [&] {
    mesh_.put_in_order(context);
    tell_of(complete(context, boundary));
    if (faces_.size() > 1) find_faces(context, boundary);
    const std::string fault = find_connectivity_fault(context, mesh_);
    if (!fault.empty()) throw InternalError(fault);
  });
  if (!done) face_of_.clear();
  // Each operation leaves a valid mesh; what failed half-way is made anew without this stage.
  if (done || find_connectivity_fault(context, mesh_).empty() || grow_again(context, boundary)) {
    stage_ = Stage::kFinished;
  }
}

// Every element comes to lie on one face. Where that would cost an element turned over, elements
// reach over the edges inside the patch instead.
Completion PatchJob::complete(const RunContext& context, const Discretization& boundary) {
  const LayerCells cells = layer_cells(walls_);
  const auto across_edges = [&] {
    return_to_core(mesh_);
    return complete_core(context, mesh_, surface_, evaluator_, *settings_, cells);
  };
  if (!surface_.has_inner_edges() || surface_.faceted()) return across_edges();
  return_to_core(mesh_);
  const Completion along =
      complete_core_along_edges(context, mesh_, surface_, evaluator_, boundary, *settings_, cells);
  const int inverted = count_inverted(context, mesh_, surface_);
  if (inverted == 0) return along;
  SurfaceMesh made = std::move(mesh_);
  if (grow_again(context, boundary)) {
    Completion across = across_edges();
    across.crossing = kAllMayCross;
    if (count_inverted(context, mesh_, surface_) < inverted) return across;
  }
  mesh_ = std::move(made);
  stage_ = Stage::kGrown;
  return along;
}

// The mesh as the layers left it. A copy kept for the worst case would take half of the memory.
bool PatchJob::grow_again(const RunContext& context, const Discretization& boundary) {
  const PatchRecord told = record_;
  const std::vector<StopRecord> stops = stops_;
  triangulate(context, boundary);
  while (record_.layers() < told.layers() && advance(context)) {
  }
  end_layers();
  record_ = told;
  stops_ = stops;
  mesh_.put_in_order(context);
  return stage_ == Stage::kGrown;
}

// Layers that broke the mesh are given up: several faces are tried one by one, a single one is
// meshed without them.
bool PatchJob::mend_without_layers(const RunContext& context, const std::string& fault,
                                   const Discretization& boundary) {
  if (faces_.size() > 1) {
    failed_ = faces_;
    stage_ = Stage::kUnmeshed;
  } else {
    triangulate(context, boundary);
    if (stage_ == Stage::kGrowing) stage_ = Stage::kGrown;
    stops_.clear();
    record_.forget_layers();
  }
  const Sentence left("{}: its layers broke the mesh, and it is meshed without them: {}",
                      patch_name(faces_), fault);
  const Sentence lost("{}: its layers broke the mesh: {}", patch_name(faces_), fault);
  record_.complain(Severity::kError, meshed() ? "layers-broken" : "face-not-meshed",
                   meshed() ? left : lost);
  return stage_ == Stage::kGrown;
}

void PatchJob::tell_of(const Completion& made) {
  if (made.of_layers_mended > 0) {
    record_.complain(
        Severity::kWarning, "layers-mended",
        Sentence("{}: {} elements of layers were changed, as elements there were turned over",
                 patch_name(faces_), made.of_layers_mended));
  }
  const int crossing = made.crossing;
  if (crossing == 0) return;
  const Sentence some(
      "{}: {} elements reach over edges inside the patch; lower feature_angle to part its faces",
      patch_name(faces_), crossing);
  const Sentence all(
      "{}: its elements reach over edges inside the patch; lower feature_angle to part its faces",
      patch_name(faces_));
  record_.complain(Severity::kWarning, "elements-cross-edges",
                   crossing != kAllMayCross ? some : all);
}

void PatchJob::find_faces(const RunContext& context, const Discretization& boundary) {
  ElementFaces found =
      find_element_faces(context, mesh_, surface_, boundary, SizeField(*settings_));
  face_of_ = std::move(found.of);
  if (!surface_.faceted()) strained_ = std::move(found.strained);
}

void PatchJob::copy_moved(const PatchJob& given, const FacePair& pair,
                          const Discretization& boundary) {
  record_.guard("not-periodic", [&] {
    std::optional<MovedMesh> moved;
    if (faces_.size() == 1 && given.faces_.size() == 1 && given.finished() && finished()) {
      moved = move_mesh(evaluator_, given.mesh_, pair, boundary);
    }
    if (!moved) {
      record_.complain(Severity::kWarning, "not-periodic",
                       Sentence("{} is not meshed as {} is: they do not lie alike, or are parts of "
                                "larger patches",
                                face_name(pair.found), face_name(pair.given)));
      return;
    }
    mesh_ = std::move(moved->mesh);
    stops_.clear();
    for (StopRecord stop : given.stops_) {
      stop.root = moved->of[stop.root.index()];
      stops_.push_back(stop);
    }
    record_.tell_layers(given.record_.layers());
  });
}

void PatchJob::split_edges(const RunContext& context, const std::vector<HalfedgeH>& edges,
                           const Discretization& boundary) {
  record_.guard("edges-not-split", [&] {
    for (const HalfedgeH h : edges) split_inside(mesh_, surface_, h);
    if (faces_.size() > 1) find_faces(context, boundary);
  });
}

void PatchJob::measure(const RunContext& context) {
  if (!meshed()) return;
  record_.guard("not-measured", [&] {
    std::vector<WallReport> walls =
        measure_walls(context, mesh_, surface_, walls_, stops_, record_.layers());
    walls.erase(
        std::remove_if(walls.begin(), walls.end(),
                       [this](const WallReport& wall) { return !asks_for(*settings_, wall.edge); }),
        walls.end());
    for (WallReport& wall : walls) wall.face = face_beside(evaluator_.model(), faces_, wall.edge);
    const auto face_of_element = [this](FaceH f) { return face_of(f); };
    record_.measure(context, {mesh_, surface_, face_of_element}, std::move(walls));
  });
}

// An element that lies on no face as a whole belongs to the one that most of its corners lie on.
FaceId PatchJob::face_of(FaceH f) const {
  if (faces_.size() == 1) return faces_.front();
  if (f.index() < face_of_.size() && face_of_[f.index()].valid()) return face_of_[f.index()];
  FaceId best;
  int best_votes = 0;
  for (const HalfedgeH h : mesh_.sides(f)) {
    const FaceId candidate = mesh_.data(mesh_.to(h)).point.face;
    int votes = 0;
    for (const HalfedgeH other : mesh_.sides(f)) {
      votes += mesh_.data(mesh_.to(other)).point.face == candidate;
    }
    if (votes > best_votes || (votes == best_votes && candidate < best)) {
      best = candidate;
      best_votes = votes;
    }
  }
  return best;
}

std::vector<Diagnostic> PatchJob::diagnostics() const {
  std::vector<Diagnostic> all = record_.diagnostics();
  if (layers_) all.insert(all.end(), layers_->diagnostics().begin(), layers_->diagnostics().end());
  return all;
}

}  // namespace advlayers
