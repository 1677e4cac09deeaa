// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace nanocarbon::mesh {

//! The version of CGAL that wrap(), unite() and untangle() use, such as "5.5.1"; empty where they were built without it
//! and throw.
const char* cgal_version();

//! \throw UserError (usage) that says how to get CGAL
[[noreturn]] void refuse_without_cgal();

}  // namespace nanocarbon::mesh
