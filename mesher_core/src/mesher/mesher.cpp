#include "mesher/mesher.h"

#include <algorithm>
#include <deque>
#include <mutex>
#include <numeric>
#include <set>

#include "base/error.h"
#include "base/free_memory.h"
#include "base/side_by_side.h"
#include "boundary/discretization.h"
#include "boundary/halve_edges.h"
#include "mesher/doubled_edges.h"
#include "mesher/merge.h"
#include "mesher/mid_nodes.h"
#include "mesher/patch_job.h"
#include "mesher/patch_plan.h"
#include "mesher/run_notes.h"
#include "mesher/sewn_edges.h"
#include "mesher/small_parts.h"
#include "mesher/tight_faces.h"
#include "sizing/initial_nodes.h"

namespace advlayers {
namespace {

// Times that the edges of a face may be halved where they are too coarse for it.
constexpr std::size_t kMostHalvings = 6;
// And for the sake of a face that is meshed all the same, but with triangles turned over.
constexpr std::size_t kMostForBetter = 2;
// Times that patches may be parted where their meshes could not follow their faces.
constexpr int kMostPartings = 3;

// Tells how many of the patches are done, by their areas.
class Share {
 public:
  Share(const RunContext& context, const PatchJobs& jobs) : context_(context) {
    for (const auto& job : jobs) whole_ += job->area();
  }
  void add(const PatchJob& job) {
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ += job.area();
    if (whole_ > 0.0) context_.tell_share(done_ / whole_);
  }

 private:
  const RunContext& context_;
  std::mutex mutex_;
  double whole_ = 0.0, done_ = 0.0;
};

}  // namespace

struct Mesher::Impl {
  Impl(RunContext& the_context, const Model& the_model, const Settings& the_settings);
  void place_initial_mesh();
  void make_jobs();
  void renew(std::size_t index);
  void cut_boundary();
  void start();
  using AskedEdges = std::vector<std::vector<EdgeId>>;  // by patch: edges it finds too coarse
  void triangulate_all();
  std::set<EdgeId> halve(const AskedEdges& asked, const std::vector<char>& chosen);
  void advance_all();
  void grow_all();
  void finish_jobs();
  std::map<std::string, double> seconds() const;
  bool part_faces(const std::vector<FaceId>& faces, const Sentence& said);
  void part_tight_faces();
  bool part_failed_faces();
  bool part_strained_faces();
  bool part_further();
  MeshResult finish();
  template <class Body>
  void for_each_job(const Body& body);

  RunContext& context;
  const Model& model;
  Settings settings;
  unsigned threads;
  Discretization boundary;
  Discretization first_cut;  // the boundary before any edge was halved
  std::vector<std::unique_ptr<PatchJob>> jobs;
  std::vector<std::size_t> order;  // of starting the jobs: large patches first
  std::deque<LayerReport> pending;
  std::vector<Diagnostic> partings;
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
      threads(useful_threads(the_settings.threads)) {
  const StageScope stage(context, RunStage::kBoundary);
  check(settings, model);
  place_initial_mesh();
  make_jobs();
  part_tight_faces();
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

// A patch that is meshed, and has the same faces as before, stays as it is.
void Mesher::Impl::make_jobs() {
  PatchJobs before = std::exchange(jobs, {});
  for (std::vector<FaceId>& faces : group_faces(model, settings)) {
    context.check();
    const PatchId id(jobs.size());
    const auto same = std::find_if(before.begin(), before.end(), [&](const auto& job) {
      return job != nullptr && job->meshed() && job->faces() == faces;
    });
    if (same != before.end()) {
      (*same)->renumber(id);
      jobs.push_back(std::move(*same));
    } else {
      jobs.push_back(std::make_unique<PatchJob>(id, std::move(faces), model, settings));
    }
  }
  order.resize(jobs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
    return jobs[a]->area() > jobs[b]->area();
  });
}

// Jobs share nothing that changes, so that neither their order nor the threads show in the result.
template <class Body>
void Mesher::Impl::for_each_job(const Body& body) {
  side_by_side(order.size(), threads, [&](std::size_t i) {
    context.check();
    body(*jobs[order[i]], order[i]);
  });
}

// Begins a meshed patch anew: its boundary has changed.
void Mesher::Impl::renew(std::size_t index) {
  const PatchJob& old = *jobs[index];
  jobs[index] = std::make_unique<PatchJob>(old.id(), old.faces(), model, settings);
  jobs[index]->plan(context);
}

void Mesher::Impl::cut_boundary() {
  for_each_job([this](PatchJob& job, std::size_t) {
    if (!job.meshed()) job.plan(context);
  });
  std::vector<MatchEnd> match_ends;
  std::vector<FourSides> strips;
  for (const auto& job : jobs) {
    match_ends.insert(match_ends.end(), job->match_ends().begin(), job->match_ends().end());
    if (job->strip()) strips.push_back(*job->strip());
  }
  Evaluator evaluator(model);
  Discretization cut = discretize(context, evaluator, settings, match_ends, strips);
  // Meshed patches fit the boundary as it stands, with the edges that were halved since.
  if (same_cuts(cut, first_cut)) return;
  for_each_job([this](PatchJob& job, std::size_t index) {
    if (job.meshed()) renew(index);
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
  triangulate_all();
  while (part_failed_faces()) {
    cut_boundary();
    triangulate_all();
  }
  release_free_memory();
  started = true;
}

// Where the boundary turns out to be cut too coarsely for a face, its edges are halved until it is
// not. A face that stays so however finely its edges are cut (they cross each other) is given up,
// and no edge is halved for its sake: its neighbours would pay for it.
void Mesher::Impl::triangulate_all() {
  Share done(context, jobs);
  std::vector<AskedEdges> rounds;
  std::vector<char> waiting;
  for (const auto& job : jobs) waiting.push_back(job->meshed() ? 0 : 1);
  const Discretization before = boundary;
  while (true) {
    AskedEdges asked(jobs.size());
    for_each_job([&](PatchJob& job, std::size_t index) {
      if (waiting[index]) asked[index] = job.triangulate(context, boundary);
      if (rounds.empty()) done.add(job);
    });
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      waiting[i] = !asked[i].empty() && (rounds.size() < kMostForBetter || !jobs[i]->meshed());
    }
    if (std::find(waiting.begin(), waiting.end(), 1) == waiting.end()) break;
    if (rounds.size() == kMostHalvings) break;
    halve(asked, waiting);
    rounds.push_back(std::move(asked));
  }
  if (rounds.empty()) return;
  std::vector<char> cured(waiting);
  for (char& c : cured) c = c ? 0 : 1;
  boundary = before;
  std::set<EdgeId> halved;
  for (const AskedEdges& asked : rounds) halved.merge(halve(asked, cured));
  for_each_job([&](PatchJob& job, std::size_t index) {
    const auto beside = [&](EdgeId edge) { return job.borders_on(edge); };
    if (!cured[index] || std::none_of(halved.begin(), halved.end(), beside)) return;
    if (job.finished()) renew(index);
    jobs[index]->triangulate(context, boundary);
  });
}

// Halves the edges that the chosen patches ask for, each once; returns them.
std::set<EdgeId> Mesher::Impl::halve(const AskedEdges& asked, const std::vector<char>& chosen) {
  std::set<EdgeId> edges;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (chosen[i]) edges.insert(asked[i].begin(), asked[i].end());
  }
  Evaluator evaluator(model);
  halve_edges(evaluator, {edges.begin(), edges.end()}, boundary);
  return edges;
}

// One layer on every patch that still grows.
void Mesher::Impl::advance_all() {
  const StageScope stage(context, RunStage::kLayers);
  std::vector<std::optional<LayerReport>> reports(jobs.size());
  for_each_job([&](PatchJob& job, std::size_t index) { reports[index] = job.advance(context); });
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
  Share done(context, jobs);
  for_each_job([&](PatchJob& job, std::size_t) {
    job.finish(context, boundary);
    done.add(job);
  });
  release_free_memory();
}

// Makes the faces patches of their own; what is not yet meshed then waits for another start. Edges
// that the user called smooth stay inside their patches. `said` is told of them. Returns false
// where nothing is left to part.
bool Mesher::Impl::part_faces(const std::vector<FaceId>& faces, const Sentence& said) {
  const FeatureRule rule = feature_rule(settings);
  const auto listed = [](const std::vector<EdgeId>& edges, EdgeId edge) {
    return std::binary_search(edges.begin(), edges.end(), edge);
  };
  std::set<EdgeId> edges;
  std::string names;
  for (const FaceId face : faces) {
    const std::size_t known = edges.size();
    for (const auto& loop : model.face(face).loops) {
      for (const CoEdge& coedge : loop) {
        const EdgeId edge = coedge.edge;
        const bool seam = model.edge(edge).faces.size() < 2;
        if (!seam && !listed(rule.smooth, edge) && !listed(rule.boundary, edge)) edges.insert(edge);
      }
    }
    if (edges.size() > known) names += (names.empty() ? "" : ", ") + face_name(face);
  }
  if (edges.empty()) return false;
  settings.boundary_edges.insert(settings.boundary_edges.end(), edges.begin(), edges.end());
  Diagnostic note;
  note.severity = Severity::kInfo;
  note.code = "patch-parted";
  note.sentence = said.about(names);
  partings.push_back(std::move(note));
  make_jobs();
  started = false;
  growing = true;
  widest_front = 0;
  return true;
}

void Mesher::Impl::part_tight_faces() {
  std::set<FaceId> in_company;
  for (const auto& job : jobs) {
    if (job->faces().size() > 1) in_company.insert(job->faces().begin(), job->faces().end());
  }
  if (in_company.empty()) return;
  Evaluator evaluator(model);
  std::vector<FaceId> tight;
  for (const FaceId face : tight_faces(evaluator, settings)) {
    if (in_company.count(face) > 0) tight.push_back(face);
  }
  part_faces(tight, Sentence("meshed on their own, as they are curved more tightly than layers of "
                             "this size can follow: {}"));
}

// Faces whose patches could not be triangulated with them cost their neighbours nothing.
bool Mesher::Impl::part_failed_faces() {
  std::vector<FaceId> failed;
  for (const auto& job : jobs) {
    failed.insert(failed.end(), job->failed_faces().begin(), job->failed_faces().end());
  }
  return part_faces(failed, Sentence("meshed on their own, as their patches could not be meshed "
                                     "with them: {}"));
}

// Faces that the mesh of their patch could not follow: elements reach over them, or found no room.
bool Mesher::Impl::part_strained_faces() {
  std::vector<FaceId> strained;
  for (const auto& job : jobs) {
    strained.insert(strained.end(), job->strained_faces().begin(), job->strained_faces().end());
  }
  return part_faces(strained, Sentence("meshed on their own, as the elements of their patches "
                                       "could not follow them: {}"));
}

bool Mesher::Impl::part_further() {
  const bool failed = part_failed_faces();
  return part_strained_faces() || failed;
}

MeshResult Mesher::Impl::finish() {
  const bool whole = !growing && pending.empty();
  finish_jobs();
  for (int k = 0; whole && k < kMostPartings && part_further(); ++k) {
    grow_all();
    finish_jobs();
  }
  const StageScope stage(context, RunStage::kCore);
  part_doubled_edges(context, jobs, boundary);
  for_each_job([this](PatchJob& job, std::size_t) { job.measure(context); });
  MeshResult result = merge(context, jobs, boundary);
  if (settings.order == 2) {
    add_mid_nodes(context, jobs, boundary, settings, threads, model, result);
  }
  FigureCounts counts;
  for (const auto& job : jobs) {
    counts.add(job->counts());
    const auto& walls = job->wall_reports();
    result.walls.insert(result.walls.end(), walls.begin(), walls.end());
  }
  std::vector<FaceId> faces;
  for (const auto& job : jobs) faces.insert(faces.end(), job->faces().begin(), job->faces().end());
  std::sort(faces.begin(), faces.end());
  note_small_parts(model, settings, faces, result.diagnostics);
  note_sewing(model, result.diagnostics);
  note_initial_mesh(settings, jobs, result.diagnostics);
  note_idle_walls(settings, jobs, result.diagnostics);
  for (const auto* notes : {&partings, &boundary.notes}) {
    result.diagnostics.insert(result.diagnostics.end(), notes->begin(), notes->end());
  }
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
  MeshResult result = merge(context, impl_->jobs, impl_->boundary);
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
  impl_->jobs.clear();
  return result;
}

}  // namespace advlayers
