#include "geometry/step_text.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace advlayers {
namespace {

// A made-up shape: a shell of one face with a bound, a surface, and a note that nobody needs.
std::string file(const std::string& data) {
  return "ISO-10303-21;\nHEADER;\nFILE_NAME('a;b',(''));\nENDSEC;\nDATA;\n" + data +
         "ENDSEC;\nEND-ISO-10303-21;\n";
}

const std::string kRoot = "#1=SHAPE_REPRESENTATION('it''s; #99',(#2),#9);\n";
const std::string kShell = "#2=OPEN_SHELL('',(#3));\n";
const std::string kFace = "#3 = ADVANCED_FACE ( '' , ( #4 ) , #6 , .T. ) ;\n";
const std::string kBound = "#4=FACE_BOUND('',#5,.T.);\n#5=EDGE_LOOP('',(#7));\n";
const std::string kRest =
    "#6=PLANE('',#9);\n#7=ORIENTED_EDGE('',*,*,#9,.T.);\n/* #98; */\n"
    "#9=( GEOMETRIC_REPRESENTATION_CONTEXT(3) REPRESENTATION_CONTEXT('',''));\n";
const std::string kNote = "#20=DRAUGHTING_CALLOUT('',(#97));\n";

std::string refusal(const std::string& text) {
  try {
    StepText read(text);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(StepText, AWholeFilePasses) {
  const std::string text = file(kRoot + kShell + kFace + kBound + kRest + kNote);
  const StepText read(text);
  EXPECT_EQ(read.faces(), 1u);
  EXPECT_TRUE(read.needed(9));
  EXPECT_FALSE(read.needed(20));
}

TEST(StepText, WhatTheShapeNeedsMustBeThere) {
  EXPECT_NE(refusal(file(kRoot + kShell + kBound + kRest)).find("#3"), std::string::npos);
  EXPECT_NE(refusal(file(kRoot + kShell + kFace + kRest)).find("#4"), std::string::npos);
}

TEST(StepText, AFaceOfNoShellIsNamed) {
  const std::string other = "#8=ADVANCED_FACE('',(),#6,.T.);\n";
  const std::string said = refusal(file(kRoot + kShell + kFace + kBound + kRest + other));
  EXPECT_NE(said.find("#8"), std::string::npos) << said;
}

TEST(StepText, ANumberIsGivenOnce) {
  EXPECT_NE(refusal(file(kRoot + kShell + kShell + kFace + kBound + kRest)).find("#2"),
            std::string::npos);
}

TEST(StepText, DamagedEntitiesAreNamedByTheirLine) {
  for (const char* bad : {"#2 OPEN_SHELL('',(#3));", "2=OPEN_SHELL('',(#3));",
                          "#2=OPEN_SHELL('',(#3);", "#2=OPEN_SHELL('',(#));", "#2=('',(#3));"}) {
    const std::string text = file(kRoot + bad + "\n" + kFace + kBound + kRest);
    EXPECT_NE(refusal(text).find("line 7"), std::string::npos) << bad << ": " << refusal(text);
  }
}

TEST(StepText, EveryCutIsSeen) {
  const std::string text = file(kRoot + kShell + kFace + kBound + kRest);
  for (std::size_t n = 0; n < text.find("ENDSEC;\nEND-ISO") + 7; ++n) {
    EXPECT_NE(refusal(text.substr(0, n)), "") << n;
  }
}

}  // namespace
}  // namespace advlayers
