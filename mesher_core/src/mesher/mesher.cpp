#include "mesher/mesher.h"

#include <algorithm>
#include <deque>
#include <mutex>
#include <set>

#include "base/error.h"
#include "base/free_memory.h"
#include "boundary/discretization.h"
#include "mesher/doubled_edges.h"
#include "mesher/halving_rounds.h"
#include "mesher/job_list.h"
#include "mesher/merge.h"
#include "mesher/mid_nodes.h"
#include "mesher/parting.h"
#include "mesher/periodic_faces.h"
#include "mesher/run_notes.h"
#include "mesher/sewn_edges.h"
#include "mesher/small_parts.h"
#include "sizing/initial_nodes.h"
#include "sizing/local_sizes.h"

namespace advlayers {
namespace {

// Times that patches may be parted where their meshes could not follow their faces.
constexpr int kMostPartings = 3;

}  // namespace

struct Mesher::Impl {
  Impl(RunContext& the_context, const Model& the_model, const Settings& the_settings);
  void part_own_faces();
  void place_initial_mesh();
  void copy_periodic_faces();
  void cut_boundary();
  void start();
  void advance_all();
  void grow_all();
  void finish_jobs();
  std::map<std::string, double> seconds() const;
  bool part_further();
  MeshResult finish();

  RunContext& context;
  const Model& model;
  Settings settings;
  JobList list;
  Parting parting;
  Discretization boundary;
  Discretization first_cut;  // the boundary before any edge was halved
  std::deque<LayerReport> pending;
  PeriodicPairs periodic;
  bool started = false;
  bool growing = true;
  int widest_front = 0;  // vertices, of all patches
  bool finished = false;
  mutable std::mutex mutex;  // guards all but the context
};

Mesher::Impl::Impl(RunContext& the_context, const Model& the_model, const Settings& the_settings)
    : context(the_context),
      model(the_model),
      settings(in_edges_of(the_model, the_settings)),
      list(context, model, settings),
      parting(context, model, settings, list) {
  const StageScope stage(context, RunStage::kBoundary);
  check(settings, model);
  settings = with_local_sizes(model, std::move(settings));
  periodic = find_periodic(context, model, settings);
  part_own_faces();
  place_initial_mesh();
  list.make();
  parting.part_tight();
}

// Mapped and periodic faces are patches of their own; no layers grow from the edges that part them
// from their smooth neighbours.
void Mesher::Impl::part_own_faces() {
  std::set<FaceId> own(settings.mapped_faces.begin(), settings.mapped_faces.end());
  for (const FacePair& pair : periodic.faces) own.insert({pair.given, pair.found});
  if (own.empty()) return;
  std::vector<FaceId> faces = settings.faces;
  for (std::size_t i = 0; settings.faces.empty() && i < model.faces().size(); ++i) {
    faces.emplace_back(i);
  }
  Evaluator evaluator(model);
  for (const EdgeId edge : inner_edges(evaluator, faces, feature_rule(settings))) {
    const std::vector<FaceId>& beside = model.edge(edge).faces;
    if (beside.size() != 2 || own.count(beside[0]) + own.count(beside[1]) == 0) continue;
    settings.boundary_edges.push_back(edge);
    settings.match_edges.push_back(edge);
  }
}

void Mesher::Impl::place_initial_mesh() {
  if (settings.initial_mesh == nullptr) return;
  std::vector<FaceId> faces = settings.faces;
  for (std::size_t i = 0; settings.faces.empty() && i < model.faces().size(); ++i) {
    faces.emplace_back(i);
  }
  settings.initial_nodes =
      std::make_shared<InitialNodes>(context, model, *settings.initial_mesh, faces);
}

void Mesher::Impl::cut_boundary() {
  list.for_each([this](PatchJob& job, std::size_t) {
    if (!job.meshed()) job.plan(context);
  });
  std::vector<MatchEnd> match_ends;
  std::vector<FourSides> strips, mapped;
  for (const auto& job : list.jobs()) {
    match_ends.insert(match_ends.end(), job->match_ends().begin(), job->match_ends().end());
    if (job->strip()) strips.push_back(*job->strip());
    if (job->mapped()) mapped.push_back(*job->mapped());
  }
  Evaluator evaluator(model);
  Discretization cut =
      discretize(context, evaluator, settings, match_ends, strips, mapped, periodic.edges);
  // Meshed patches fit the boundary as it stands, with the edges that were halved since.
  if (same_cuts(cut, first_cut)) return;
  list.for_each([this](PatchJob& job, std::size_t index) {
    if (job.meshed()) list.renew(index);
  });
  boundary = first_cut = std::move(cut);
}

void Mesher::Impl::start() {
  if (started) return;
  {
    const StageScope stage(context, RunStage::kBoundary);
    cut_boundary();
  }
  const StageScope stage(context, RunStage::kTriangulate);
  triangulate_in_rounds(context, model, list, periodic.edges, boundary);
  while (parting.part_failed()) {
    cut_boundary();
    triangulate_in_rounds(context, model, list, periodic.edges, boundary);
  }
  release_free_memory();
  started = true;
}

// One layer on every patch that still grows.
void Mesher::Impl::advance_all() {
  const StageScope stage(context, RunStage::kLayers);
  std::vector<std::optional<LayerReport>> reports(list.size());
  list.for_each([&](PatchJob& job, std::size_t index) { reports[index] = job.advance(context); });
  int front = 0;
  for (const auto& report : reports) {
    if (!report) continue;
    pending.push_back(*report);
    front += report->front_vertices;
  }
  widest_front = std::max(widest_front, front);
  if (widest_front > 0) context.tell_share(1.0 - static_cast<double>(front) / widest_front);
  growing =
      std::any_of(reports.begin(), reports.end(), [](const auto& r) { return r.has_value(); });
}

void Mesher::Impl::grow_all() {
  start();
  while (growing) advance_all();
  pending.clear();
}

std::map<std::string, double> Mesher::Impl::seconds() const {
  std::map<std::string, double> by_name;
  for (const RunStage stage :
       {RunStage::kBoundary, RunStage::kTriangulate, RunStage::kLayers, RunStage::kCore}) {
    by_name[stage_name(stage)] = context.seconds(stage);
  }
  return by_name;
}

void Mesher::Impl::finish_jobs() {
  const StageScope stage(context, RunStage::kCore);
  release_free_memory();
  JobShare done(context, list);
  list.for_each([&](PatchJob& job, std::size_t) {
    job.finish(context, boundary);
    done.add(job);
  });
  release_free_memory();
}

void Mesher::Impl::copy_periodic_faces() {
  const auto job_of = [this](FaceId face) -> PatchJob* {
    for (const auto& job : list.jobs()) {
      const std::vector<FaceId>& faces = job->faces();
      if (std::find(faces.begin(), faces.end(), face) != faces.end()) return job.get();
    }
    return nullptr;
  };
  for (const FacePair& pair : periodic.faces) {
    PatchJob *given = job_of(pair.given), *found = job_of(pair.found);
    if (given != nullptr && found != nullptr) found->copy_moved(*given, pair, boundary);
  }
}

// What is not yet meshed then waits for another start.
bool Mesher::Impl::part_further() {
  const bool failed = parting.part_failed();
  if (!parting.part_strained() && !failed) return false;
  started = false;
  growing = true;
  widest_front = 0;
  return true;
}

MeshResult Mesher::Impl::finish() {
  const bool whole = !growing && pending.empty();
  finish_jobs();
  for (int k = 0; whole && k < kMostPartings && part_further(); ++k) {
    grow_all();
    finish_jobs();
  }
  const StageScope stage(context, RunStage::kCore);
  part_doubled_edges(context, list.jobs(), boundary);
  copy_periodic_faces();
  list.for_each([this](PatchJob& job, std::size_t) { job.measure(context); });
  MeshResult result = merge(context, list.jobs(), boundary);
  if (settings.order == 2) {
    add_mid_nodes(context, list.jobs(), boundary, settings, list.threads(), model, result);
  }
  FigureCounts counts;
  for (const auto& job : list.jobs()) {
    counts.add(job->counts());
    const auto& walls = job->wall_reports();
    result.walls.insert(result.walls.end(), walls.begin(), walls.end());
  }
  std::vector<FaceId> faces;
  for (const auto& job : list.jobs())
    faces.insert(faces.end(), job->faces().begin(), job->faces().end());
  std::sort(faces.begin(), faces.end());
  note_small_parts(model, settings, faces, result.diagnostics);
  note_sewing(model, result.diagnostics);
  note_initial_mesh(settings, list.jobs(), result.diagnostics);
  note_idle_walls(settings, list.jobs(), result.diagnostics);
  const std::vector<Diagnostic>& of_cutting = boundary.notes;
  for (const auto* notes : {&parting.notes(), &of_cutting}) {
    result.diagnostics.insert(result.diagnostics.end(), notes->begin(), notes->end());
  }
  result.periodic_nodes = periodic_nodes(context, model, settings, result);
  name_given_edges(model, result);
  if (settings.order == 2) find_segment_mids(result);
  result.figures = counts.figures(static_cast<int>(result.nodes.size()));
  return result;
}

Mesher::Mesher(RunContext& context, const Model& model, const Settings& settings)
    : impl_(std::make_unique<Impl>(context, model, settings)) {}

Mesher::~Mesher() = default;

std::optional<LayerReport> Mesher::next() {
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  impl_->context.check();
  if (impl_->finished) return std::nullopt;
  impl_->start();
  if (impl_->pending.empty() && impl_->growing) impl_->advance_all();
  if (impl_->pending.empty()) return std::nullopt;
  const LayerReport report = impl_->pending.front();
  impl_->pending.pop_front();
  return report;
}

bool Mesher::ready() const {
  const std::unique_lock<std::mutex> lock(impl_->mutex, std::try_to_lock);
  return lock.owns_lock() && !impl_->pending.empty();
}

MeshResult Mesher::snapshot() const {
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  if (impl_->finished) throw InvalidInput("there is no snapshot after result(): it gave the mesh");
  const RunContext never;
  const RunContext& context = impl_->context.cancelled() ? never : impl_->context;
  MeshResult result = merge(context, impl_->list.jobs(), impl_->boundary);
  name_given_edges(impl_->model, result);
  result.seconds = impl_->seconds();
  return result;
}

MeshResult Mesher::result() {
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  if (impl_->finished) throw InvalidInput("result() was called already; keep what it gave");
  impl_->context.check();
  if (!impl_->started) impl_->grow_all();
  MeshResult result = impl_->finish();
  result.seconds = impl_->seconds();
  impl_->finished = true;
  impl_->list.clear();
  return result;
}

}  // namespace advlayers
