// SPDX-License-Identifier: GPL-2.0-or-later
// The compiled half of the Python module nanocarbon_sp2.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

#include "arrays.h"
#include "make_module.h"
#include "mesh_object.h"
#include "nanocarbon/analysis/analysis_report.h"
#include "nanocarbon/analysis/dual_triangulation.h"
#include "nanocarbon/building/build_report.h"
#include "nanocarbon/building/potential_choice.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/core/version.h"
#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/formats/write_mesh.h"
#include "nanocarbon/molecule/formats/write_molecule.h"

namespace nanocarbon::python {
namespace {

namespace py = pybind11;

std::unique_ptr<potential::Potential> potential_named(const std::string& name) {
  for (const auto choice : {building::PotentialChoice::rebo2, building::PotentialChoice::airebo,
                            building::PotentialChoice::airebo_m})
    if (name == building::name(choice)) return building::make_potential(choice);
  throw py::value_error("there is no potential '" + name + "'; there are rebo2, airebo and airebo-m");
}

std::vector<std::int64_t> indices(std::size_t count) {
  std::vector<std::int64_t> ids(count);
  std::iota(ids.begin(), ids.end(), 0);
  return ids;
}

// ---- molecules ------------------------------------------------------------------------------------------------

Molecule molecule_from(const Doubles& positions, const Integers& numbers, const std::optional<Doubles>& cell,
                       std::array<bool, 3> periodic) {
  Molecule molecule;
  molecule.positions = points_from(positions);
  molecule.elements = elements_from(numbers, molecule.size());
  molecule.cell = cell_from(cell, periodic);
  return molecule;
}

py::list rings_of(const Molecule& molecule) {
  py::list rings;
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) rings.append(copy_of<AtomIndex>(molecule.rings[r]));
  return rings;
}

// ---- building -------------------------------------------------------------------------------------------------

struct Built {
  Molecule molecule;
  std::string report;  // JSON
  TriangleMesh triangulation;
};

building::SizeRequest size_request(std::optional<std::size_t> atoms, std::optional<double> length,
                                   std::optional<double> scale) {
  if (atoms.has_value() + length.has_value() + scale.has_value() > 1)
    throw py::value_error("give one of atoms, length and scale");
  if (atoms) return building::AtomCount{*atoms};
  if (length) return building::LongestSide{*length};
  if (scale) return building::UnitScale{*scale};
  return building::AtomPerTriangle{};
}

Quality quality_named(const std::string& name) {
  if (name == "draft") return Quality::draft;
  if (name == "good") return Quality::good;
  if (name == "best") return Quality::best;
  throw py::value_error("there is no quality '" + name + "'; there are draft, good and best");
}

building::Boundary boundary_named(const std::string& name) {
  for (const auto boundary : {building::Boundary::hydrogen, building::Boundary::bare})
    if (name == building::name(boundary)) return boundary;
  throw py::value_error("there is no boundary '" + name + "'; there are hydrogen and bare");
}

mesh::FieldEdge field_edge_named(const std::string& name) {
  if (name == "closed") return mesh::FieldEdge::closed;
  if (name == "above") return mesh::FieldEdge::above;
  if (name == "below") return mesh::FieldEdge::below;
  if (name == "open") return mesh::FieldEdge::open;
  throw py::value_error("there is no field_edge '" + name + "'; there are closed, above, below and open");
}

building::PotentialChoice choice_named(const std::string& name) {
  potential_named(name);
  if (name == "airebo") return building::PotentialChoice::airebo;
  return name == "airebo-m" ? building::PotentialChoice::airebo_m : building::PotentialChoice::rebo2;
}

Built build(const Mesh& mesh, std::optional<std::size_t> atoms, std::optional<double> length,
            std::optional<double> scale, const std::string& quality, const std::string& potential,
            std::optional<double> tether, const std::string& boundary, bool force, unsigned threads,
            std::uint64_t seed, std::optional<std::function<void(std::string, double)>> progress) {
  building::BuildOptions options;
  options.size = size_request(atoms, length, scale);
  options.quality = quality_named(quality);
  options.potential = choice_named(potential);
  options.tether = tether;
  options.boundary = boundary_named(boundary);
  options.force = force;
  options.threads = threads;
  options.seed = seed;
  // Where progress is told Ctrl-C is heard, too.
  options.progress = [&](std::string_view stage, double fraction) {
    py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (progress) (*progress)(std::string(stage), fraction);
  };
  py::gil_scoped_release release;
  building::BuildResult result = building::build_molecule(mesh.mesh, options);
  const auto report = building::build_report(result, options, {"nanocarbon_sp2.build", "", mesh.repairs});
  return {std::move(result.molecule), report.dump(), std::move(result.triangulation)};
}

// ---- analysis -------------------------------------------------------------------------------------------------

struct Analysed {
  std::string report;  // JSON, atoms by index from 0
  analysis::Analysis found;
  Molecule molecule;  // with bonds and rings
};

Analysed analyse(Molecule molecule, double form, const std::string& rings, int max_ring,
                 const std::string& potential, unsigned threads) {
  analysis::AnalyseOptions options;
  if (rings == "king")
    options.components.rings = analysis::RingChoice::king;
  else if (rings == "primitive")
    options.components.rings = analysis::RingChoice::primitive;
  else if (rings != "auto")
    throw py::value_error("rings are 'auto', 'king' or 'primitive'");
  if (max_ring < 3 || max_ring > 64) throw py::value_error("max_ring must be 3 to 64");
  options.components.max_ring = max_ring;
  options.components.threads = threads;
  const auto energies = potential == "none" ? nullptr : potential_named(potential);
  options.potential = energies.get();
  py::gil_scoped_release release;
  topology::BondDistances distances;
  distances.carbon_carbon.form = form;
  distances.carbon_carbon.breaking = std::max(form, distances.carbon_carbon.breaking);
  const std::vector<std::int64_t> ids = indices(molecule.size());
  molecule.bonds = analysis::frame_bonds(molecule, ids, distances, nullptr).bonds;
  Analysed result;
  result.found = analysis::analyse(molecule, ids, options);
  std::ostringstream report;
  analysis::JsonWriter json(report);
  json.begin_object();
  analysis::write_analysis_json(json, molecule, ids, result.found);
  json.end();
  json.flush();
  result.report = std::move(report).str();
  molecule.rings = result.found.components.rings;
  result.molecule = std::move(molecule);
  return result;
}

py::dict columns_of(const Analysed& analysed) {
  const analysis::Analysis& a = analysed.found;
  const std::size_t atoms = analysed.molecule.size();
  py::array_t<std::int64_t> coordination(static_cast<py::ssize_t>(atoms)),
      smallest(static_cast<py::ssize_t>(atoms));
  for (AtomIndex i = 0; i < atoms; ++i) {
    const auto rings = a.rings_of_atoms.of(i);
    coordination.mutable_at(i) = static_cast<std::int64_t>(a.rows.degree(i));
    smallest.mutable_at(i) =
        rings.empty() ? 0 : static_cast<std::int64_t>(a.components.rings[rings.front()].size());
  }
  py::dict columns;
  columns["coordination"] = coordination;
  columns["smallest_ring"] = smallest;
  columns["piece"] = copy_of<std::uint32_t>(a.components.of_atom);
  columns["pyramidalisation"] = copy_of<double>(a.geometry.pyramidalisation);
  columns["mean_curvature"] = copy_of<double>(a.geometry.mean_curvature);
  columns["gaussian_curvature"] = copy_of<double>(a.geometry.gaussian_curvature);
  if (!a.atom_energies.empty()) columns["energy"] = copy_of<double>(a.atom_energies);
  return columns;
}

// ---- potentials -----------------------------------------------------------------------------------------------

py::dict evaluate(potential::Potential& potential, const Doubles& positions, const Integers& numbers,
                  const std::optional<Doubles>& cell, std::array<bool, 3> periodic) {
  const Molecule molecule = molecule_from(positions, numbers, cell, periodic);
  const potential::Evaluation* found = nullptr;
  {
    py::gil_scoped_release release;
    found = &potential.evaluate(molecule.positions, molecule.elements,
                                molecule.cell ? &*molecule.cell : nullptr, {.atom_energies = true});
  }
  py::array_t<double> forces({static_cast<py::ssize_t>(molecule.size()), py::ssize_t{3}}), virial({3, 3});
  for (std::size_t i = 0; i < molecule.size(); ++i)
    for (int d = 0; d < 3; ++d) forces.mutable_at(i, d) = found->forces[i][d];
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) virial.mutable_at(r, c) = found->virial(r, c);
  py::dict result;
  result["energy"] = found->energy;
  result["forces"] = forces;
  result["virial"] = virial;
  result["energies"] = copy_of<double>(found->atom_energies);
  return result;
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.attr("__version__") = nanocarbon::version;
  py::register_exception<UserError>(module, "NanocarbonError", PyExc_ValueError);

  py::class_<Mesh>(module, "Mesh", "A triangle mesh that is fit to build on.")
      .def_property_readonly(
          "points", [](py::object self) { return view_of(self.cast<Mesh&>().mesh.points, self, false); })
      .def_property_readonly("triangles",
                             [](const Mesh& mesh) {
                               py::array_t<std::uint32_t> array(
                                   {static_cast<py::ssize_t>(mesh.mesh.triangles.size()), py::ssize_t{3}});
                               auto out = array.mutable_unchecked<2>();
                               for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t)
                                 for (std::size_t k = 0; k < 3; ++k)
                                   out(static_cast<py::ssize_t>(t), static_cast<py::ssize_t>(k)) =
                                       mesh.mesh.triangles[t][k];
                               return array;
                             })
      .def_readonly("repairs", &Mesh::repairs)
      .def_readonly("warnings", &Mesh::warnings)
      .def(
          "write",
          [](const Mesh& mesh, const std::filesystem::path& path) { mesh::write_mesh(path, mesh.mesh); },
          py::arg("path"));

  module.def(
      "read_mesh",
      [](const std::filesystem::path& path, std::optional<double> level, const std::string& field,
         const std::string& field_edge, std::optional<std::array<bool, 3>> periodic) {
        mesh::LoadOptions options;
        options.field = {.level = level, .array = field, .edge = field_edge_named(field_edge)};
        options.cell.periodic = periodic;
        py::gil_scoped_release release;
        mesh::LoadedSurface loaded = mesh::load_surface(path, options);
        return Mesh{std::move(loaded.mesh), std::move(loaded.repairs), std::move(loaded.warnings)};
      },
      py::arg("path"), py::kw_only(), py::arg("level") = py::none(), py::arg("field") = "",
      py::arg("field_edge") = "closed", py::arg("periodic") = py::none());

  py::class_<Molecule>(module, "Molecule", "Atoms, bonds and rings.")
      .def(py::init(&molecule_from), py::arg("positions"), py::arg("numbers"), py::arg("cell") = py::none(),
           py::arg("pbc") = std::array<bool, 3>{false, false, false})
      .def("__len__", &Molecule::size)
      .def_property_readonly(
          "positions", [](py::object self) { return view_of(self.cast<Molecule&>().positions, self, true); })
      .def_property_readonly("numbers", [](const Molecule& m) { return numbers_of(m.elements); })
      .def_property_readonly(
          "bonds", [](py::object self) { return view_of_bonds(self.cast<Molecule&>().bonds, self); })
      .def_property_readonly(
          "bond_images", [](py::object self) { return view_of_images(self.cast<Molecule&>().bonds, self); })
      .def_property_readonly("rings", &rings_of)
      .def_property_readonly("cell", [](const Molecule& m) { return rows_of(m.cell); })
      .def_property_readonly("pbc",
                             [](const Molecule& m) {
                               return m.cell ? m.cell->periodic : std::array<bool, 3>{false, false, false};
                             })
      .def(
          "write",
          [](const Molecule& self, const std::filesystem::path& path) {
            molecule::write_molecule(path, self, {molecule::AtomStyle::molecular});
          },
          py::arg("path"))
      .def(
          "triangulation",
          [](const Molecule& m, int max_ring) {
            return Mesh{analysis::dual_triangulation(m, indices(m.size()), max_ring).mesh, {}, {}};
          },
          py::arg("max_ring") = 12);

  py::class_<Built>(module, "Built")
      .def_readonly("molecule", &Built::molecule)
      .def_readonly("report", &Built::report)
      .def_property_readonly("triangulation", [](const Built& built) {
        return Mesh{built.triangulation, {}, {}};
      });
  module.def("build", &build, py::arg("mesh"), py::arg("atoms"), py::arg("length"), py::arg("scale"),
             py::arg("quality"), py::arg("potential"), py::arg("tether"), py::arg("boundary"),
             py::arg("force"), py::arg("threads"), py::arg("seed"), py::arg("progress"));

  py::class_<Analysed>(module, "Analysed")
      .def_readonly("report", &Analysed::report)
      .def_readonly("molecule", &Analysed::molecule)
      .def_property_readonly("columns", &columns_of);
  module.def("analyse", &analyse, py::arg("molecule"), py::arg("form"), py::arg("rings"), py::arg("max_ring"),
             py::arg("potential"), py::arg("threads"));

  py::class_<potential::Potential>(module, "Potential", "Energy, forces and virial of a structure.")
      .def(py::init(&potential_named), py::arg("name"))
      .def_property_readonly("name", [](const potential::Potential& p) { return std::string(p.name()); })
      .def_property_readonly("graphene_energy", &potential::Potential::graphene_energy)
      .def_property_readonly("hydrogen_energy", &potential::Potential::hydrogen_energy)
      .def("evaluate", &evaluate, py::arg("positions"), py::arg("numbers"), py::arg("cell") = py::none(),
           py::arg("pbc") = std::array<bool, 3>{false, false, false});

  add_make(module);
}

}  // namespace nanocarbon::python
