// SPDX-License-Identifier: GPL-2.0-or-later
#include <functional>
#include <memory>
#include <numbers>
#include <string>

#include "cell_options.h"
#include "make.h"
#include "make_output.h"
#include "nanocarbon/shapes/formula_surface.h"
#include "nanocarbon/shapes/implicit_shapes.h"
#include "nanocarbon/shapes/periodic_shapes.h"
#include "nanocarbon/shapes/shapes.h"
#include "number_checks.h"

namespace nanocarbon::cli {
namespace {

//! One `make mesh SHAPE`: its options fill a Shape, which `make` turns into a mesh.
template <typename Shape>
struct ShapeCommand {
  Shape shape;
  MeshOutput output;
};

template <typename Shape>
std::shared_ptr<ShapeCommand<Shape>> add_shape(CLI::App& mesh, const char* name, const char* description,
                                               const std::function<TriangleMesh(const Shape&)>& make) {
  CLI::App& sub = *mesh.add_subcommand(name, description);
  auto command = std::make_shared<ShapeCommand<Shape>>();
  sub.callback([command, make] { write_shape(command->output, make(command->shape)); });
  add_mesh_output(sub, command->output);
  return command;
}

void length(CLI::App& mesh, const char* shape, const char* option, double& value, const char* description) {
  mesh.get_subcommand(shape)
      ->add_option(option, value, std::string(description) + ", mesh units")
      ->check(above_zero())
      ->capture_default_str();
}

void add_sphere(CLI::App& mesh) {
  struct Sphere {
    double radius = 1.0;
    int subdivisions = 10;
  };
  const auto c = add_shape<Sphere>(mesh, "sphere", "A sphere of 20 S^2 triangles", [](const Sphere& s) {
    return shapes::make_sphere(s.radius, s.subdivisions);
  });
  length(mesh, "sphere", "--radius", c->shape.radius, "Radius");
  mesh.get_subcommand("sphere")
      ->add_option("--subdivisions", c->shape.subdivisions,
                   "Parts S into which each edge of an icosahedron is divided")
      ->transform(whole_number())
      ->check(between(1, 1000))
      ->capture_default_str();
}

void add_nested_spheres(CLI::App& mesh) {
  const char* const name = "nested-spheres";
  const auto c = add_shape<shapes::NestedSpheres>(mesh, name, "Spheres about one centre, as for an onion",
                                                  shapes::make_nested_spheres);
  length(mesh, name, "--radius", c->shape.radius, "Radius of the innermost sphere");
  length(mesh, name, "--gap", c->shape.gap, "From each sphere to the next");
  length(mesh, name, "--edge", c->shape.edge, "Length of the edges of its triangles");
  mesh.get_subcommand(name)
      ->add_option("--count", c->shape.count, "Number of spheres")
      ->transform(whole_number())
      ->check(between(1, 100))
      ->capture_default_str();
}

void add_hemisphere(CLI::App& mesh) {
  struct Hemisphere {
    double radius = 1.0, edge = 0.1;
  };
  const auto c =
      add_shape<Hemisphere>(mesh, "hemisphere", "Half a sphere, with a boundary",
                            [](const Hemisphere& s) { return shapes::make_hemisphere(s.radius, s.edge); });
  length(mesh, "hemisphere", "--radius", c->shape.radius, "Radius");
  length(mesh, "hemisphere", "--edge", c->shape.edge, "Length of the triangles' edges");
}

//! A capsule, or a cylinder with two boundaries.
void add_straight(CLI::App& mesh, const char* name, const char* description,
                  TriangleMesh (*make)(double radius, double length, double edge)) {
  struct Straight {
    double radius = 1.0, length = 4.0, edge = 0.15;
  };
  const auto c = add_shape<Straight>(mesh, name, description,
                                     [make](const Straight& s) { return make(s.radius, s.length, s.edge); });
  length(mesh, name, "--radius", c->shape.radius, "Radius");
  length(mesh, name, "--length", c->shape.length, "Length of the straight part");
  length(mesh, name, "--edge", c->shape.edge, "Length of the triangles' edges");
}

//! A torus, or two grown together.
void add_rings(CLI::App& mesh, const char* name, const char* description,
               TriangleMesh (*make)(double major, double minor, double edge)) {
  struct RingShape {
    double major = 2.0, minor = 0.8, edge = 0.18;
  };
  const auto c = add_shape<RingShape>(mesh, name, description,
                                      [make](const RingShape& s) { return make(s.major, s.minor, s.edge); });
  length(mesh, name, "--major", c->shape.major, "Radius of the circle along the middle of the tube");
  length(mesh, name, "--minor", c->shape.minor, "Radius of the tube");
  length(mesh, name, "--edge", c->shape.edge, "Length of the triangles' edges");
}

void add_helix(CLI::App& mesh) {
  const auto c = add_shape<shapes::HelixShape>(mesh, "helix", "A tube along a helix", shapes::make_helix);
  length(mesh, "helix", "--coil-radius", c->shape.coil_radius, "Radius of the helix");
  length(mesh, "helix", "--tube-radius", c->shape.tube_radius, "Radius of the tube");
  length(mesh, "helix", "--pitch", c->shape.pitch, "Rise in one turn");
  length(mesh, "helix", "--edge", c->shape.edge, "Length of the triangles' edges");
  CLI::App& sub = *mesh.get_subcommand("helix");
  sub.add_option("--turns", c->shape.turns, "Number of turns")->check(above_zero())->capture_default_str();
  sub.add_flag("--open", c->shape.open, "Boundaries at both ends, instead of round ends");
}

void add_junction(CLI::App& mesh) {
  struct Junction {
    shapes::JunctionShape shape;
    std::string kind = "y";
  };
  const auto c = add_shape<Junction>(mesh, "junction", "Tubes that meet", [](const Junction& junction) {
    shapes::JunctionShape shape = junction.shape;
    using Kind = shapes::JunctionShape::Kind;
    shape.kind = junction.kind == "y" ? Kind::y : junction.kind == "t" ? Kind::t : Kind::x;
    return shapes::make_junction(shape);
  });
  CLI::App& sub = *mesh.get_subcommand("junction");
  sub.add_option("--kind", c->shape.kind,
                 "Three arms at 120 degrees (y), three as a T (t), four as a cross (x)")
      ->check(CLI::IsMember({"y", "t", "x"}))
      ->capture_default_str();
  shapes::JunctionShape& shape = c->shape.shape;
  length(mesh, "junction", "--tube-radius", shape.tube_radius, "Radius of the tubes");
  length(mesh, "junction", "--arm-length", shape.arm_length, "From the middle to the end of each arm");
  length(mesh, "junction", "--blend", shape.blend, "Width over which the crease between arms is rounded");
  length(mesh, "junction", "--edge", shape.edge, "Length of the triangles' edges");
  sub.add_flag_callback(
      "--closed", [&shape] { shape.open = false; }, "Round ends, instead of boundaries");
}

void add_minimal_surface(CLI::App& mesh, const char* name, const char* description,
                         shapes::MinimalSurfacePiece::Kind kind) {
  const auto c =
      add_shape<shapes::MinimalSurfacePiece>(mesh, name, description, shapes::make_minimal_surface_piece);
  c->shape.kind = kind;
  length(mesh, name, "--period", c->shape.period, "Period of the surface");
  length(mesh, name, "--edge", c->shape.edge, "Length of the triangles' edges");
  CLI::App& sub = *mesh.get_subcommand(name);
  sub.add_option("--cells", c->shape.cells, "Edge of the cube that it is cut from, in periods")
      ->check(above_zero())
      ->capture_default_str();
  sub.add_option("--thickness", c->shape.thickness,
                 "Thickness of a closed shell around the surface, mesh units (0: the surface itself, with "
                 "boundaries)")
      ->check(zero_or_more())
      ->capture_default_str();
}

void add_periodic_surface(CLI::App& mesh, shapes::MinimalSurface::Kind kind, const char* description) {
  struct Periodic {
    shapes::MinimalSurface surface;
    std::vector<int> cells;
  };
  const std::string name(shapes::name(kind));
  const auto c = add_shape<Periodic>(mesh, name.c_str(), description, [](const Periodic& p) {
    shapes::MinimalSurface surface = p.surface;
    surface.cells = cells_each_way(p.cells);
    return shapes::make_minimal_surface(surface);
  });
  shapes::MinimalSurface& surface = c->shape.surface;
  surface.kind = kind;
  length(mesh, name.c_str(), "--period", surface.period, "Edge of the cubic cell");
  length(mesh, name.c_str(), "--edge", surface.edge, "Length of the triangles' edges");
  CLI::App& sub = *mesh.get_subcommand(name);
  sub.add_option("--cells", c->shape.cells, "Number of cells, along every edge or along each (1)")
      ->expected(1, 3)
      ->delimiter(',')
      ->check(between(1, 100))
      ->type_name("N");
  sub.add_flag("--primitive", surface.primitive,
               "The primitive cell instead of the cube, where the cube is centred");
  sub.add_option("--level", surface.level, "Value of the nodal function on the surface (0: the minimal one)")
      ->check(between(-3.0, 3.0))
      ->capture_default_str();
}

void add_foam(CLI::App& mesh) {
  const auto c = add_shape<shapes::Foam>(
      mesh, "foam", "A random porous surface in a periodic cube: a level set of a Gaussian random field",
      shapes::make_foam);
  length(mesh, "foam", "--size", c->shape.size, "Edge of the cube");
  CLI::App& sub = *mesh.get_subcommand("foam");
  sub.add_option("--edge", c->shape.edge,
                 "Length of the triangles' edges, mesh units (default: 0.06 wavelengths)")
      ->check(above_zero());
  sub.add_option("--waves", c->shape.waves, "Wavelengths of the field along the cube's edge")
      ->check(between(1.0, 30.0))
      ->capture_default_str();
  sub.add_option("--thickness", c->shape.thickness,
                 "Least thickness of necks and walls, mesh units (default: 0.2 wavelengths; 0: as the field "
                 "has them)")
      ->check(zero_or_more());
  sub.add_option("--level", c->shape.level, "Level of the field, in standard deviations")
      ->check(between(-1.0, 1.0))
      ->capture_default_str();
  sub.add_option("--seed", c->shape.seed, "Seed of the field")
      ->transform(whole_number())
      ->check(zero_or_more())
      ->capture_default_str();
}

void add_formula(CLI::App& mesh) {
  struct Formula {
    shapes::FormulaSurface surface;
    CellOptions cell;
  };
  const auto c = add_shape<Formula>(
      mesh, "implicit",
      "The surface where a formula of x, y and z has a given value, in a periodic cell or box",
      [](const Formula& f) {
        shapes::FormulaSurface surface = f.surface;
        const mesh::CellRequest request = cell_request(f.cell);
        surface.cell.vectors = *request.vectors;
        if (request.periodic) surface.cell.periodic = *request.periodic;
        return shapes::make_formula_surface(surface);
      });
  c->shape.cell.cell = {2 * std::numbers::pi};
  CLI::App& sub = *mesh.get_subcommand("implicit");
  shapes::FormulaSurface& surface = c->shape.surface;
  sub.add_option("FORMULA", surface.formula, "Such as 'cos(x)+cos(y)+cos(z)': see the manual of muParser")
      ->required();
  add_period_options(sub, c->shape.cell);
  sub.add_option("--level", surface.level, "Value of the formula on the surface")->capture_default_str();
  sub.add_option("--thickness", surface.thickness,
                 "The closed shell this thick around the surface, mesh units (0: the surface itself)")
      ->check(zero_or_more())
      ->capture_default_str();
  sub.add_option("--edge", surface.edge,
                 "Length of the edges of its triangles, mesh units; by default a 25th of the shortest "
                 "period, or less where parts of the surface would run into each other")
      ->check(above_zero());
}

}  // namespace

void add_make_mesh(CLI::App& make) {
  CLI::App& mesh = *make.add_subcommand("mesh", "A smooth shape as a triangle mesh, for 'nanocarbon build'");
  mesh.require_subcommand(1);
  add_sphere(mesh);
  add_nested_spheres(mesh);
  add_hemisphere(mesh);
  add_straight(mesh, "capsule", "A cylinder with round ends", shapes::make_capsule);
  add_straight(mesh, "cylinder", "A cylinder with two boundaries", shapes::make_cylinder);
  add_rings(mesh, "torus", "A torus", shapes::make_torus);
  add_rings(mesh, "genus-two", "Two tori side by side, grown together", shapes::make_genus_two);
  add_helix(mesh);
  add_junction(mesh);
  add_minimal_surface(mesh, "gyroid-piece", "The part of the gyroid inside a cube",
                      shapes::MinimalSurfacePiece::Kind::gyroid);
  add_minimal_surface(mesh, "schwarz-p-piece", "The part of Schwarz's P surface inside a cube",
                      shapes::MinimalSurfacePiece::Kind::schwarz_p);
  add_minimal_surface(mesh, "schwarz-d-piece", "The part of Schwarz's D surface inside a cube",
                      shapes::MinimalSurfacePiece::Kind::schwarz_d);
  using Kind = shapes::MinimalSurface::Kind;
  add_periodic_surface(mesh, Kind::gyroid, "The gyroid in a periodic cell");
  add_periodic_surface(mesh, Kind::schwarz_p, "Schwarz's P surface in a periodic cell");
  add_periodic_surface(mesh, Kind::schwarz_d, "Schwarz's D surface in a periodic cell");
  add_periodic_surface(mesh, Kind::iwp, "Schoen's I-WP surface in a periodic cell");
  add_periodic_surface(mesh, Kind::neovius, "Neovius's surface in a periodic cell");
  add_periodic_surface(mesh, Kind::frd, "Schoen's F-RD surface in a periodic cell");
  add_periodic_surface(mesh, Kind::fischer_koch_s, "Fischer and Koch's S surface in a periodic cell");
  add_periodic_surface(mesh, Kind::lidinoid, "The lidinoid in a periodic cell");
  add_foam(mesh);
  add_formula(mesh);
  mesh.footer(R"(Lengths are in mesh units; 'nanocarbon build' has options for the size in Angstrom.
Examples:
  nanocarbon make mesh torus --major 3 --minor 1 --edge 0.2 -o torus.off
  nanocarbon make mesh junction --kind y --tube-radius 1 --arm-length 5 -o junction.off
  nanocarbon make mesh gyroid-piece --cells 1.5 -o gyroid.ply
  nanocarbon make mesh schwarz-p -o p.off
  nanocarbon make mesh foam --waves 3 --seed 7 -o foam.off
  nanocarbon make mesh implicit 'sin(x)*cos(y)+sin(y)*cos(z)+sin(z)*cos(x)' -o gyroid.off
  nanocarbon make mesh implicit 'z-0.3*sin(x)*sin(y)' --periodic xy -o ripples.off)");
}

}  // namespace nanocarbon::cli
