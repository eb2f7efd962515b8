// Lets OpenCASCADE's readers tell how far they are, and stop where a stop was asked for.
#pragma once

#include <Message_ProgressIndicator.hxx>

#include "base/run_context.h"

namespace advlayers {

// What a reader that was stopped gives is not whole: the context is to be checked after it.
class ReadProgress : public Message_ProgressIndicator {
  DEFINE_STANDARD_RTTI_INLINE(ReadProgress, Message_ProgressIndicator)

 public:
  explicit ReadProgress(const RunContext& context) : context_(context) {}

 protected:
  Standard_Boolean UserBreak() override { return context_.cancelled(); }
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {
    context_.tell_share(GetPosition());
  }

 private:
  const RunContext& context_;
};

}  // namespace advlayers
