// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace nanocarbon::python {

//! Known structures and shapes, as the submodule `make`.
void add_make(pybind11::module_& module);

}  // namespace nanocarbon::python
