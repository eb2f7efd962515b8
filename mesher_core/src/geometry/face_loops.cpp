#include "geometry/face_loops.h"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <ShapeFix_Edge.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/face_surface.h"

namespace advlayers {

namespace {

constexpr int kChords = 16;  // that stand for a curve in (u, v)

// A co-edge with its ends, in the order of a walk that has the material on the left in (u, v).
struct Link {
  CoEdge coedge;
  VertexId from, to;
  Vec2 uv_from, uv_to;
  double tolerance = 0.0;
};

class LoopBuilder {
 public:
  LoopBuilder(const TopoDS_Face& shape_face, const Model::Shape& shape,
              const std::vector<Edge>& edges, Face& face, std::vector<Pcurve>& pcurves)
      : shape_face_(TopoDS::Face(shape_face.Oriented(TopAbs_FORWARD))),
        shape_(shape),
        edges_(edges),
        face_(face),
        pcurves_(pcurves) {
    scale_ = Vec2(1.0 / std::max(face.u_max - face.u_min, 1e-300),
                  1.0 / std::max(face.v_max - face.v_min, 1e-300));
  }

  void build() {
    const std::vector<TopoDS_Wire> wires = bounding_wires();
    count_uses(wires);
    for (const TopoDS_Wire& wire : wires) {
      std::vector<Link> links;
      if (!collect(wire, links) || !chain(links)) return;
    }
    if (loops_.empty()) {
      face_.defect = Sentence("it has no boundary wire");
      return;
    }
    settle_sheets();
    if (!orient() || !add_slits()) return;
    store();
  }

 private:
  // Wires of the face, the outer one first; internal ones are slits.
  std::vector<TopoDS_Wire> bounding_wires() const {
    std::vector<TopoDS_Wire> found;
    const TopoDS_Wire outer = BRepTools::OuterWire(shape_face_);
    for (TopoDS_Iterator it(shape_face_); it.More(); it.Next()) {
      if (it.Value().ShapeType() != TopAbs_WIRE || !bounds(it.Value())) continue;
      const TopoDS_Wire wire = TopoDS::Wire(it.Value());
      found.insert(wire.IsSame(outer) ? found.begin() : found.end(), wire);
    }
    return found;
  }

  static bool bounds(const TopoDS_Shape& s) {
    return s.Orientation() == TopAbs_FORWARD || s.Orientation() == TopAbs_REVERSED;
  }

  void count_uses(const std::vector<TopoDS_Wire>& wires) {
    for (const TopoDS_Wire& wire : wires) {
      for (TopoDS_Iterator it(wire); it.More(); it.Next()) {
        if (bounds(it.Value())) ++uses_[shape_.edges.FindIndex(it.Value())];
      }
    }
  }

  bool collect(const TopoDS_Wire& wire, std::vector<Link>& links) {
    for (TopoDS_Iterator it(wire); it.More(); it.Next()) {
      if (!bounds(it.Value())) continue;
      const TopoDS_Edge shape_edge = TopoDS::Edge(it.Value());
      Link link;
      if (!make_link(shape_edge, link)) return false;
      links.push_back(link);
    }
    return true;
  }

  // An edge inside the face, where another face stands on it or a line was imprinted, bounds it on
  // both sides: there and back, a loop without area.
  bool add_slits() {
    const Vec2 centre = middle(loops_.front());
    for (TopoDS_Iterator wire(shape_face_); wire.More(); wire.Next()) {
      if (wire.Value().ShapeType() != TopAbs_WIRE) continue;
      for (TopoDS_Iterator it(wire.Value()); it.More(); it.Next()) {
        if (it.Value().Orientation() != TopAbs_INTERNAL) continue;
        Link there;
        if (!make_link(TopoDS::Edge(it.Value().Oriented(TopAbs_FORWARD)), there)) return false;
        shift(there, shift_towards(centre, middle({there})));
        std::vector<Link> back{there};
        reverse(back);
        loops_.push_back({there, back.front()});
      }
    }
    return true;
  }

  bool make_link(const TopoDS_Edge& shape_edge, Link& link) {
    const int index = shape_.edges.FindIndex(shape_edge);
    CoEdge& coedge = link.coedge;
    coedge.edge = EdgeId(index - 1);
    const Edge& edge = edges_[coedge.edge.index()];
    coedge.forward = shape_edge.Orientation() == TopAbs_FORWARD;
    coedge.seam = uses_[index] > 1;
    coedge.degenerate = edge.degenerate;
    if (!(edge.last > edge.first)) {
      face_.defect = Sentence("{} has no curve", edge_name(coedge.edge));
      return false;
    }
    const Pcurve* pcurve = fetch_pcurve(shape_edge, coedge);
    if (!pcurve) {
      face_.defect = Sentence("{} has no curve in the face's (u, v)", edge_name(coedge.edge));
      return false;
    }
    const Vec2 a = pcurve->at(edge.first, edge), b = pcurve->at(edge.last, edge);
    link.from = coedge.forward ? edge.start : edge.end;
    link.to = coedge.forward ? edge.end : edge.start;
    link.uv_from = coedge.forward ? a : b;
    link.uv_to = coedge.forward ? b : a;
    link.tolerance = std::max(edge.tolerance, face_.tolerance);
    return true;
  }

  const Pcurve* fetch_pcurve(const TopoDS_Edge& shape_edge, CoEdge& coedge) {
    Pcurve pcurve;
    pcurve.edge = coedge.edge;
    pcurve.curve = BRep_Tool::CurveOnSurface(shape_edge, shape_face_, pcurve.first, pcurve.last);
    if (pcurve.curve.IsNull()) {
      ShapeFix_Edge().FixAddPCurve(shape_edge, shape_face_, coedge.seam, Precision::Confusion());
      pcurve.curve = BRep_Tool::CurveOnSurface(shape_edge, shape_face_, pcurve.first, pcurve.last);
    }
    if (pcurve.curve.IsNull()) return nullptr;
    if (BRep_Tool::IsClosed(shape_edge, shape_face_)) coedge.pcurve = coedge.forward ? 0 : 1;
    pcurve.which = coedge.pcurve;
    for (const Pcurve& known : pcurves_) {
      if (known.edge == pcurve.edge && known.which == pcurve.which) return &known;
    }
    pcurves_.push_back(pcurve);
    return &pcurves_.back();
  }

  double gap(const Vec2& a, const Vec2& b) const { return (a - b).cwiseProduct(scale_).norm(); }

  // Whole periods to add to `b` that bring it nearest to `a`.
  Vec2 shift_towards(const Vec2& a, const Vec2& b) const {
    Vec2 shift = Vec2::Zero();
    const double periods[2] = {face_.u_period, face_.v_period};
    for (int k = 0; k < 2; ++k) {
      if (periods[k] > 0.0) shift[k] = periods[k] * std::round((a[k] - b[k]) / periods[k]);
    }
    return shift;
  }

  // BRepTools_WireExplorer stops short on bad wires and at poles, so the links are joined here: at
  // the same CAD vertex first, then by the gap in (u, v), then by their order in the wire.
  bool chain(std::vector<Link> links) {
    std::vector<bool> used(links.size(), false);
    for (std::size_t seed = 0; seed < links.size(); ++seed) {
      if (used[seed]) continue;
      used[seed] = true;
      std::vector<Link> loop{links[seed]};
      while (true) {
        const Link& last = loop.back();
        const double closing = closing_gap(last, loop.front());
        std::size_t best = links.size();
        double best_gap = closing;
        for (std::size_t offset = 1; offset <= links.size(); ++offset) {
          const std::size_t i = (seed + loop.size() - 1 + offset) % links.size();
          if (used[i] || links[i].from != last.to) continue;
          const double g = gap(last.uv_to, links[i].uv_from);
          if (g >= best_gap - 1e-9) continue;
          best = i;
          best_gap = g;
        }
        if (best == links.size()) break;
        used[best] = true;
        loop.push_back(links[best]);
      }
      if (loop.back().to != loop.front().from) {
        face_.defect =
            Sentence("its boundary is open after {}", edge_name(loop.back().coedge.edge));
        return false;
      }
      loops_.push_back(std::move(loop));
    }
    return true;
  }

  double closing_gap(const Link& last, const Link& first) const {
    return last.to == first.from ? gap(last.uv_to, first.uv_from)
                                 : std::numeric_limits<double>::infinity();
  }

  static void shift(Link& link, const Vec2& by) {
    link.coedge.uv_shift += by;
    link.uv_from += by;
    link.uv_to += by;
  }

  // By the curves: the ends of a loop may all lie on one seam.
  Vec2 middle(const std::vector<Link>& loop) const {
    Eigen::AlignedBox2d box;
    for (const Link& link : loop) {
      for (int k = 0; k <= kChords; ++k) box.extend(point_on(link, k));
    }
    return box.center();
  }

  // In (u, v), along the walk.
  Vec2 point_on(const Link& link, int k) const {
    const Edge& edge = edges_[link.coedge.edge.index()];
    const Pcurve& pcurve = *std::find_if(pcurves_.begin(), pcurves_.end(), [&](const Pcurve& p) {
      return p.edge == link.coedge.edge && p.which == link.coedge.pcurve;
    });
    const double a = static_cast<double>(link.coedge.forward ? k : kChords - k) / kChords;
    return pcurve.at(edge.first + a * (edge.last - edge.first), edge) + link.coedge.uv_shift;
  }

  // Curves of one loop may sit whole periods apart, and so may a hole and the loop around it.
  void settle_sheets() {
    for (auto& loop : loops_) {
      for (std::size_t i = 1; i < loop.size(); ++i) {
        shift(loop[i], shift_towards(loop[i - 1].uv_to, loop[i].uv_from));
      }
    }
    const Vec2 centre(0.5 * (face_.u_min + face_.u_max), 0.5 * (face_.v_min + face_.v_max));
    for (auto& loop : loops_) {
      const Vec2 by = shift_towards(centre, middle(loop));
      for (Link& link : loop) shift(link, by);
    }
  }

  // Twice the signed area in (u, v), from chords of the curves.
  double signed_area(const std::vector<Link>& loop) const {
    double area = 0.0;
    Vec2 previous = loop.back().uv_to;
    for (const Link& link : loop) {
      for (int k = 0; k <= kChords; ++k) {
        const Vec2 p = point_on(link, k);
        area += previous.x() * p.y() - previous.y() * p.x();
        previous = p;
      }
    }
    return area;
  }

  // Checks that each loop closes in (u, v), and turns an inside-out boundary round.
  bool orient() {
    double total = 0.0;
    for (const auto& loop : loops_) {
      const Vec2 jump = shift_towards(loop.front().uv_from, loop.back().uv_to);
      if (!jump.isZero()) {
        face_.defect = Sentence("its boundary runs around the closed surface without a seam, at {}",
                                edge_name(loop.front().coedge.edge));
        return false;
      }
      total += signed_area(loop);
    }
    if (total >= 0.0) return true;
    for (auto& loop : loops_) reverse(loop);
    return true;
  }

  static void reverse(std::vector<Link>& loop) {
    std::reverse(loop.begin(), loop.end());
    for (Link& link : loop) {
      link.coedge.forward = !link.coedge.forward;
      std::swap(link.from, link.to);
      std::swap(link.uv_from, link.uv_to);
    }
  }

  void store() {
    for (auto& loop : loops_) {
      // Seen against a normal of -(Su x Sv), left in (u, v) is right.
      if (face_.reversed) reverse(loop);
      std::vector<CoEdge>& out = face_.loops.emplace_back();
      for (const Link& link : loop) out.push_back(link.coedge);
    }
  }

  TopoDS_Face shape_face_;  // forward: its edges then have the material on the left in (u, v)
  const Model::Shape& shape_;
  const std::vector<Edge>& edges_;
  Face& face_;
  std::vector<Pcurve>& pcurves_;
  Vec2 scale_;
  std::map<int, int> uses_;
  std::vector<std::vector<Link>> loops_;
};

}  // namespace

void build_loops(const TopoDS_Face& shape_face, const Model::Shape& shape,
                 const std::vector<Edge>& edges, Face& face, std::vector<Pcurve>& pcurves) {
  LoopBuilder(shape_face, shape, edges, face, pcurves).build();
  std::sort(pcurves.begin(), pcurves.end(), [](const Pcurve& a, const Pcurve& b) {
    return a.edge < b.edge || (a.edge == b.edge && a.which < b.which);
  });
}

}  // namespace advlayers
