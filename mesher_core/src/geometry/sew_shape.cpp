#include "geometry/sew_shape.h"

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <algorithm>

#include "geometry/read_progress.h"

namespace advlayers {
namespace {

class SewnNumbering {
 public:
  SewnNumbering(Model::Shape& shape, BRepBuilderAPI_Sewing& sewing)
      : shape_(shape), sewing_(sewing) {
    TopExp::MapShapes(shape.root, TopAbs_FACE, given_faces_);
    TopExp::MapShapes(shape.root, TopAbs_EDGE, given_edges_);
  }

  void run() {
    number_faces();
    find_pieces();
    number_edges();
    shape_.root = sewing_.SewedShape();
  }

 private:
  // A face that sewing took for too small to keep stays as it was.
  void number_faces() {
    TopTools_IndexedMapOfShape sewn;
    TopExp::MapShapes(sewing_.SewedShape(), TopAbs_FACE, sewn);
    for (int i = 1; i <= given_faces_.Extent(); ++i) {
      const TopoDS_Shape face = sewing_.ModifiedSubShape(given_faces_(i));
      const int index = face.IsNull() ? 0 : sewn.FindIndex(face);
      shape_.faces.Add(index > 0 ? sewn(index) : given_faces_(i));
    }
    for (int i = 1; i <= shape_.faces.Extent(); ++i) {
      TopExp::MapShapes(shape_.faces(i), TopAbs_EDGE, edges_of_faces_);
      TopExp::MapShapes(shape_.faces(i), TopAbs_VERTEX, shape_.vertices);
    }
  }

  void find_pieces() {
    for (int i = 1; i <= given_edges_.Extent(); ++i) {
      const TopoDS_Shape became = sewing_.ModifiedSubShape(given_edges_(i));
      TopTools_IndexedMapOfShape parts;
      if (!became.IsNull()) TopExp::MapShapes(became, TopAbs_EDGE, parts);
      std::vector<int>& found = pieces_.emplace_back();
      for (int k = 1; k <= parts.Extent(); ++k) {
        if (const int index = edges_of_faces_.FindIndex(parts(k))) found.push_back(index);
      }
    }
  }

  void number_edges() {
    std::vector<int> number(static_cast<std::size_t>(edges_of_faces_.Extent()) + 1, 0);
    for (const std::vector<int>& pieces : pieces_) {
      const auto own = std::find_if(pieces.begin(), pieces.end(),
                                    [&](int piece) { return number[std::size_t(piece)] == 0; });
      if (own == pieces.end()) {
        shape_.edges.Add(nothing());
      } else {
        number[std::size_t(*own)] = shape_.edges.Add(edges_of_faces_(*own));
      }
    }
    for (int i = 1; i <= edges_of_faces_.Extent(); ++i) {
      if (number[std::size_t(i)] == 0)
        number[std::size_t(i)] = shape_.edges.Add(edges_of_faces_(i));
    }
    for (const std::vector<int>& pieces : pieces_) {
      std::vector<EdgeId>& named = shape_.pieces.emplace_back();
      for (const int piece : pieces) named.emplace_back(number[std::size_t(piece)] - 1);
    }
  }

  static TopoDS_Edge nothing() {
    TopoDS_Edge edge;
    BRep_Builder builder;
    builder.MakeEdge(edge);
    builder.Degenerated(edge, Standard_True);
    return edge;
  }

  Model::Shape& shape_;
  BRepBuilderAPI_Sewing& sewing_;
  TopTools_IndexedMapOfShape given_faces_, given_edges_, edges_of_faces_;
  std::vector<std::vector<int>> pieces_;  // by given edge: into edges_of_faces_
};

}  // namespace

void sew_shape(const RunContext& context, Model::Shape& shape, double tolerance) {
  translated("sewing", [&] {
    constexpr Standard_Boolean kSew = Standard_True, kAnalyse = Standard_True, kCut = Standard_True,
                               kNonManifold = Standard_True;
    BRepBuilderAPI_Sewing sewing(tolerance, kSew, kAnalyse, kCut, kNonManifold);
    sewing.Add(shape.root);
    const Handle(ReadProgress) progress = new ReadProgress(context);
    sewing.Perform(progress->Start());
    context.check();
    if (sewing.SewedShape().IsNull()) throw GeometryError("sewing left nothing of the shape");
    SewnNumbering(shape, sewing).run();
  });
}

}  // namespace advlayers
