#include "base/sentence.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace advlayers
