// SPDX-License-Identifier: MIT
// How is a point kept once that a root and the proof of it both name? It is never changed, and
// belongs to all that hold it.
//
// Private to the module.
#pragma once

#include <initializer_list>
#include <memory>
#include <utility>

#include "moivre/numeric/complex.h"

namespace moivre {

/// Reads like a Point.
class SharedPoint {
 public:
  SharedPoint() = default;
  SharedPoint(Point x) : x_(std::make_shared<const Point>(std::move(x))) {}  // NOLINT: is a Point
  SharedPoint(std::initializer_list<Complex> x) : SharedPoint(Point(x)) {}
  explicit SharedPoint(std::shared_ptr<const Point> x) : x_(std::move(x)) {}

  const Point& point() const {
    static const Point kNowhere;
    return x_ ? *x_ : kNowhere;
  }
  operator const Point&() const { return point(); }  // NOLINT: is a Point

  std::size_t size() const { return point().size(); }
  Point::const_iterator begin() const { return point().begin(); }
  Point::const_iterator end() const { return point().end(); }
  const Complex& operator[](std::size_t j) const { return point()[j]; }
  friend bool operator==(const SharedPoint& a, const Point& b) { return a.point() == b; }

 private:
  std::shared_ptr<const Point> x_;
};

}  // namespace moivre
