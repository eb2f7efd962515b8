#include "base/sentence.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace advlayers {
namespace {

TEST(Sentence, FillsItsFormInOrder) {
  const Sentence said("{} on {} got {} of {} layers, up to {} %", "Edge1", std::string("Face2"), 3,
                      5, 1.5);
  EXPECT_EQ(said.english(), "Edge1 on Face2 got 3 of 5 layers, up to 1.5 %");
  EXPECT_EQ(said.values().size(), 5u);
}

TEST(Sentence, KeepsBracesOfValues) {
  EXPECT_EQ(Sentence("{}: {}", "a {} b", "c").english(), "a {} b: c");
}

TEST(Sentence, SaysTheSameAboutSomethingElse) {
  const Sentence form("left out: {}");
  EXPECT_EQ(form.about("Face1").english(), "left out: Face1");
  EXPECT_EQ(form.about("Face1").form(), form.form());
}

TEST(Sentence, MayHoldOthers) {
  Sentence said("{}: {}", "Edge1", Sentence("{} and {}", "Edge2", 3));
  EXPECT_EQ(said.english(), "Edge1: Edge2 and 3");
  said.change([](const std::string& text) { return text == "3" ? text : text + "b"; });
  EXPECT_EQ(said.english(), "Edge1b: Edge2b and 3");
  EXPECT_EQ(said.values()[1].sentence.form(), "{} and {}");
}

TEST(Sentence, IsWhatAnErrorSays) {
  const InvalidInput error("{} must be {}, got {}", "size", Sentence("> 0 mm"), -1.5);
  EXPECT_STREQ(error.what(), "size must be > 0 mm, got -1.5");
  EXPECT_EQ(error.sentence().form(), "{} must be {}, got {}");
}

}  // namespace
}  // namespace advlayers
