// Half-edges that follow each other in a ring, to loop over.
#pragma once

#include "mesh/mesh_types.h"

namespace advlayers {

// From `first` on, each half-edge once; none where `first` is invalid. `Step` is taken after the
// body of the loop: a body that changes the ring itself leaves the loop.
template <class Mesh, HalfedgeH (Mesh::*Step)(HalfedgeH) const>
class Ring {
 public:
  struct End {};
  class Iterator {
   public:
    Iterator(const Mesh& mesh, HalfedgeH first) : mesh_(&mesh), first_(first), at_(first) {}
    HalfedgeH operator*() const { return at_; }
    Iterator& operator++() {
      at_ = (mesh_->*Step)(at_);
      if (at_ == first_) at_ = HalfedgeH();
      return *this;
    }
    bool operator!=(End) const { return at_.valid(); }

   private:
    const Mesh* mesh_;
    HalfedgeH first_, at_;
  };

  Ring(const Mesh& mesh, HalfedgeH first) : begin_(mesh, first) {}
  Iterator begin() const { return begin_; }
  End end() const { return {}; }

 private:
  Iterator begin_;
};

}  // namespace advlayers
