#include "geometry/face_boxes.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>

#include "geometry/occt_shape.h"

namespace advlayers {

std::vector<Box> face_boxes(const Model& model) {
  return translated("bounding box", [&] {
    std::vector<Box> boxes(model.faces().size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      // The poles of a B-spline bound it: no triangulation that the shape may carry is asked.
      constexpr bool kUseTriangulation = false;
      Bnd_Box bounds;
      BRepBndLib::Add(model.shape().face(FaceId(i)), bounds, kUseTriangulation);
      if (bounds.IsVoid()) continue;
      boxes[i] = Box(to_vec(bounds.CornerMin()), to_vec(bounds.CornerMax()));
    }
    return boxes;
  });
}

}  // namespace advlayers
