#include "boundary/layers_along.h"

#include <cmath>
#include <map>

namespace advlayers {
namespace {

constexpr double kUnlike = 0.02;  // layers on both sides of an edge that differ more are reported

class LayersAlong {
 public:
  LayersAlong(const RunContext& context, Evaluator& evaluator, Stretches& stretches)
      : context_(context), evaluator_(evaluator), stretches_(stretches) {}

  // After all else: the segments that layers need at their ends shorten no other edge's.
  std::vector<Diagnostic> run(const std::vector<MatchEnd>& match_ends) {
    std::map<std::pair<EdgeId, int>, std::vector<const MatchEnd*>> at_end;
    for (const MatchEnd& match : match_ends) at_end[{match.edge, match.end}].push_back(&match);
    std::vector<std::pair<std::size_t, LayeredCuts>> planned;  // all by the walls as they are now
    for (std::size_t i = 0; i < stretches_.all.size(); ++i) {
      context_.check();
      const EdgeId edge = stretches_[i].edge;
      std::vector<LayerSeries> series[2];
      for (int end = 0; end < 2; ++end) {
        const auto found = at_end.find({edge, end});
        const auto& stretches = stretches_.of(edge);
        if (found == at_end.end() || i != (end == 0 ? stretches.front() : stretches.back())) {
          continue;
        }
        for (const MatchEnd* match : found->second) series[end].push_back(series_of(*match));
      }
      if (series[0].empty() && series[1].empty()) continue;
      if (stretches_[i].spacing.fixed()) {
        note("match-fixed",
             Sentence("{}: its segments are fixed: layers run along it where they fit",
                      edge_name(edge)));
        continue;
      }
      LayeredCuts cuts = lay_out_layers(stretches_[i].spacing.length(), series[0], series[1]);
      if (cuts.spread > kUnlike) note_spread(edge, cuts.spread);
      planned.emplace_back(i, std::move(cuts));
    }
    for (auto& [i, cuts] : planned) {
      stretches_[i].spacing.set_layers(std::move(cuts));
      stretches_[i].spacing.cut();
    }
    return std::move(notes_);
  }

 private:
  LayerSeries series_of(const MatchEnd& match) {
    const auto& stretches = stretches_.of(match.wall);
    const Stretch& wall = stretches_[match.wall_end == 0 ? stretches.front() : stretches.back()];
    WallPlace place;
    place.part = match.wall_end;
    place.segment = wall.spacing.end_segment(match.wall_end);
    place.curvature =
        evaluator_.edge_curvature(match.wall, match.wall_end == 0 ? wall.t_begin : wall.t_end);
    LayerSeries series;
    series.height = first_height_at(match.spacing, place, match.max_height);
    series.growth = match.spacing.growth;
    series.layers = match.spacing.layers;
    series.most = match.max_height;
    series.sine = match.sine;
    if (match.stop_at_isotropy) series.isotropic = place.segment;
    return series;
  }

  void note_spread(EdgeId edge, double spread) {
    note(
        "match-mean",
        Sentence("{}: the layers of the faces beside it would cut it differently; its nodes follow "
                 "the mean, and leave the heights asked for by up to {} %",
                 edge_name(edge), std::lround(100.0 * spread)));
  }
  void note(const char* code, Sentence sentence) {
    Diagnostic note;
    note.severity = Severity::kInfo;
    note.code = code;
    note.sentence = std::move(sentence);
    notes_.push_back(std::move(note));
  }

  const RunContext& context_;
  Evaluator& evaluator_;
  Stretches& stretches_;
  std::vector<Diagnostic> notes_;
};

}  // namespace

std::vector<Diagnostic> run_layers_along(const RunContext& context, Evaluator& evaluator,
                                         const std::vector<MatchEnd>& match_ends,
                                         Stretches& stretches) {
  return LayersAlong(context, evaluator, stretches).run(match_ends);
}

}  // namespace advlayers
