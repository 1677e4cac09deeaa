// SPDX-License-Identifier: GPL-2.0-or-later
// C++17, as gemmi is: it has vectors of types that are not complete yet, which clang does not take as C++20.
#include "nanocarbon/molecule/formats/cif_document.h"

#include <algorithm>
#include <gemmi/cif.hpp>
#include <gemmi/numb.hpp>
#include <utility>

namespace nanocarbon::molecule {
namespace {

namespace cif = gemmi::cif;

CifTable table_of(const cif::Loop& loop) {
  CifTable table;
  for (const std::string& tag : loop.tags) table.tags.push_back(gemmi::to_lower(tag));
  table.values.reserve(loop.values.size());
  for (const std::string& value : loop.values) table.values.push_back(cif::as_string(value));
  return table;
}

CifBlock block_of(const cif::Block& parsed) {
  CifBlock block{parsed.name, {}};
  CifTable singles;
  for (const cif::Item& item : parsed.items) {
    if (item.type == cif::ItemType::Loop) {
      block.tables.push_back(table_of(item.loop));
    } else if (item.type == cif::ItemType::Pair) {
      singles.tags.push_back(gemmi::to_lower(item.pair[0]));
      singles.values.push_back(cif::as_string(item.pair[1]));
    }
  }
  block.tables.push_back(std::move(singles));
  return block;
}

}  // namespace

std::optional<std::size_t> CifTable::column(const std::string& tag) const {
  const auto found = std::find(tags.begin(), tags.end(), tag);
  if (found == tags.end()) return std::nullopt;
  return static_cast<std::size_t>(found - tags.begin());
}

const CifTable* CifBlock::table_with(const std::string& tag) const {
  for (const CifTable& table : tables)
    if (table.column(tag)) return &table;
  return nullptr;
}

std::string CifBlock::value(const std::string& tag) const {
  const CifTable* table = table_with(tag);
  return table != nullptr && table->rows() > 0 ? table->at(0, *table->column(tag)) : std::string();
}

std::vector<CifBlock> parse_cif(const std::string& text, const std::string& name) {
  cif::Document document = cif::read_memory(text.data(), text.size(), name.c_str());
  std::vector<CifBlock> blocks;
  for (cif::Block& parsed : document.blocks) {
    blocks.push_back(block_of(parsed));
    parsed.items = {};  // large files are in memory once
  }
  return blocks;
}

double cif_number(const std::string& text) { return cif::as_number(text); }

}  // namespace nanocarbon::molecule
