#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BinTools.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/error.h"
#include "boundary/discretization.h"
#include "coarse_settings.h"
#include "geometry/file_gate.h"
#include "geometry/shapes.h"

namespace advlayers {
namespace {

namespace fs = std::filesystem;

// A directory of its own that goes with the test.
class ReadFile : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              ("advlayers_" + std::string(info->name()) + "_" + std::to_string(std::rand()));
    fs::create_directories(folder_);
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write_step(const TopoDS_Shape& shape, const std::string& name, const char* unit) {
    STEPControl_Controller::Init();
    Interface_Static::SetCVal("write.step.unit", unit);  // asked for when the writer is made
    STEPControl_Writer writer;
    writer.Transfer(shape, STEPControl_AsIs);
    EXPECT_EQ(writer.Write(path(name).c_str()), IFSelect_RetDone);
    Interface_Static::SetCVal("write.step.unit", "MM");
    return path(name);
  }

  std::string write_iges(const TopoDS_Shape& shape, const std::string& name, const char* unit) {
    IGESControl_Controller::Init();
    IGESControl_Writer writer(unit, 1);
    writer.AddShape(shape);
    writer.ComputeModel();
    EXPECT_TRUE(writer.Write(path(name).c_str()));
    return path(name);
  }

  std::string write_text(const std::string& text, const std::string& name) {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  fs::path folder_;
};

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string refusal(const std::string& path) {
  try {
    read_file(RunContext(), path);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TopoDS_Shape box() { return BRepPrimAPI_MakeBox(25.4, 50.8, 76.2).Shape(); }

void expect_box(const Model& model) {
  ASSERT_EQ(model.faces().size(), 6u);
  EXPECT_NEAR(model.diagonal(), 25.4 * std::sqrt(14.0), 1e-6);
  for (const Face& face : model.faces()) EXPECT_EQ(face.defect.english(), "");
}

TEST_F(ReadFile, LengthsComeOutInMillimetres) {
  for (const char* unit : {"MM", "INCH", "M"}) {
    expect_box(read_file(RunContext(), write_step(box(), "box.step", unit)));
  }
  for (const char* unit : {"MM", "IN", "M"}) {
    expect_box(read_file(RunContext(), write_iges(box(), "box.iges", unit)));
  }
}

TEST_F(ReadFile, AUnitSetByOthersChangesNothing) {
  const std::string step = write_step(box(), "box.step", "INCH");
  const std::string iges = write_iges(box(), "box.iges", "IN");
  for (const char* unit : {"M", "INCH", "MM"}) {
    Interface_Static::SetCVal("xstep.cascade.unit", unit);
    expect_box(read_file(RunContext(), step));
    Interface_Static::SetCVal("xstep.cascade.unit", unit);
    expect_box(read_file(RunContext(), iges));
  }
}

TEST_F(ReadFile, EndingsCountInAnyCase) {
  for (const char* name : {"a.step", "a.STEP", "a.stp", "a.StP"}) {
    expect_box(read_file(RunContext(), write_step(box(), name, "MM")));
  }
  for (const char* name : {"a.iges", "a.IGS"})
    expect_box(read_file(RunContext(), write_iges(box(), name, "MM")));
  for (const char* name : {"a.brep", "a.BRP"}) {
    expect_box(read_file(RunContext(), write_text(test::brep_text(box()), name)));
  }
}

TEST_F(ReadFile, BinaryBrepIsReadWholeOrRefused) {
  std::ostringstream stream;
  BinTools::Write(box(), stream);
  const std::string bytes = stream.str();
  expect_box(read_file(RunContext(), write_text(bytes, "box.brep")));
  for (const std::size_t part : {3u, 5u, 8u}) {
    const std::string cut = bytes.substr(0, bytes.size() * part / 9);
    EXPECT_NE(refusal(write_text(cut, "cut.brep")).find("cut.brep: "), std::string::npos) << part;
  }
}

TEST_F(ReadFile, AMissingReaderIsNamed) {
  const std::string brep = write_text(test::brep_text(box()), "box.brep");
  set_reader_program("/no/such/reader");
  const std::string refused = refusal(brep);
  set_reader_program(READER_PROGRAM);
  EXPECT_NE(refused.find("no process can be started to read it: /no/such/reader: "),
            std::string::npos)
      << refused;
}

TEST_F(ReadFile, NothingIsPrinted) {
  const std::string step = write_step(box(), "box.step", "MM");
  const std::string iges = write_iges(box(), "box.iges", "MM");
  const std::string brep = write_text(test::brep_text(box()), "box.brep");
  const std::string bad = write_text("garbage", "bad.step");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  for (const std::string& path : {step, iges, brep, bad}) refusal(path);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(ReadFile, RefusalsNameTheFile) {
  for (const char* name :
       {"none.step", "none.iges", "none.brep", "shape.obj", "shape", "a.step/b"}) {
    EXPECT_NE(refusal(path(name)).find(name), std::string::npos);
  }
  for (const char* name : {"bad.step", "bad.igs", "bad.brep"}) {
    EXPECT_NE(refusal(write_text("no shape at all\n", name)).find(name), std::string::npos);
    EXPECT_NE(refusal(write_text("", name)).find(name), std::string::npos);
  }
}

TEST_F(ReadFile, CutOffFilesAreRefused) {
  const std::string step = text_of(write_step(box(), "box.step", "MM"));
  const std::string iges = text_of(write_iges(box(), "box.iges", "MM"));
  for (const double part : {0.2, 0.5, 0.9, 0.99}) {
    const auto cut = [part](const std::string& text) {
      return text.substr(0, static_cast<std::size_t>(part * static_cast<double>(text.size())));
    };
    EXPECT_NE(refusal(write_text(cut(step), "cut.step")), "") << part;
    EXPECT_NE(refusal(write_text(cut(iges), "cut.iges")), "") << part;
  }
}

TEST_F(ReadFile, AStepReferenceIntoNothingIsRefused) {
  std::string text = text_of(write_step(BRepPrimAPI_MakeCylinder(2, 5).Shape(), "a.step", "MM"));
  const std::size_t line = text.find("CIRCLE('',#");
  ASSERT_NE(line, std::string::npos);
  text.insert(line + 11, "9999");
  EXPECT_NE(refusal(write_text(text, "a.step")).find("damaged"), std::string::npos);
}

TEST_F(ReadFile, ThreadsMayReadAtOnce) {
  const std::string step = write_step(box(), "box.step", "INCH");
  const std::string iges = write_iges(box(), "box.iges", "MM");
  std::vector<std::thread> threads;
  std::vector<double> diagonals(8, 0.0);
  for (std::size_t i = 0; i < diagonals.size(); ++i) {
    threads.emplace_back(
        [&, i] { diagonals[i] = read_file(RunContext(), i % 2 ? step : iges).diagonal(); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const double diagonal : diagonals) EXPECT_NEAR(diagonal, 25.4 * std::sqrt(14.0), 1e-6);
}

// Properties that every sound model has, for a folder of files: set ADVLAYERS_MODELS to it.
TEST(ModelFiles, AreReadWholeAndCutSoundly) {
  const char* folder = std::getenv("ADVLAYERS_MODELS");
  if (!folder) GTEST_SKIP() << "ADVLAYERS_MODELS names no folder";
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::string ending = entry.path().extension().string();
    if (ending != ".step" && ending != ".stp" && ending != ".iges" && ending != ".brep") continue;
    const std::string name = entry.path().filename().string();
    const Model model = read_file(RunContext(), entry.path().string());
    Evaluator evaluator(model);
    Settings settings = test::coarse_settings();
    settings.size = 0.05 * model.diagonal();
    settings.first_height = 0.1 * settings.size;
    const Discretization cut = discretize(RunContext(), evaluator, settings);
    for (std::size_t f = 0; f < model.faces().size(); ++f) {
      const Face& face = model.faces()[f];
      EXPECT_EQ(face.defect.english(), "") << name << " Face" << f + 1;
      const Vec2 extent(face.u_max - face.u_min, face.v_max - face.v_min);
      for (const auto& loop : face.loops) {
        std::size_t segments = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const CoEdge &a = loop[i], &b = loop[(i + 1) % loop.size()];
          const Edge &ea = model.edge(a.edge), &eb = model.edge(b.edge);
          segments += cut.edges[a.edge.index()].nodes.size() - 1;
          const Vec2 end = evaluator.edge_uv(FaceId(f), a, a.forward ? ea.last : ea.first);
          const Vec2 begin = evaluator.edge_uv(FaceId(f), b, b.forward ? eb.first : eb.last);
          EXPECT_LT((end - begin).cwiseQuotient(extent).norm(), 1e-4) << name << " Face" << f + 1;
        }
        EXPECT_GE(segments, 3u) << name << " Face" << f + 1;
      }
    }
  }
}

}  // namespace
}  // namespace advlayers
