#include "geometry/arrived_faces.h"

#include <BRepAdaptor_Surface.hxx>
#include <IFGraph_AllShared.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESGeom_BoundedSurface.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESSolid_Face.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_VertexLoop.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <set>

#include "geometry/occt_shape.h"

namespace advlayers {
namespace {

using Process = Handle(Transfer_TransientProcess);

// The faces of a shape, wherever they stand and whichever way they look.
class Arrived {
 public:
  explicit Arrived(const TopoDS_Shape& shape) {
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
      faces_.Add(plain(faces.Current()));
    }
  }

  // Which of `bounds` of an entity did not come with what was made of it: all of them, where there
  // is no face. A surface that is closed may join two of them with its seam.
  bool whole(const TopoDS_Shape& made, int bounds) const {
    int count = 0, wires = 0;
    bool closed = false;
    for (TopExp_Explorer faces(made, TopAbs_FACE); faces.More(); faces.Next(), ++count) {
      if (!faces_.Contains(plain(faces.Current()))) return false;
      const BRepAdaptor_Surface surface(TopoDS::Face(faces.Current()), Standard_False);
      closed = closed || surface.IsUClosed() || surface.IsVClosed() || surface.IsUPeriodic() ||
               surface.IsVPeriodic();
      for (TopExp_Explorer all(faces.Current(), TopAbs_WIRE); all.More(); all.Next()) ++wires;
    }
    return count > 0 && (closed || wires >= bounds);
  }

 private:
  static TopoDS_Shape plain(const TopoDS_Shape& face) {
    return face.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
  }

  TopTools_MapOfShape faces_;
};

int bounds_of(const Handle(StepShape_FaceSurface) & face) {
  int count = 0;
  for (int i = 1; i <= face->NbBounds(); ++i) {
    const Handle(StepShape_FaceBound) bound = face->BoundsValue(i);
    const bool point = bound.IsNull() || bound->Bound().IsNull() ||
                       bound->Bound()->IsKind(STANDARD_TYPE(StepShape_VertexLoop));
    count += !point;
  }
  return count;
}

// -1: it is no face.
int bounds_of(const Handle(Standard_Transient) & entity) {
  if (const auto trimmed = Handle(IGESGeom_TrimmedSurface)::DownCast(entity); !trimmed.IsNull()) {
    return trimmed->NbInnerContours() + (trimmed->HasOuterContour() ? 1 : 0);
  }
  if (const auto bounded = Handle(IGESGeom_BoundedSurface)::DownCast(entity); !bounded.IsNull()) {
    return bounded->NbBoundaries();
  }
  if (const auto face = Handle(IGESSolid_Face)::DownCast(entity); !face.IsNull()) {
    return face->NbLoops();
  }
  return -1;
}

// Those that are not to be seen, and what they are made of.
std::set<const Standard_Transient*> hidden_entities(IGESControl_Reader& reader) {
  IFGraph_AllShared found(reader.WS()->Graph());
  for (int i = 1; i <= reader.Model()->NbEntities(); ++i) {
    const auto entity = Handle(IGESData_IGESEntity)::DownCast(reader.Model()->Value(i));
    if (!entity.IsNull() && entity->BlankStatus() != 0) found.GetFromEntity(entity);
  }
  std::set<const Standard_Transient*> hidden;
  for (found.Begin(); found.More(); found.Next()) hidden.insert(found.Value().get());
  return hidden;
}

}  // namespace

void refuse_lost_faces(STEPControl_Reader& reader, const TopoDS_Shape& shape,
                       const StepText& text) {
  const auto model = Handle(StepData_StepModel)::DownCast(reader.WS()->Model());
  const Process process = reader.WS()->TransferReader()->TransientProcess();
  const Arrived arrived(shape);
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto face = Handle(StepShape_FaceSurface)::DownCast(model->Value(i));
    if (face.IsNull()) continue;
    const int id = model->IdentLabel(face);
    if (!text.needed(id) ||
        arrived.whole(TransferBRep::ShapeResult(process, face), bounds_of(face))) {
      continue;
    }
    throw InvalidInput("it is damaged: the face #{} or a bound of it could not be made", id);
  }
}

void refuse_lost_faces(IGESControl_Reader& reader, const TopoDS_Shape& shape) {
  const Process process = reader.WS()->TransferReader()->TransientProcess();
  const Handle(Interface_InterfaceModel) model = reader.Model();
  const Arrived arrived(shape);
  const std::set<const Standard_Transient*> hidden = hidden_entities(reader);
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    const int bounds = bounds_of(entity);
    if (bounds < 0 || hidden.count(entity.get()) != 0 ||
        arrived.whole(TransferBRep::ShapeResult(process, entity), bounds)) {
      continue;
    }
    throw InvalidInput("it is damaged: the face D{} or a bound of it could not be made", 2 * i - 1);
  }
}

}  // namespace advlayers
