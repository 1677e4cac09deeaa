// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

//! \file
//! \brief As much of fmt as LAMMPS's installed headers name. They come without it.
//! \details LAMMPS's own functions with a format string must not be called with these: they are deleted. The
//! forms that take one std::string (error->all, utils::logmesg) need nothing from here.

#include <cstddef>
#include <stdexcept>
#include <string>

namespace fmt {

class string_view {
 public:
  string_view() = default;
  string_view(const char* text);
  string_view(const std::string& text);

 private:
  const char* data_ = nullptr;
  std::size_t size_ = 0;
};

struct format_args {};
struct format_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <typename... Args, typename Format, typename... Values>
format_args make_args_checked(const Format& format, Values&&... values) = delete;

template <typename... Values>
format_args make_format_args(Values&&... values) = delete;

template <typename... Values>
std::string format(const Values&... values) = delete;

}  // namespace fmt
