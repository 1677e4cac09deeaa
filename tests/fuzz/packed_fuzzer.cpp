// SPDX-License-Identifier: GPL-2.0-or-later
// For libFuzzer, run by run.sh: fuzz_molecule_packed, for files of atoms packed by gzip. Most changes are made to what
// is packed, since damage to the packed bytes seldom gets beyond their checksum.
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "fuzz/check_molecule.h"
#include "fuzz/memory_file.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/formats/read_molecule.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr int gzip = 15 + 16;  // zlib's name for the format

Bytes unpacked(const std::uint8_t* data, std::size_t size) {
  Bytes result(1u << 16);
  z_stream stream{};
  if (inflateInit2(&stream, gzip) != Z_OK) return {};
  stream.next_in = const_cast<std::uint8_t*>(data);
  stream.avail_in = static_cast<unsigned>(size);
  stream.next_out = result.data();
  stream.avail_out = static_cast<unsigned>(result.size());
  inflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  inflateEnd(&stream);
  return result;
}

std::size_t pack(const Bytes& bytes, std::uint8_t* data, std::size_t most) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, gzip, 8, Z_DEFAULT_STRATEGY) != Z_OK) return 0;
  stream.next_in = const_cast<std::uint8_t*>(bytes.data());
  stream.avail_in = static_cast<unsigned>(bytes.size());
  stream.next_out = data;
  stream.avail_out = static_cast<unsigned>(most);
  deflate(&stream, Z_FINISH);
  const std::size_t size = stream.total_out;
  deflateEnd(&stream);
  return size;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  if (seed % 8 == 0) return LLVMFuzzerMutate(data, size, most);
  const bool packed = size > 2 && data[0] == 0x1f && data[1] == 0x8b;
  Bytes bytes = packed ? unpacked(data, size) : Bytes(data, data + size);
  const std::size_t length = bytes.size();
  bytes.resize(std::max<std::size_t>(2 * length, 64));
  bytes.resize(LLVMFuzzerMutate(bytes.data(), length, bytes.size()));
  return pack(bytes, data, most);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const nanocarbon::test::MemoryFile file(data, size);
  try {
    nanocarbon::molecule::MoleculeFile molecules(file.path());
    for (int frames = 0; frames < 100; ++frames) {
      const auto frame = molecules.next();
      if (!frame) break;
      if (const std::string broken = nanocarbon::test::broken_by(*frame); !broken.empty()) {
        std::fprintf(stderr, "%s\n", broken.c_str());
        std::abort();
      }
    }
  } catch (const nanocarbon::UserError& error) {
    if (std::string(error.what()).find(file.path()) == std::string::npos) {
      std::fprintf(stderr, "the message does not name the file: %s\n", error.what());
      std::abort();
    }
  }
  return 0;
}
