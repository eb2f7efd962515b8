#include "mesher/mesher.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>

#include <cmath>
#include <set>

#include "base/error.h"
#include "geometry/shapes.h"
#include "mesher/mesh_of.h"
#include "mesher/wall_report.h"

namespace advlayers::test {
namespace {

TEST(Mesher, IsTheSameForAnyNumberOfThreads) {
  const Model model = model_of(BRepPrimAPI_MakeCylinder(4, 9).Shape());
  Settings settings = settings_of(0.5);
  settings.threads = 1;
  const MeshResult one = mesh_of(model, settings);
  for (const int threads : {2, 3}) {
    settings.threads = threads;
    const MeshResult other = mesh_of(model, settings);
    EXPECT_EQ(one.nodes, other.nodes);
    EXPECT_EQ(one.quads, other.quads);
    EXPECT_EQ(one.triangles, other.triangles);
    EXPECT_EQ(one.node_parent, other.node_parent);
  }
}

TEST(Mesher, ReportsComeInPatchOrderWithinALayer) {
  const Model model = model_of(BRepPrimAPI_MakeBox(4, 5, 6).Shape());
  RunContext context;
  Mesher mesher(context, model, settings_of(0.5));
  int layer = 0, patch = -1;
  while (const auto report = mesher.next()) {
    if (report->layer != layer) {
      EXPECT_EQ(report->layer, layer + 1);
      patch = -1;
    }
    EXPECT_GT(report->patch.value, patch);
    layer = report->layer;
    patch = report->patch.value;
  }
  EXPECT_GT(layer, 3);
  EXPECT_FALSE(mesher.next().has_value());
}

// A face without bounds among sound ones.
TopoDS_Shape box_and_endless_plane() {
  TopoDS_Compound compound;
  BRep_Builder builder;
  builder.MakeCompound(compound);
  builder.Add(compound, BRepPrimAPI_MakeBox(2, 2, 2).Shape());
  builder.Add(compound, BRepBuilderAPI_MakeFace(gp_Pln()).Face());
  return compound;
}

TEST(Mesher, LeavesOutABadFaceAndNamesIt) {
  const Model model = model_of(box_and_endless_plane());
  ASSERT_EQ(model.faces().size(), 7u);
  const MeshResult result = mesh_of(model, settings_of(0.5));
  ASSERT_EQ(result.diagnostics.size(), 1u);
  EXPECT_EQ(result.diagnostics[0].severity, Severity::kError);
  EXPECT_NE(result.diagnostics[0].sentence.english().find("Face7"), std::string::npos);
  EXPECT_EQ(result.diagnostics[0].patch, PatchId(6));
  std::set<FaceId> faces(result.quad_face.begin(), result.quad_face.end());
  EXPECT_EQ(faces.size(), 6u);
  EXPECT_EQ(result.patches.size(), 7u);
}

TEST(Mesher, RefusesAWrongSettingAtOnce) {
  const Model model = model_of(BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  RunContext context;
  EXPECT_THROW(Mesher(context, model, settings_of(-1.0)), InvalidInput);
}

TEST(Mesher, StopsForGoodOnceCancelled) {
  const Model model = model_of(BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  RunContext context;
  Mesher mesher(context, model, settings_of(0.1));
  ASSERT_TRUE(mesher.next().has_value());
  context.cancel();
  EXPECT_THROW(mesher.next(), Cancelled);
  EXPECT_THROW(mesher.result(), Cancelled);
  EXPECT_GT(mesher.snapshot().nodes.size(), 0u);
}

// The clock is asked where a stage begins and ends: it counts them, and asks to stop at one.
TEST(Mesher, NoStageFollowsTheOneInWhichItIsAskedToStop) {
  const Model model = model_of(BRepPrimAPI_MakeCylinder(2, 3).Shape());
  const auto turns = [&model](int stop_at, bool& cancelled) {
    int count = 0;
    RunContext* asked = nullptr;
    RunContext context([&] {
      if (++count == stop_at) asked->cancel();
      return static_cast<double>(count);
    });
    asked = &context;
    try {
      Mesher mesher(context, model, settings_of(1.0));
      while (mesher.next()) continue;
      mesher.result();
      cancelled = false;
    } catch (const Cancelled&) {
      cancelled = true;
    }
    return count;
  };
  bool cancelled = true;
  const int whole = turns(0, cancelled);
  EXPECT_FALSE(cancelled);
  ASSERT_GT(whole, 8);
  for (int k = 1; k < whole; ++k) {
    EXPECT_LE(turns(k, cancelled), k + 2) << "of " << whole;  // the begin and end of one stage
    EXPECT_TRUE(cancelled) << k << " of " << whole;
  }
}

TEST(Mesher, GivesItsResultOnce) {
  const Model model = model_of(BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  RunContext context;
  Mesher mesher(context, model, settings_of(0.3));
  EXPECT_GT(mesher.result().quads.size(), 0u);
  EXPECT_THROW(mesher.result(), InvalidInput);
  EXPECT_THROW(mesher.snapshot(), InvalidInput);
  EXPECT_FALSE(mesher.next().has_value());
}

TEST(Mesher, MeasuresWallsOnTheFinalMesh) {
  const Model model = model_of(BRepPrimAPI_MakeCylinder(4, 9).Shape());
  const MeshResult result = mesh_of(model, settings_of(0.5));
  // Two lids with one circle each, and the side with both.
  ASSERT_EQ(result.walls.size(), 4u);
  for (const WallReport& wall : result.walls) {
    EXPECT_NEAR(wall.achieved_mean, wall.first_height, 0.02 * wall.first_height);
    EXPECT_LE(wall.achieved_min, wall.achieved_mean);
    EXPECT_LE(wall.achieved_mean, wall.achieved_max);
    EXPECT_NEAR(wall.achieved_growth, 1.2, 0.03 * 1.2);
    EXPECT_GT(wall.layers, 2);
  }
}

TEST(Mesher, TellsOfAWallThatBoundsNothing) {
  const Model model = model_of(BRepPrimAPI_MakeCylinder(4, 9).Shape());
  Settings settings = settings_of(1.0);
  settings.walls_all = false;
  for (const auto& loop : model.faces()[0].loops) {
    for (const CoEdge& coedge : loop) {
      if (coedge.seam) settings.walls.assign(1, {{coedge.edge}, {}, {}, {}, {}});
    }
  }
  ASSERT_EQ(settings.walls.size(), 1u);
  const MeshResult result = mesh_of(model, settings);
  ASSERT_EQ(result.diagnostics.size(), 1u);
  EXPECT_EQ(result.diagnostics[0].code, "wall-inside");
  EXPECT_NE(result.diagnostics[0].sentence.english().find(edge_name(settings.walls[0].edges[0])),
            std::string::npos);
}

TEST(WallReport, ArcLengthFollowsTheSurface) {
  const Model model = model_of(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  Evaluator evaluator(model);
  PatchSurface surface(evaluator, {FaceId(0)});
  ASSERT_EQ(model.faces()[0].kind, SurfaceKind::kCylinder);
  const auto at = [&](double u, double v) {
    return SurfacePoint{FaceId(0), u, v, evaluator.frame(FaceId(0), u, v).xyz};
  };
  EXPECT_NEAR(arc_length(surface, at(1.0, 2.0), at(1.3, 2.0)), 0.6, 1e-5);
  EXPECT_NEAR(arc_length(surface, at(1.0, 2.0), at(1.0, 2.7)), 0.7, 1e-12);
}

}  // namespace
}  // namespace advlayers::test
