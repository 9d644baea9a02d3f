// SPDX-License-Identifier: MIT
// How do lists of the library become numpy's arrays? One number an item, or a row of numbers an
// item.
#pragma once

#include <pybind11/numpy.h>

#include <optional>
#include <vector>

#include "moivre/numeric/complex.h"

namespace moivre::python {

/// read(item), a number each.
template <class Number, class List, class Read>
pybind11::array_t<Number> column(const List& items, Read read) {
  pybind11::array_t<Number> array(static_cast<pybind11::ssize_t>(items.size()));
  Number* to = array.mutable_data();
  for (const auto& item : items) *to++ = static_cast<Number>(read(item));
  return array;
}

/// read(item), a list of `width` numbers each: shape (items, width).
template <class Number, class List, class Read>
pybind11::array_t<Number> rows(const List& items, std::size_t width, Read read) {
  pybind11::array_t<Number> array(std::vector<pybind11::ssize_t>{
      static_cast<pybind11::ssize_t>(items.size()), static_cast<pybind11::ssize_t>(width)});
  Number* to = array.mutable_data();
  for (const auto& item : items) {
    const auto& row = read(item);
    for (std::size_t k = 0; k < width; ++k) {
      *to++ = row[static_cast<std::remove_cvref_t<decltype(row.size())>>(k)];
    }
  }
  return array;
}

/// True, False or None.
inline pybind11::object optional_bool(const std::optional<bool>& value) {
  if (!value) return pybind11::none();
  return pybind11::bool_(*value);
}

}  // namespace moivre::python
