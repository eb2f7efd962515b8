#include "base/number_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "base/error.h"

namespace advlayers {
namespace {

// Of all magnitudes that lengths have, and of digits that no decimal text ends.
std::vector<double> samples() {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> mantissa(-10.0, 10.0);
  std::uniform_int_distribution<int> power(-14, 9);
  std::vector<double> values{0.0,      -0.0, 1.0, -1.0, 0.5, 9.9999999999999999e-5,
                             123456.0, 1e15, 1e22};
  for (int i = 0; i < 5000; ++i) values.push_back(mantissa(random) * std::pow(10.0, power(random)));
  return values;
}

template <class Number>
NumberColumn column(const std::vector<Number>& values, NumberColumn::Type type) {
  return {values.data(), sizeof(Number), type};
}

std::string one_row(const char* form, double value) {
  std::string text;
  RowForm(form).append({{&value, sizeof value, NumberColumn::Type::Double}}, 1, text);
  return text;
}

TEST(NumberRows, PrintsAsPrintfDoes) {
  for (const double value : samples()) {
    char expected[64];
    std::snprintf(expected, sizeof expected, "%25.16E", value);
    EXPECT_EQ(one_row("%25.16E", value), expected);
  }
  const std::vector<std::int32_t> small{1, -20, 2147483647};
  const std::vector<std::int64_t> large{5, 1234567890123, -7};
  std::string text;
  RowForm("%5d:%d%%\n")
      .append({column(small, NumberColumn::Type::Int32), column(large, NumberColumn::Type::Int64)},
              3, text);
  EXPECT_EQ(text, "    1:5%\n  -20:1234567890123%\n2147483647:-7%\n");
}

TEST(NumberRows, TheShortestFormIsExact) {
  for (const double value : samples()) {
    EXPECT_EQ(std::strtod(one_row("%r", value).c_str(), nullptr), value);
  }
}

TEST(NumberRows, AFittedNumberKeepsItsWidthAndItsDigits) {
  for (const double value : samples()) {
    for (const int width : {16, 20}) {
      const std::string text = fitted(value, width);
      EXPECT_LE(text.size(), static_cast<std::size_t>(width));
      EXPECT_NE(text.find('.'), std::string::npos) << text;
      // A sign, a point and an exponent of four characters leave ten digits of sixteen.
      const double digits = std::pow(10.0, -(width - 7));
      EXPECT_NEAR(std::strtod(text.c_str(), nullptr), value, digits * std::abs(value)) << text;
    }
    EXPECT_EQ(one_row("%16w", value).size(), 16u);
  }
  EXPECT_EQ(fitted(-0.125, 16), "-.125");
  EXPECT_EQ(fitted(3.0, 16), "3.");
}

TEST(NumberRows, RefusesWhatDoesNotFit) {
  EXPECT_THROW(RowForm("%5x"), InternalError);
  EXPECT_THROW(RowForm("%"), InternalError);
  EXPECT_THROW(RowForm("%4w"), InternalError);
  std::string text;
  EXPECT_THROW(RowForm("%d").append({}, 0, text), InternalError);
  const std::vector<double> reals{1.0};
  EXPECT_THROW(RowForm("%d").append({column(reals, NumberColumn::Type::Double)}, 1, text),
               InternalError);
  EXPECT_THROW(RowForm("x").append({column(reals, NumberColumn::Type::Double)}, 1, text),
               InternalError);
}

}  // namespace
}  // namespace advlayers
