#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <algorithm>
#include <cctype>
#include <fstream>
#include <mutex>
#include <sstream>

#include "geometry/occt_shape.h"

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

std::string ending_of(const std::string& path) {
  const std::size_t dot = path.find_last_of('.');
  const std::size_t slash = path.find_last_of("/\\");
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
  std::string ending = path.substr(dot + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

TopoDS_Shape parse_brep(const std::string& text) {
  TopoDS_Shape shape;
  // The reader skips to the version line, to the end of the text where there is none.
  if (text.find("CASCADE Topology V") == std::string::npos) return shape;
  std::istringstream stream(text);
  BRep_Builder builder;
  const std::lock_guard<std::mutex> lock(reader_mutex());
  const QuietMessenger quiet;
  try {
    BRepTools::Read(shape, stream, builder);
  } catch (const Standard_Failure&) {
    shape.Nullify();
  }
  return shape;
}

template <class Reader>
TopoDS_Shape transfer(Reader& reader, const std::string& path) {
  const std::lock_guard<std::mutex> lock(reader_mutex());
  const QuietMessenger quiet;
  // Lengths come out in mm, whatever the file says and another add-on has set.
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) return {};
  reader.TransferRoots();
  return reader.OneShape();
}

TopoDS_Shape read_step(const std::string& path) {
  STEPControl_Controller::Init();
  STEPControl_Reader reader;
  return transfer(reader, path);
}

TopoDS_Shape read_iges(const std::string& path) {
  IGESControl_Controller::Init();
  IGESControl_Reader reader;
  reader.SetReadVisible(Standard_True);  // construction geometry stays out, as in FreeCAD
  return transfer(reader, path);
}

Model model_of(const TopoDS_Shape& root) {
  auto shape = std::make_unique<Model::Shape>();
  shape->root = root;
  return build_model(std::move(shape));
}

}  // namespace

Model read_brep(const std::string& text) {
  const TopoDS_Shape root = parse_brep(text);
  if (root.IsNull()) throw InvalidInput("the text is no BREP shape");
  return model_of(root);
}

Model read_file(const std::string& path) {
  const std::string ending = ending_of(path);
  const bool brep = ending == "brep" || ending == "brp";
  const bool step = ending == "step" || ending == "stp";
  const bool iges = ending == "iges" || ending == "igs";
  if (!brep && !step && !iges) {
    throw InvalidInput(path + ": the ending is none of .step .stp .iges .igs .brep .brp");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InvalidInput(path + ": the file cannot be opened");
  TopoDS_Shape root;
  if (brep) {
    std::ostringstream text;
    text << file.rdbuf();
    root = parse_brep(text.str());
  } else {
    root = translated(path.c_str(), [&] { return step ? read_step(path) : read_iges(path); });
  }
  if (root.IsNull()) {
    throw InvalidInput(path + ": no shape could be read, it is no " +
                       (brep   ? "BREP"
                        : step ? "STEP"
                               : "IGES") +
                       " file or holds none");
  }
  try {
    return model_of(root);
  } catch (const GeometryError& error) {
    throw GeometryError(path + ": " + error.what());
  }
}

}  // namespace advlayers
