// SPDX-License-Identifier: GPL-2.0-or-later
#include "analyse.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "analysed_xyz.h"
#include "command_text.h"
#include "common_options.h"
#include "molecule_input.h"
#include "nanocarbon/analysis/analysis_report.h"
#include "nanocarbon/analysis/atom_matching.h"
#include "nanocarbon/analysis/dual_triangulation.h"
#include "nanocarbon/building/potential_choice.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/core/output_file.h"
#include "nanocarbon/core/version.h"
#include "nanocarbon/mesh/formats/write_mesh.h"
#include "nanocarbon/molecule/formats/byte_source.h"
#include "nanocarbon/molecule/formats/distance_warnings.h"
#include "nanocarbon/molecule/formats/read_settings.h"
#include "nanocarbon/page/structure_page.h"
#include "number_checks.h"
#include "progress_bar.h"

namespace nanocarbon::cli {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

struct AnalyseCommand {
  std::vector<std::string> files;
  MoleculeInput input;  // how to read them
  std::string potential = "rebo2", rings = "auto";
  std::optional<fs::path> xyz, csv, mesh, page;
  topology::BondWindow carbon_carbon = topology::BondDistances().carbon_carbon;
  std::size_t every = 1;
  int max_ring = 12;
  unsigned threads = available_cores();
  bool json = false, quiet = false;
  std::string command_line;
};

building::PotentialChoice choice_of(const std::string& potential) {
  if (potential == "airebo") return building::PotentialChoice::airebo;
  if (potential == "airebo-m") return building::PotentialChoice::airebo_m;
  return building::PotentialChoice::rebo2;
}

void warn_of(const MoleculeInput& input, const molecule::MoleculeFrame& frame) {
  print_warnings(input, frame.warnings);
  try {
    print_warnings(input, molecule::distance_warnings(frame, molecule::shown_name(input.file)));
  } catch (const UserError& error) {  // of atoms that have no energy, bonds can still be told
    fmt::print(stderr, "nanocarbon: warning: {}\n", error.what());
  }
}

// What is kept of the frames gone through.
struct Findings {
  std::vector<analysis::FrameSummary> frames;
  molecule::MoleculeFrame last;
  analysis::Analysis analysis;
  analysis::FrameChange change;
  bool began_as_surface = true;
  page::PageFrames page_frames;
  std::size_t bonds_of_file = 0, bonds_differing = 0;  // of the first frame, where its file lists bonds
};

std::string label_of(const analysis::FrameSummary& frame) {
  return fmt::format("{}, frame {}{}: {}", fs::path(frame.file).filename().string(), frame.frame,
                     frame.step ? fmt::format(", step {}", *frame.step) : "",
                     topology::name(frame.change.verdict));
}

class Analyser {
 public:
  explicit Analyser(const AnalyseCommand& command) : command_(command) {
    if (command.potential != "none") {
      potential_ = building::make_potential(choice_of(command.potential));
      options_.potential = potential_.get();
    }
    distances_.carbon_carbon = command.carbon_carbon;
    options_.components.max_ring = command.max_ring;
    options_.components.threads = command.threads;
    if (command.rings == "king") options_.components.rings = analysis::RingChoice::king;
    if (command.rings == "primitive") options_.components.rings = analysis::RingChoice::primitive;
  }

  void run(std::ostream* xyz) {
    ProgressBar bar(command_.quiet || command_.json);
    for (const std::string& file : command_.files) {
      MoleculeInput input = command_.input;
      input.file = file;
      molecule::MoleculeFile frames(file, read_options(input));
      std::size_t number = 0;
      for (; std::optional<molecule::MoleculeFrame> frame = frames.next(); ++number) {
        if (number % command_.every != 0) continue;
        if (number == 0) warn_of(input, *frame);
        bar.show(fmt::format("analysing frame {}", number + 1), 0.0);
        take(file, number + 1, std::move(*frame), xyz);
      }
      if (const auto unused = frames.unused_types()) print_warnings(input, {*unused});
    }
    if (findings.frames.empty())
      throw UserError(Failure::unsuitable, command_.files.front() + ": there are no atoms in it");
  }

  Findings findings;

 private:
  void take(const std::string& file, std::size_t number, molecule::MoleculeFrame frame, std::ostream* xyz) {
    if (frame.molecule.size() == 0)
      throw UserError(Failure::unsuitable, fmt::format("{}: there are no atoms in frame {}", file, number));
    if (!findings.frames.empty() && !frame.has_ids) name_atoms(file, number, frame);
    next_id_ = std::max(next_id_, *std::max_element(frame.ids.begin(), frame.ids.end()) + 1);
    const std::vector<Bond> listed = std::move(frame.molecule.bonds);
    analysis::NamedBonds bonds =
        analysis::frame_bonds(frame.molecule, frame.ids, distances_, before_ ? &*before_ : nullptr);
    frame.molecule.bonds = bonds.bonds;
    findings.analysis = analysis::analyse(frame.molecule, frame.ids, options_);
    if (!start_) {
      start_ = bonds;
      start_surface_ = findings.analysis.components.surface;
      findings.began_as_surface = !start_surface_.problem;
      compare_with_listed(listed, frame.molecule.bonds);
    }
    analysis::FrameSummary summary = analysis::summarise(frame.molecule, findings.analysis);
    summary.file = file;
    summary.frame = number;
    summary.step = frame.step;
    summary.change =
        analysis::compare_frames(*start_, start_surface_, bonds, findings.analysis.components.surface);
    const std::vector<analysis::AtomFate> fates = analysis::atom_fates(frame.ids, summary.change);
    if (command_.page)
      findings.page_frames.offer(
          page::structure_frame(frame.molecule, findings.analysis, fates, label_of(summary)));
    if (xyz)
      write_analysed_xyz(*xyz, frame.molecule, frame.ids, findings.analysis, fates,
                         fmt::format("{} (nanocarbon {})", command_.command_line, version));
    findings.change = summary.change;
    if (before_) summary.since_before = analysis::compare_with_before(*before_, bonds);
    findings.frames.push_back(std::move(summary));
    findings.last = std::move(frame);
    before_ = std::move(bonds);
  }

  // Gives atoms without IDs those of the frame before, and says what is doubtful about it, once for the same doubt.
  void name_atoms(const std::string& file, std::size_t number, molecule::MoleculeFrame& frame) {
    analysis::AtomMatching matching =
        analysis::match_atoms(frame.molecule, findings.last.molecule, findings.last.ids, next_id_);
    frame.ids = std::move(matching.ids);
    molecule::sort_by_id(frame);
    if (matching.doubt.empty() || doubted_ == file + matching.doubt) return;
    doubted_ = file + matching.doubt;
    MoleculeInput input = command_.input;
    input.file = file;
    print_warnings(input, {fmt::format("frame {}: {}. A column id would tell", number, matching.doubt)});
  }

  void compare_with_listed(const std::vector<Bond>& listed, const std::vector<Bond>& found) {
    if (listed.empty()) return;
    const auto changes = topology::compare_bonds(topology::bonded_ids(listed), topology::bonded_ids(found));
    findings.bonds_of_file = listed.size();
    findings.bonds_differing = changes.broken.size() + changes.formed.size();
  }

  const AnalyseCommand& command_;
  analysis::AnalyseOptions options_;
  topology::BondDistances distances_;
  std::unique_ptr<potential::Potential> potential_;
  std::optional<analysis::NamedBonds> start_, before_;
  topology::SurfaceTopology start_surface_;
  std::int64_t next_id_ = 1;  // that no frame has had
  std::string doubted_;       // file and doubt that were warned of last
};

void write_json(std::ostream& out, const AnalyseCommand& command, const Findings& found) {
  analysis::JsonWriter json(out);
  const auto write = [&](std::string_view key, const Json& value) {
    json.key(key);
    json.value(value);
  };
  json.begin_object();
  write("nanocarbon", version);
  write("command", command.command_line);
  write("file", found.frames.back().file);
  write("frame", found.frames.back().frame);
  analysis::write_analysis_json(json, found.last.molecule, found.last.ids, found.analysis);
  if (found.bonds_of_file > 0)
    write("bonds_of_file", {{"count", found.bonds_of_file}, {"differing", found.bonds_differing}});
  write("verdict", topology::name(found.change.verdict));
  json.key("frames");
  json.begin_list();
  for (const analysis::FrameSummary& frame : found.frames) analysis::write_frame_json(json, frame);
  json.end();
  json.end();
  json.flush();
  out << '\n';
}

void print_json(const AnalyseCommand& command, const Findings& found) {
  errno = 0;
  try {
    std::cout.exceptions(std::ios::badbit | std::ios::failbit);
    write_json(std::cout, command, found);
    std::cout.flush();
  } catch (const std::ios_base::failure&) {
    throw UserError(Failure::unwritable, fmt::format("standard output: cannot be written: {}",
                                                     errno ? std::strerror(errno) : "write error"));
  }
}

// --types takes words up to the next option, FILEs too where they stand behind them.
void find_files(AnalyseCommand& command) {
  std::vector<std::string>& types = command.input.types;
  const auto is_file = [](const std::string& word) {
    std::error_code ignored;
    return word == "-" || fs::exists(word, ignored);
  };
  while (types.size() > 1 && (is_file(types.back()) || command.files.empty())) {
    command.files.insert(command.files.begin(), types.back());
    types.pop_back();
    if (!is_file(command.files.front())) break;
  }
  if (command.files.empty()) throw CLI::RequiredError("FILE");
}

// The frames in which bonds or atoms have changed since the one before, a line each.
void print_changed_frames(const std::vector<analysis::FrameSummary>& frames) {
  constexpr int most = 10;
  int printed = 0;
  std::size_t left = 0;
  for (const analysis::FrameSummary& frame : frames) {
    const analysis::FrameStep& c = frame.since_before;
    if (c.none()) continue;
    if (printed == most) {
      ++left;
      continue;
    }
    std::string text = fmt::format("{} bonds broken, {} formed", c.broken, c.formed);
    if (c.lost > 0) text += fmt::format(", {} atoms lost", c.lost);
    if (c.added > 0) text += fmt::format(", {} added", c.added);
    const bool several = frames.front().file != frames.back().file;
    fmt::print(
        "  {:<26}{}{}{}\n", printed++ == 0 ? "changes" : "", several ? fmt::format("{}, ", frame.file) : "",
        fmt::format("frame {}{}: ", frame.frame, frame.step ? fmt::format(", step {}", *frame.step) : ""),
        text);
  }
  if (left > 0) fmt::print("  {:<26}and in {} more frames\n", "", left);
}

void print_frames(const Findings& found) {
  const analysis::FrameChange& c = found.change;
  if (found.began_as_surface)
    fmt::print("  {:<26}{}{}\n", "verdict", topology::name(c.verdict),
               c.reason.empty() ? "" : ": " + c.reason);
  else
    fmt::print("  {:<26}{}\n", "verdict",
               c.changes.none() && c.lost.empty()
                   ? "intact: the bonds are the same"
                   : "none: the first frame is not a surface; bonds have changed");
  fmt::print("  {:<26}{} bonds broken, {} formed, {} atoms repelled, {} lost\n", "since the first frame",
             c.changes.broken.size(), c.changes.formed.size(), c.repelled.size() - c.lost.size(),
             c.lost.size());
  if (!c.added.empty())
    fmt::print("  {:<26}{} atoms that the first frame does not have\n", "added", c.added.size());
  print_changed_frames(found.frames);
}

void print_text(const Findings& found) {
  const analysis::FrameSummary& last = found.frames.back();
  fmt::print("{}{}\n{}", last.file,
             found.frames.size() > 1
                 ? fmt::format(", frame {} (of {} looked at)", last.frame, found.frames.size())
                 : "",
             analysis::analysis_table(found.last.molecule, found.last.ids, found.analysis));
  if (found.frames.size() > 1) print_frames(found);
}

page::PageContents page_of(const AnalyseCommand& command, Findings& found) {
  page::PageContents contents;
  contents.title = fs::path(command.files.front()).filename().string();
  contents.command = fmt::format("{} (nanocarbon {})", command.command_line, version);
  page::add_trajectory(contents, found.frames);
  page::add_analysis(contents, found.last.molecule, found.last.ids, found.analysis);
  contents.frames = found.page_frames.take();
  if (contents.frames.size() < found.frames.size())
    contents.facts.emplace_back("frames shown",
                                fmt::format("{} of {}", contents.frames.size(), found.frames.size()));
  return contents;
}

void run(const AnalyseCommand& command) {
  if (command.carbon_carbon.form > command.carbon_carbon.breaking)
    throw UserError(Failure::usage,
                    fmt::format("--form {} is above --break {}: a bond would break as it forms",
                                command.carbon_carbon.form, command.carbon_carbon.breaking));
  if (command.mesh) mesh::format_to_write(*command.mesh);
  if (command.page) page::require_pages();
  Analyser analyser(command);
  OutputFiles files;
  if (command.xyz)
    files.add(*command.xyz, [&](std::ostream& out) { analyser.run(&out); });
  else
    analyser.run(nullptr);
  Findings& found = analyser.findings;
  if (found.bonds_differing > 0 && !command.quiet)
    fmt::print(stderr,
               "nanocarbon: warning: {}: {} bonds found by distance differ from those listed in the file\n",
               command.files.front(), found.bonds_differing);
  if (command.csv)
    files.add(*command.csv, [&](std::ostream& out) { out << analysis::frames_csv(found.frames); });
  if (command.mesh) {
    const analysis::DualTriangulation dual =
        analysis::dual_triangulation(found.last.molecule, found.last.ids, command.max_ring);
    files.add(*command.mesh, [&](std::ostream& out) {
      mesh::write_mesh(out, mesh::format_to_write(*command.mesh), dual.mesh, {});
    });
  }
  if (command.page)
    files.add(*command.page, [&](std::ostream& out) { page::write_page(out, page_of(command, found)); });
  files.publish();
  if (command.json)
    print_json(command, found);
  else if (!command.quiet)
    print_text(found);
}

}  // namespace

void add_analyse(CLI::App& app) {
  CLI::App& sub = *app.add_subcommand(
      "analyse", "Report bonds, rings, defects, topology and energies of structures and trajectories");
  const auto command = std::make_shared<AnalyseCommand>();
  AnalyseCommand& c = *command;
  sub.add_option("FILE", c.files,
                 "LAMMPS data files and text dumps, XYZ, extended XYZ, CIF or POSCAR, also compressed with "
                 "gzip; - for standard input. Several files form one trajectory, in this order")
      ->option_text("TEXT ... REQUIRED");
  sub.add_flag("--json", c.json, "Print everything as JSON, including the atoms of each ring and defect");
  sub.add_option("--xyz", c.xyz,
                 "Write all frames as extended XYZ, with what is known of each atom as columns")
      ->type_name("FILE");
  sub.add_option("--csv", c.csv, "Write a table (CSV) with one line per frame")->type_name("FILE");
  sub.add_option("--mesh", c.mesh,
                 "Write the triangulation of which the last frame is the dual: .off, .obj, .ply or .stl")
      ->type_name("FILE");
  sub.add_option("--page", c.page,
                 "Write a self-contained page (HTML): the structure in 3D, plots, defects, frames")
      ->type_name("FILE");
  sub.add_option("--form", c.carbon_carbon.form,
                 "Distance below which two carbon atoms become bonded, Angstrom")
      ->check(above_zero())
      ->capture_default_str();
  sub.add_option("--break", c.carbon_carbon.breaking, "Distance up to which they then stay bonded, Angstrom")
      ->check(above_zero())
      ->capture_default_str();
  sub.add_option("--rings", c.rings,
                 "Rings to report: auto (faces of surfaces, King's rings elsewhere), king, or primitive "
                 "(shortest-path rings)")
      ->check(CLI::IsMember({"auto", "king", "primitive"}))
      ->capture_default_str();
  sub.add_option("--max-ring", c.max_ring, "Number of atoms in the largest ring; larger faces are holes")
      ->transform(whole_number())
      ->check(between(3, 64))
      ->capture_default_str();
  sub.add_option("--potential", c.potential, "Potential of the energies: rebo2, airebo, airebo-m, or none")
      ->check(CLI::IsMember({"rebo2", "airebo", "airebo-m", "none"}))
      ->capture_default_str();
  sub.add_option("--every", c.every, "Use only every Nth frame of each file")
      ->transform(whole_number())
      ->check(between(1, 1e9))
      ->capture_default_str();
  add_read_options(sub, c.input);
  sub.add_option("--threads", c.threads, "Number of threads; by default one per core")
      ->transform(whole_number())
      ->check(between(1, 1024))
      ->default_str("cores");
  sub.add_flag("-q,--quiet", c.quiet, "Print nothing but errors");
  sub.footer(R"(Bonds are told by distance; a bond stays until --break. Rings of a surface are its faces.
Examples:
  nanocarbon analyse bunny.data
  nanocarbon analyse run.lammpstrj.gz --types C H --xyz columns.xyz --csv frames.csv
  nanocarbon analyse amorphous.data --json --max-ring 10
  nanocarbon analyse relaxed.data --mesh dual.off)");
  sub.parse_complete_callback([command] { find_files(*command); });
  sub.callback([command, &sub] {
    command->command_line = command_text(sub);
    run(*command);
  });
}

}  // namespace nanocarbon::cli
