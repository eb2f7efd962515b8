#include "geometry/brep_text.h"

#include <array>

#include "geometry/brep_geometry_grammar.h"
#include "geometry/brep_scanner.h"

namespace advlayers {

namespace {

class BrepGrammar {
 public:
  BrepGrammar(const std::string& text, std::size_t begin, int version)
      : in_(text, begin), version_(version) {}

  void read() {
    read_locations();
    BrepGeometryGrammar geometry(in_);
    const auto table = [&](const char* name, auto&& record) {
      in_.keyword(name);
      const int n = in_.count();
      for (int i = 0; i < n; ++i) record();
      return n;
    };
    curves2d_ = table("Curve2ds", [&] { geometry.curve(2); });
    curves_ = table("Curves", [&] { geometry.curve(3); });
    table("Polygon3D", [&] { read_polygon(); });
    table("PolygonOnTriangulations", [&] { read_polygon_on_triangulation(); });
    surfaces_ = table("Surfaces", [&] { geometry.surface(); });
    triangulations_ = table("Triangulations", [&] { read_triangulation(); });
    read_shapes();
  }

 private:
  void read_locations() {
    in_.keyword("Locations");
    const int n = in_.count();
    for (locations_ = 0; locations_ < n; ++locations_) {
      if (in_.integer(1, 2, "a location is of no known type") == 1) {
        in_.reals(12);
        continue;
      }
      while (const int index = location()) {
        in_.integer(-1000000, 1000000, "the power of a location is wrong");
        in_.expect(index > 0, "a location refers to none");
      }
    }
  }

  void read_polygon() {
    const auto n = static_cast<std::size_t>(in_.count(2));
    const bool parameters = in_.flag();
    in_.reals(1 + 3 * n + (parameters ? n : 0));
  }

  void read_polygon_on_triangulation() {
    const int n = in_.count(2);
    for (int i = 0; i < n; ++i) in_.count(1);
    in_.keyword("p");
    in_.real();
    if (in_.flag()) in_.reals(static_cast<std::size_t>(n));
  }

  void read_triangulation() {
    const int nodes = in_.count(3), triangles = in_.count(1);
    const bool uv = in_.flag(), normals = version_ >= 3 && in_.flag();
    const auto n = static_cast<std::size_t>(nodes);
    in_.reals(1 + (uv ? 5 : 3) * n);
    for (int i = 0; i < 3 * triangles; ++i) in_.integer(1, nodes, "a triangle leaves its nodes");
    if (normals) in_.reals(3 * n);
  }

  int location() { return in_.integer(0, locations_, "there is no such location"); }
  void curve2d() { in_.integer(0, curves2d_, "there is no such curve in (u, v)"); }
  void curve3d() { in_.integer(0, curves_, "there is no such curve"); }
  void surface() { in_.integer(0, surfaces_, "there is no such surface"); }
  void regularity() {
    const char family = in_.letter();
    in_.letter();
    in_.expect(family == 'C' || family == 'G', "a continuity is missing");
  }

  void read_shapes() {
    in_.keyword("TShapes");
    const int n = in_.count(1);
    for (int i = 1; i <= n; ++i) {
      read_geometry(in_.word());
      const std::string flags = in_.word();
      const bool sound = flags.size() == 7 && flags.find_first_not_of("01") == std::string::npos;
      in_.expect(sound, "the flags of a shape are missing");
      while (reference(n, i)) continue;
    }
    in_.expect(reference(n, n + 1), "the shape itself is missing");
  }

  // A sub-shape of the shape number `reader`: counted from the end, and read before. False at the
  // end of the list.
  bool reference(int shapes, int reader) {
    const char orientation = in_.letter();
    if (orientation == '*') return false;
    in_.expect(std::strchr("+-ie", orientation) != nullptr, "an orientation is missing");
    in_.integer(shapes - reader + 2, shapes, "a sub-shape is not there");
    location();
    return true;
  }

  void read_geometry(const std::string& type) {
    if (type == "Ve") {
      read_vertex();
    } else if (type == "Ed") {
      read_edge();
    } else if (type == "Fa") {
      read_face();
    } else {
      const bool known =
          type == "Wi" || type == "Sh" || type == "So" || type == "CS" || type == "Co";
      in_.expect(known, "a shape is of no known type");
    }
  }

  void read_vertex() {
    in_.reals(4);
    while (true) {
      in_.real();
      const int kind = in_.integer(0, 3, "a point is represented in no known way");
      if (kind == 0) return;
      if (kind == 1) curve3d();
      if (kind == 2) curve2d();
      if (kind == 3) in_.real();
      if (kind > 1) surface();
      location();
    }
  }

  void read_edge() {
    in_.real();
    for (int i = 0; i < 3; ++i) in_.flag();
    while (const int kind = in_.integer(0, 7, "an edge is represented in no known way")) {
      if (kind <= 3) {
        read_edge_curve(kind);
      } else if (kind == 4) {
        regularity();
        for (int i = 0; i < 2; ++i) {
          surface();
          location();
        }
      } else {
        for (int i = kind == 5 ? 0 : kind == 6 ? -1 : -2; i <= 0; ++i) in_.count();
        location();
      }
    }
  }

  void read_edge_curve(int kind) {
    if (kind == 1) {
      curve3d();
    } else {
      curve2d();
      if (kind == 3) {
        curve2d();
        regularity();
      }
      surface();
    }
    location();
    in_.reals(kind > 1 && version_ == 2 ? 6 : 2);
  }

  void read_face() {
    const int kind = in_.integer(0, 2, "a face is of no known kind");
    if (kind < 2) {
      in_.real();
      surface();
      location();
      if (in_.peek_word() != "2") return;
      in_.word();
    }
    in_.integer(1, triangulations_, "there is no such triangulation");
  }

  BrepScanner in_;
  int version_;
  int locations_ = 0, curves2d_ = 0, curves_ = 0, surfaces_ = 0, triangulations_ = 0;
};

}  // namespace

void check_brep_text(const std::string& text) {
  static constexpr std::array<const char*, 3> kVersions{"CASCADE Topology V1, (c) Matra-Datavision",
                                                        "CASCADE Topology V2, (c) Matra-Datavision",
                                                        "CASCADE Topology V3, (c) Open Cascade"};
  for (std::size_t i = 0; i < kVersions.size(); ++i) {
    const std::size_t found = text.find(kVersions[i]);
    if (found == std::string::npos) continue;
    BrepGrammar(text, found + std::strlen(kVersions[i]), static_cast<int>(i) + 1).read();
    return;
  }
  throw InvalidInput("the text is no BREP shape: it lacks the line {}",
                     "\"CASCADE Topology V...\"");
}

}  // namespace advlayers
