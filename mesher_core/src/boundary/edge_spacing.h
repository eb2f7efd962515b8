// How one smooth stretch of a CAD edge is cut: target spacing along its arc length, counted and
// placed so that each segment holds an equal share.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "boundary/divide_length.h"
#include "boundary/end_segments.h"
#include "boundary/match_end.h"
#include "geometry/evaluator.h"
#include "sizing/size_field.h"

namespace advlayers {

struct SpacingLimits {
  double size;             // [mm] longest segment
  const SizeField* sizes;  // where they are less, and how fast segments grow
  double curve_angle;      // [rad] a segment of the curve may turn
  double normal_angle;     // [rad] the normals of the faces beside it may turn along a segment
  double chord;            // [mm] a segment's middle may lie off the curve; 0: anything
  double least;            // [mm] curvature asks for no less
  bool open = true;        // the stretch does not end where it begins
};

class EdgeSpacing {
 public:
  // The stretch between two parameters of the edge, which no kink divides. `sides`: the meshed
  // faces beside it, with the co-edges by which they use it.
  struct Side {
    FaceId face;
    CoEdge coedge;
  };
  EdgeSpacing(Evaluator& evaluator, EdgeId edge, double t_begin, double t_end,
              const std::vector<Side>& sides, const SpacingLimits& limits);

  double length() const { return samples_.back().s; }
  // At least so many segments.
  void require(int count) { required_ = std::max(required_, count); }
  // The segment at an end (0: the begin) is to be about `spacing` long, and those after it to grow
  // from there. Only ever lowered.
  void limit_end(int end, double spacing);
  // Its first segments from either end are given; only what lies between is cut by size and angles.
  void set_layers(LayeredCuts layers) { layers_ = std::move(layers); }
  // So many segments in geometric steps, whatever else asks for: `ratio` of the last to the first,
  // or, towards both ends, of the middle one to those at the ends.
  void fix(int segments, double ratio, bool both_ends);
  // The segments that `ratio` takes with none longer than the size.
  int segments_for(double ratio, bool both_ends) const;
  // So too, with given lengths at its ends.
  void fix_ends(const EndSegments& ends) { ends_ = ends; }
  bool fixed() const { return fixed_.segments > 0 || ends_; }
  // Cuts anew; arc lengths from the begin, both ends included.
  // Throws InvalidInput where the size would cut the edge into millions.
  void cut();
  const std::vector<double>& cuts() const { return cuts_; }
  int count() const { return static_cast<int>(cuts_.size()) - 1; }
  double end_segment(int end) const;
  // Between the segments that are given at its ends: their mean length, and one more of them.
  bool can_lengthen() const { return !layers_.closed; }
  double mean_free_segment() const;
  void lengthen();
  // What cut() goes by: the spacing wanted along the stretch, and the least number of segments.
  std::vector<SpacingSample> wanted() const { return graded(0.0, length()); }
  int required() const { return required_; }
  // Cuts at these shares of the length, from 0 to 1, instead.
  void cut_at(const std::vector<double>& shares);

 private:
  struct Station {
    double t, s;
    Vec3 xyz, tangent;
    double size;  // [mm] that the sizes ask for there
    std::vector<Vec3> normals;
  };
  // Derivatives are taken `inward` of t.
  Station station(double t, double inward) const;
  void refine(const Station& a, const Station& b, int depth);
  // What leads through the narrowest bend that is seen, and how far along the stretch its middle
  // is.
  struct Chord {
    Vec3 along;
    double middle;
  };
  Chord chord_about(const Station& at) const;
  double spacing_of_turn(double ds, double turn) const;
  double bend_spacing(const Station& a, const Station& b) const;
  double turn_spacing(const Station& a, const Station& b) const;
  int free_count() const;
  std::vector<SpacingSample> graded(double from, double to) const;
  void cut_between(double from, double to);

  Evaluator* evaluator_;
  EdgeId edge_;
  double t_begin_, t_end_ = 0.0;
  const std::vector<Side>* sides_;  // while sampling only
  SpacingLimits limits_;
  double least_by_normals_ = 0.0, least_by_curve_ = 0.0, bend_ = 0.0;  // [mm]
  std::vector<SpacingSample> samples_;
  int required_ = 1;
  double end_limit_[2] = {std::numeric_limits<double>::infinity(),
                          std::numeric_limits<double>::infinity()};
  struct Fixed {
    int segments = 0;  // 0: not fixed
    double ratio = 1.0;
    bool both_ends = false;
  };
  void cut_fixed();

  Fixed fixed_;
  std::optional<EndSegments> ends_;
  LayeredCuts layers_;
  std::vector<double> cuts_;
};

}  // namespace advlayers
