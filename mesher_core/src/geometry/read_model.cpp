#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
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
#include <TCollection_HAsciiString.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>

#include "geometry/brep_text.h"
#include "geometry/child_process.h"
#include "geometry/occt_shape.h"
#include "geometry/read_progress.h"
#include "geometry/sew_shape.h"

namespace advlayers {

namespace {

// OpenCASCADE's exchange readers share static registers and print to the default messenger.
std::mutex& reader_mutex() {
  static std::mutex mutex;
  return mutex;
}

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

// Lengths come out in mm, whatever another add-on has set; its setting is put back.
class Millimetres {
 public:
  Millimetres() : before_(Interface_Static::CVal(kUnit)) { Interface_Static::SetCVal(kUnit, "MM"); }
  ~Millimetres() { Interface_Static::SetCVal(kUnit, before_.c_str()); }
  Millimetres(const Millimetres&) = delete;
  Millimetres& operator=(const Millimetres&) = delete;

 private:
  static constexpr const char* kUnit = "xstep.cascade.unit";
  std::string before_;
};

std::string ending_of(const std::string& path) {
  const std::size_t dot = path.find_last_of('.');
  const std::size_t slash = path.find_last_of("/\\");
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
  std::string ending = path.substr(dot + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

TopoDS_Shape parse_brep(const RunContext& context, const std::string& text) {
  check_brep_text(text);
  TopoDS_Shape shape;
  std::istringstream stream(text);
  BRep_Builder builder;
  const std::lock_guard<std::mutex> lock(reader_mutex());
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

// Runs the reader, the reader's mutex held; `check` looks at what was loaded before it is turned
// into a shape.
template <class Reader, class Check>
TopoDS_Shape transfer(const RunContext& context, Reader& reader, const std::string& path,
                      Check&& check) {
  const QuietMessenger quiet;
  const Millimetres millimetres;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) return {};
  context.check();
  check(reader);
  const Handle(ReadProgress) progress = new ReadProgress(context);
  reader.TransferRoots(progress->Start());
  context.check();
  return reader.OneShape();
}

// The translator follows references that did not resolve into a crash. Faults elsewhere, in
// annotations and the like, cost nothing.
void refuse_damaged_geometry(STEPControl_Reader& reader, const std::string& path) {
  const Handle(Interface_InterfaceModel) model = reader.WS()->Model();
  Interface_CheckIterator checks = reader.WS()->ModelCheckList(Standard_False);
  for (checks.Start(); checks.More(); checks.Next()) {
    const Handle(Interface_Check)& fault = checks.Value();
    if (fault->NbFails() == 0 || checks.Number() < 1 || checks.Number() > model->NbEntities()) {
      continue;
    }
    const Handle(Standard_Transient) entity = model->Value(checks.Number());
    const std::string type = entity->DynamicType()->Name();
    if (type.rfind("StepGeom_", 0) != 0 && type.rfind("StepShape_", 0) != 0) continue;
    throw InvalidInput("{}: the STEP file is damaged: {} {}: {}", path,
                       model->StringLabel(entity)->ToCString(), type.substr(type.find('_') + 1),
                       fault->CFail(1));
  }
}

TopoDS_Shape read_step(const RunContext& context, const std::string& path) {
  const std::lock_guard<std::mutex> lock(reader_mutex());
  STEPControl_Controller::Init();
  STEPControl_Reader reader;
  return transfer(context, reader, path,
                  [&](STEPControl_Reader& loaded) { refuse_damaged_geometry(loaded, path); });
}

TopoDS_Shape transfer_iges(const RunContext& context, const std::string& path) {
  IGESControl_Controller::Init();
  IGESControl_Reader reader;
  reader.SetReadVisible(Standard_True);  // construction geometry stays out, as in FreeCAD
  return transfer(context, reader, path, [](IGESControl_Reader&) {});
}

// The last line of a file of fixed-length records counts the records of each section, by the letter
// in column 73: the reader crashes on one that was cut off.
void refuse_cut_off_iges(const std::string& text, const std::string& path) {
  constexpr std::size_t kLetter = 72;
  std::istringstream lines(text);
  std::map<char, int> counted;
  std::string line, last;
  while (std::getline(lines, line)) {
    if (line.size() <= kLetter) continue;
    ++counted[line[kLetter]];
    if (line[kLetter] == 'T') last = line;
  }
  if (counted.count('C') != 0) return;  // the compressed form has no fixed records
  bool whole = !last.empty();
  for (std::size_t field = 0; whole && field < 4; ++field) {
    const int promised = std::atoi(last.substr(8 * field + 1, 7).c_str());
    whole = promised <= counted[last[8 * field]];
  }
  if (!whole) throw InvalidInput("{}: the IGES file is cut off, or is none", path);
}

TopoDS_Shape read_iges(const RunContext& context, const std::string& path,
                       const std::string& text) {
  refuse_cut_off_iges(text, path);
  check_file(path);
  const std::lock_guard<std::mutex> lock(reader_mutex());
  return transfer_iges(context, path);
}

// A translator that fails leaves no shape: the file's fault, not that of a shape in it.
template <class Read>
TopoDS_Shape read_exchange(const std::string& path, Read&& read) {
  try {
    return translated(path.c_str(), read);
  } catch (const GeometryError& error) {
    throw InvalidInput(error.sentence());
  }
}

TopoDS_Shape parse_brep_file(const RunContext& context, const std::string& text,
                             const std::string& path) {
  try {
    return parse_brep(context, text);
  } catch (const InvalidInput& error) {
    throw InvalidInput("{}: {}", path, error.sentence());
  }
}

Model model_of(const RunContext& context, const TopoDS_Shape& root, double sew_tolerance) {
  auto shape = std::make_unique<Model::Shape>();
  shape->root = root;
  if (sew_tolerance > 0.0) sew_shape(context, *shape, sew_tolerance);
  return build_model(context, std::move(shape));
}

}  // namespace

Model read_brep(const RunContext& context, const std::string& text, double sew_tolerance) {
  const StageScope stage(context, RunStage::kRead);
  const TopoDS_Shape root = parse_brep(context, text);
  if (root.IsNull()) throw InvalidInput("the text is no BREP shape");
  return model_of(context, root, sew_tolerance);
}

void check_file(const std::string& path) {
  const std::string ending = ending_of(path);
  if (ending != "iges" && ending != "igs") return;
  // Held here, as the copy would wait for ever for a thread that it has not.
  const std::lock_guard<std::mutex> lock(reader_mutex());
  if (!survives([&] { transfer_iges(RunContext(), path); })) {
    throw InvalidInput("{}: the IGES file is damaged: OpenCASCADE's reader crashes on it", path);
  }
}

Model read_file(const RunContext& context, const std::string& path, double sew_tolerance) {
  const StageScope stage(context, RunStage::kRead);
  const std::string ending = ending_of(path);
  const bool brep = ending == "brep" || ending == "brp";
  const bool step = ending == "step" || ending == "stp";
  const bool iges = ending == "iges" || ending == "igs";
  if (!brep && !step && !iges) {
    throw InvalidInput("{}: the ending is none of {}", path, ".step .stp .iges .igs .brep .brp");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InvalidInput("{}: the file cannot be opened", path);
  TopoDS_Shape root;
  if (step) {
    root = read_exchange(path, [&] { return read_step(context, path); });
  } else {
    std::ostringstream text;
    text << file.rdbuf();
    root = brep ? parse_brep_file(context, text.str(), path)
                : read_exchange(path, [&] { return read_iges(context, path, text.str()); });
  }
  if (root.IsNull()) {
    throw InvalidInput("{}: no shape could be read, it is no {} file or holds none", path,
                       brep   ? "BREP"
                       : step ? "STEP"
                              : "IGES");
  }
  try {
    return model_of(context, root, sew_tolerance);
  } catch (const GeometryError& error) {
    throw GeometryError("{}: {}", path, error.sentence());
  }
}

}  // namespace advlayers
