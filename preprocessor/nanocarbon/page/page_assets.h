// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

namespace nanocarbon::page {

//! The files that every page is put together from.
struct PageAssets {
  std::string_view html;  //!< the frame, with names between at signs where things go
  std::string_view css;
  std::string_view viewer;   //!< our script
  std::string_view three;    //!< three.js; empty where the build had none
  std::string_view licence;  //!< of three.js
};

PageAssets page_assets();

}  // namespace nanocarbon::page
