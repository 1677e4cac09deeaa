// SPDX-License-Identifier: GPL-2.0-or-later
#include "make_module.h"

#include "mesh_object.h"
#include "nanocarbon/shapes/shapes.h"
#include "nanocarbon/structures/capped_tube.h"
#include "nanocarbon/structures/diamond.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/onion.h"
#include "nanocarbon/structures/schwarzite.h"
#include "nanocarbon/structures/schwarzite_family.h"
#include "nanocarbon/structures/tube.h"

namespace nanocarbon::python {

namespace py = pybind11;

void add_make(py::module_& module) {
  py::module_ make = module.def_submodule("make", "Known structures of carbon, and shapes as meshes.");
  make.def("graphene", &structures::graphene, py::arg("cells_x"), py::arg("cells_y"),
           "A periodic sheet of rectangular cells of four atoms.");
  make.def("flake", &structures::graphene_flake, py::arg("radius"),
           "A round flake of graphene; radius in Angstrom.");
  make.def("tube", &structures::periodic_tube, py::arg("n"), py::arg("m"), py::arg("periods") = 1,
           "A periodic nanotube (n, m).");
  make.def("open_tube", &structures::open_tube, py::arg("n"), py::arg("m"), py::arg("length"),
           "An open nanotube (n, m); length in Angstrom.");
  make.def("capped_tube", &structures::capped_tube, py::arg("n"), py::arg("m"), py::arg("length"),
           "A nanotube (n, m) closed by caps; length in Angstrom.");
  make.def("fullerene", &structures::fullerene, py::arg("h"), py::arg("k"),
           "The icosahedral fullerene of 20 (h^2 + h k + k^2) atoms; C60 is (1, 1).");
  make.def("onion", &structures::onion, py::arg("innermost"), py::arg("shells"),
           "Fullerenes around each other.");
  make.def("diamond", &structures::diamond, py::arg("cells_x"), py::arg("cells_y"), py::arg("cells_z"),
           "Periodic diamond of cubic cells.");
  make.def("schwarzite_p688", &structures::schwarzite_p688, py::arg("cells_x"), py::arg("cells_y"),
           py::arg("cells_z"));
  make.def("schwarzite_d688", &structures::schwarzite_d688, py::arg("cells_x"), py::arg("cells_y"),
           py::arg("cells_z"));

  make.def("schwarzite_g688", &structures::schwarzite_g688, py::arg("cells_x"), py::arg("cells_y"),
           py::arg("cells_z"));
  make.def("schwarzite", &structures::schwarzite, py::arg("name"),
           "A schwarzite by its surface and the atoms in its cell, near equilibrium: p192, d168, g384.");

  const auto mesh = [](TriangleMesh made) { return Mesh{std::move(made), {}, {}}; };
  make.def(
      "sphere",
      [mesh](double radius, int subdivisions) { return mesh(shapes::make_sphere(radius, subdivisions)); },
      py::arg("radius") = 1.0, py::arg("subdivisions") = 4, "An icosphere as a mesh.");
  make.def(
      "torus",
      [mesh](double major, double minor, double edge) {
        return mesh(shapes::make_torus(major, minor, edge));
      },
      py::arg("major") = 2.0, py::arg("minor") = 0.8, py::arg("edge") = 0.1, "A torus as a mesh.");
  make.def(
      "cylinder",
      [mesh](double radius, double length, double edge) {
        return mesh(shapes::make_cylinder(radius, length, edge));
      },
      py::arg("radius"), py::arg("length"), py::arg("edge"), "An open cylinder as a mesh.");
}

}  // namespace nanocarbon::python
