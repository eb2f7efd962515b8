// The records of curves and surfaces in BREP text, as OpenCASCADE's "BRep Format" paper lists them.
// What its constructors refuse is refused here: its readers turn that into null geometry.
#pragma once

#include <array>
#include <limits>

#include "geometry/brep_scanner.h"

namespace advlayers {

class BrepGeometryGrammar {
 public:
  // The parameter range of a curve, or of a surface in one direction.
  struct Span {
    double first = -std::numeric_limits<double>::infinity();
    double last = std::numeric_limits<double>::infinity();
    bool periodic = false;
  };

  explicit BrepGeometryGrammar(BrepScanner& in) : in_(in) {}

  // Each reads one record. Throws InvalidInput.
  Span curve(int dimension);
  std::array<Span, 2> surface();

 private:
  struct Direction {
    double x = 0, y = 0, z = 0;
  };
  Direction direction(std::size_t dimension);
  void expect_apart(const Direction& a, const Direction& b);
  void placement(std::size_t dimension);
  void placement_with_axis();
  double radius();
  void descending_radii();
  void half_angle();
  Span trimmed(const Span& basis, double first, double last);
  int degree();
  void poles(int count, std::size_t dimension, bool rational);
  Span bezier(std::size_t dimension);
  Span bspline(std::size_t dimension);
  Span knots(int count, int poles, int p, bool periodic);
  std::array<Span, 2> bezier_surface();
  std::array<Span, 2> bspline_surface();

  BrepScanner& in_;
};

}  // namespace advlayers
