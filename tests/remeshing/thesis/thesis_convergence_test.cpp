// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>

#include "nanocarbon/remeshing/thesis/thesis_recipe.h"
#include "remeshing/shapes.h"
#include "remeshing/topology.h"

namespace nanocarbon::thesis {
namespace {

ThesisResult remeshed(const TriangleMesh& surface, std::size_t triangles, ThesisOptions options = {}) {
  return remesh_by_thesis(test::sized(surface, static_cast<double>(triangles)), options);
}

// What the thesis promises where it converges: no bond-bearing edge outside, and its valences of 5 to 7.
TEST(ThesisConvergence, ConvergesOnSmoothShapes) {
  for (const TriangleMesh& shape : {test::sphere(1.0, 4), test::torus(3.0, 1.0, 90, 30)}) {
    const ThesisResult result = remeshed(shape, 4000);
    EXPECT_EQ(result.record.stop, ThesisStop::converged);
    EXPECT_LT(result.record.iterations, 150u);
    EXPECT_EQ(result.record.edges.outside(), 0u);
    EXPECT_EQ(result.record.valences.outside_5_to_7(), 0u);
    // Euler: fives less sevens is six times the characteristic.
    const long sum =
        static_cast<long>(result.record.valences.inner[5]) - static_cast<long>(result.record.valences.inner[7]);
    EXPECT_EQ(sum, 6 * test::topology_of(shape).euler_characteristic);
    const LengthInterval interval = edge_interval(1.2, 1.8);
    for (const Triangle& t : result.mesh.triangles)
      for (int k = 0; k < 3; ++k) {
        const double length = (result.mesh.points[t[k]] - result.mesh.points[t[(k + 1) % 3]]).norm();
        EXPECT_TRUE(interval.contains(length)) << length;
      }
  }
}

TEST(ThesisConvergence, MeetsTheNumberOfAtomsAskedFor) {
  for (const std::size_t atoms : {1500u, 4000u}) {
    ThesisOptions options;
    options.atoms = atoms;
    options.projection_interval = 0;
    const TriangleMesh surface = test::sized(test::torus(3.0, 1.0, 60, 20), static_cast<double>(atoms));
    const ThesisResult result = remesh_by_thesis(surface, options);
    const auto made = static_cast<double>(result.mesh.triangles.size());
    EXPECT_NEAR(made, static_cast<double>(atoms), 0.015 * static_cast<double>(atoms));
    // The mesh lies on the surface times `scale`: their areas are the same, but for what its chords cut off.
    EXPECT_NEAR(mesh::area(result.mesh) / (mesh::area(surface) * result.scale * result.scale), 1.0, 0.02);
  }
}

TEST(ThesisConvergence, ForerunnersDifferAsTheirPapersDo) {
  const TriangleMesh shape = test::torus(3.0, 1.0, 60, 20);
  // Too few iterations to converge.
  const auto short_of = [](ThesisOptions options) {
    options.iterations = 15;
    return options;
  };
  const ThesisResult pecanha = remeshed(shape, 2400, short_of(pecanha2013_options()));
  EXPECT_EQ(pecanha.record.local_iterations, 0u);
  EXPECT_EQ(pecanha.record.local.candidates + pecanha.record.post_processing.candidates, 0u);
  EXPECT_EQ(pecanha.record.valence.passes, pecanha.record.iterations);
  const ThesisResult hauck2014 = remeshed(shape, 2400, short_of(hauck2014_options()));
  EXPECT_EQ(hauck2014.record.local_iterations, 0u);
  // Post-processing at the end is what 2014 adds: it leaves fewer edges outside than there were.
  EXPECT_GT(hauck2014.record.post_processing.minimised, 0u);
  EXPECT_LT(hauck2014.record.edges.outside(), hauck2014.record.history.back().outside());
  const ThesisResult hauck2015 = remeshed(shape, 2400, short_of(hauck2015_options()));
  EXPECT_EQ(hauck2015.record.valence.passes, hauck2015.record.iterations);
  EXPECT_GT(hauck2015.record.projection_replacements, 0u);
  for (const ThesisResult* result : {&pecanha, &hauck2014, &hauck2015})
    EXPECT_EQ(test::topology_of(result->mesh), test::topology_of(shape));
}

}  // namespace
}  // namespace nanocarbon::thesis
