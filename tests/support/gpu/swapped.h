// Puts another function in the place of one of OpenGL's (gl/loader.h), until the end of the scope. Only while one
// context is current: making another one current fills all functions again.
#pragma once

namespace fascia::test {

template <class Function>
class Swapped {
 public:
  Swapped(Function& place, Function now) : place_(place), before_(place) { place = now; }
  ~Swapped() { place_ = before_; }
  Swapped(const Swapped&) = delete;
  Swapped& operator=(const Swapped&) = delete;
  Function before() const { return before_; }

 private:
  Function& place_;
  Function before_;
};

}  // namespace fascia::test
