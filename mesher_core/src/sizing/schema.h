// The settings as rows: what each is called, what it takes, and what it is for. The checks, the
// bindings, the properties, the widgets, the keys of jobs and the reference page follow them.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/sentence.h"
#include "sizing/settings.h"

namespace advlayers {

// What values a setting takes; kind_name() has the names for Python.
enum class Kind {
  kNumber,
  kCount,
  kFlag,
  kPoint,
  kEdges,
  kFaces,     // a list
  kAllFaces,  // or all of them
  kLayers,
  kChoice,
  kWalls,
  kSizes,
  kRefinements,
  kPeriodic,
  kInitialMesh,
};

const char* kind_name(Kind kind);

inline constexpr double kMostGrowth = 10.0;  // the second layer would be the last that is seen
inline constexpr int kMostLayers = 100000;   // no mesh that any machine holds has more

struct Range {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool above = false;  // the lowest itself is not allowed
  bool below = false;  // nor the highest

  bool holds(double value) const;
  Sentence said(const std::string& unit) const;  // "> 0 and <= 90 deg"
};

// Where the value lies; nowhere: a value of its own kind, which the bindings know how to set.
template <class Owner>
using Member = std::variant<std::monostate, double Owner::*, std::optional<double> Owner::*,
                            int Owner::*, std::optional<int> Owner::*, bool Owner::*, Vec3 Owner::*,
                            std::optional<Vec3> Owner::*, std::vector<EdgeId> Owner::*,
                            std::vector<FaceId> Owner::*, CoreElements Owner::*,
                            OtherEdges Owner::*, Distribution Owner::*>;

template <class Owner>
struct Row {
  const char* key;
  Kind kind;
  const char* unit;  // "mm", "deg", or none
  Range range;
  const char* doc;  // a sentence or two: tooltip and reference page
  Member<Owner> member;
  bool required = false;
  std::array<const char*, 4> choices = {};  // the names of an enumeration, in its order

  std::vector<const char*> names() const {
    return {choices.begin(), std::find(choices.begin(), choices.end(), nullptr)};
  }
  // The number there, if any: what the range is about.
  std::optional<double> number(const Owner& owner) const;
};

const std::vector<Row<Settings>>& mesh_rows();
const std::vector<Row<WallSpec>>& wall_rows();
const std::vector<Row<SizeSpec>>& size_rows();
const std::vector<Row<Refinement>>& refinement_rows();
const std::vector<Row<PeriodicSpec>>& periodic_rows();

// Throws InvalidInput for the first number out of its row's range; `list` ("sizes: ") goes before
// its key, `where` ("Edge7") behind the value.
template <class Owner>
void check_ranges(const Owner& owner, const std::vector<Row<Owner>>& rows,
                  const std::string& list = "", const std::string& where = "");

// Throws InvalidInput: "growth must be >= 1, got 0.5 (Edge7)".
[[noreturn]] void refuse_value(const std::string& name, const Sentence& rule, double value,
                               const std::string& where = "");

// --- of the templates
// -----------------------------------------------------------------------------

template <class Owner>
std::optional<double> Row<Owner>::number(const Owner& owner) const {
  return std::visit(
      [&owner](auto place) -> std::optional<double> {
        using Place = decltype(place);
        if constexpr (std::is_same_v<Place, double Owner::*> ||
                      std::is_same_v<Place, int Owner::*>) {
          return owner.*place;
        } else if constexpr (std::is_same_v<Place, std::optional<double> Owner::*> ||
                             std::is_same_v<Place, std::optional<int> Owner::*>) {
          return owner.*place;
        } else {
          return std::nullopt;
        }
      },
      member);
}

template <class Owner>
void check_ranges(const Owner& owner, const std::vector<Row<Owner>>& rows, const std::string& list,
                  const std::string& where) {
  for (const Row<Owner>& row : rows) {
    const std::optional<double> value = row.number(owner);
    if (value && !row.range.holds(*value)) {
      refuse_value(list + row.key, row.range.said(row.unit), *value, where);
    }
  }
}

}  // namespace advlayers
