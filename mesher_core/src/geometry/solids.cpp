#include "geometry/solids.h"

#include <TopExp.hxx>
#include <algorithm>

#include "geometry/occt_shape.h"

namespace advlayers {

std::vector<std::vector<FaceId>> solids_of(const Model& model) {
  return translated("solid", [&] {
    TopTools_IndexedMapOfShape solids;
    TopExp::MapShapes(model.shape().root, TopAbs_SOLID, solids);
    std::vector<std::vector<FaceId>> all;
    for (int i = 1; i <= solids.Extent(); ++i) {
      TopTools_IndexedMapOfShape faces;
      TopExp::MapShapes(solids(i), TopAbs_FACE, faces);
      std::vector<FaceId> around;
      for (int k = 1; k <= faces.Extent(); ++k) {
        const int number = model.shape().faces.FindIndex(faces(k));
        if (number > 0) around.emplace_back(number - 1);
      }
      std::sort(around.begin(), around.end());
      all.push_back(std::move(around));
    }
    return all;
  });
}

}  // namespace advlayers
