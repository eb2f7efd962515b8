#include "geometry/foreign_readers.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <XSControl_WorkSession.hxx>
#include <sstream>

#include "geometry/arrived_faces.h"
#include "geometry/brep_text.h"
#include "geometry/occt_shape.h"
#include "geometry/read_progress.h"

namespace advlayers {

namespace {

// Takes the default messenger's printers away for a while.
class QuietMessenger {
 public:
  QuietMessenger() : printers_(Message::DefaultMessenger()->Printers()) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }
  ~QuietMessenger() { Message::DefaultMessenger()->ChangePrinters() = printers_; }
  QuietMessenger(const QuietMessenger&) = delete;
  QuietMessenger& operator=(const QuietMessenger&) = delete;

 private:
  Message_SequenceOfPrinters printers_;
};

// The reader's unit is a setting of the whole process, which another add-on may have changed.
void read_in_millimetres() { Interface_Static::SetCVal("xstep.cascade.unit", "MM"); }

// The translator follows references that did not resolve into a crash, or leaves out what they are
// part of. Faults elsewhere, in annotations and the like, cost nothing.
void refuse_unread_entities(STEPControl_Reader& reader, const StepText& text) {
  const auto model = Handle(StepData_StepModel)::DownCast(reader.WS()->Model());
  Interface_CheckIterator checks = reader.WS()->ModelCheckList(Standard_False);
  for (checks.Start(); checks.More(); checks.Next()) {
    const Handle(Interface_Check)& fault = checks.Value();
    if (fault->NbFails() == 0 || checks.Number() < 1 || checks.Number() > model->NbEntities()) {
      continue;
    }
    const Handle(Standard_Transient) entity = model->Value(checks.Number());
    const std::string type = entity->DynamicType()->Name();
    if (type.rfind("StepGeom_", 0) != 0 && type.rfind("StepShape_", 0) != 0) continue;
    const int id = model->IdentLabel(entity);
    if (!text.needed(id)) continue;
    throw InvalidInput("it is damaged: #{} ({}) cannot be read: {}", id,
                       type.substr(type.find('_') + 1), fault->CFail(1));
  }
}

}  // namespace

std::mutex& reader_mutex() {
  static std::mutex mutex;
  return mutex;
}

TopoDS_Shape shape_of_brep(const RunContext& context, const std::string& text) {
  check_brep_text(text);
  TopoDS_Shape shape;
  std::istringstream stream(text);
  BRep_Builder builder;
  const QuietMessenger quiet;
  try {
    const Handle(ReadProgress) progress = new ReadProgress(context);
    BRepTools::Read(shape, stream, builder, progress->Start());
  } catch (const Standard_Failure&) {
    shape.Nullify();
  }
  context.check();
  return shape;
}

std::string brep_of_shape(const TopoDS_Shape& shape) {
  std::ostringstream text;
  BRepTools::Write(shape, text);
  return text.str();
}

bool is_binary_brep(const std::string& bytes) {
  const std::size_t begin = bytes.find_first_not_of("\r\n");
  return begin != std::string::npos && bytes.compare(begin, 21, "Open CASCADE Topology") == 0;
}

TopoDS_Shape shape_of_binary_brep(const std::string& bytes) {
  TopoDS_Shape shape;
  std::istringstream stream(bytes);
  const QuietMessenger quiet;
  try {
    BinTools::Read(shape, stream);
  } catch (const Standard_Failure&) {
    shape.Nullify();
  }
  return shape;
}

TopoDS_Shape shape_of_step(const std::string& path, const StepText& text) {
  STEPControl_Controller::Init();
  read_in_millimetres();
  STEPControl_Reader reader;
  const QuietMessenger quiet;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) return {};
  refuse_unread_entities(reader, text);
  reader.TransferRoots();
  TopoDS_Shape shape = reader.OneShape();
  refuse_lost_faces(reader, shape, text);
  return shape;
}

TopoDS_Shape shape_of_iges(const std::string& path) {
  IGESControl_Controller::Init();
  read_in_millimetres();
  IGESControl_Reader reader;
  reader.SetReadVisible(Standard_True);  // construction geometry stays out, as in FreeCAD
  const QuietMessenger quiet;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) return {};
  reader.TransferRoots();
  TopoDS_Shape shape = reader.OneShape();
  refuse_lost_faces(reader, shape);
  return shape;
}

}  // namespace advlayers
