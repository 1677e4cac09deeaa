#include "nanocarbon/relaxation/surface_fit.h"

#include <gmock/gmock.h>

#include "nanocarbon/structures/shapes.h"

namespace nanocarbon {
namespace {

double mean_distance(std::span<const Vec3> positions, const TetherSurface& surface) {
  double sum = 0;
  for (const Vec3& p : positions) sum += surface.distance(p) / static_cast<double>(positions.size());
  return sum;
}

// No two of its axes alike, so that every motion shows.
TriangleMesh ellipsoid() {
  TriangleMesh mesh = make_sphere(1.0, 4);
  for (Vec3& p : mesh.points) p = Vec3(20 * p.x(), 15 * p.y(), 10 * p.z());
  return mesh;
}

TEST(SurfaceFit, FindsTheMotionThatWasMade) {
  const TriangleMesh mesh = ellipsoid();
  const Mat3 turn = Eigen::AngleAxisd(0.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  std::vector<Vec3> moved;
  for (const Vec3& p : mesh.points) moved.push_back(1.03 * (turn * p) + Vec3(0.5, -0.3, 0.8));
  const TetherSurface surface(mesh, 1);
  const Similarity fit = fit_to_surface(moved, surface, true);
  std::vector<Vec3> back;
  for (const Vec3& p : moved) back.push_back(fit(p));
  EXPECT_NEAR(fit.scale, 1 / 1.03, 1e-3);
  EXPECT_LT(mean_distance(back, surface), 0.02);
  EXPECT_GT(mean_distance(moved, surface), 0.4);
}

TEST(SurfaceFit, KeepsTheSizeWhereThatIsAsked) {
  const TriangleMesh mesh = ellipsoid();
  std::vector<Vec3> larger;
  for (const Vec3& p : mesh.points) larger.push_back(1.05 * p);
  EXPECT_EQ(fit_to_surface(larger, TetherSurface(mesh, 1), false).scale, 1.0);
}

TEST(SurfaceFit, LeavesSymmetriesOfTheSurfaceAlone) {
  const TriangleMesh sphere = make_sphere(10.0, 5);
  std::vector<Vec3> positions = sphere.points;
  for (Vec3& p : positions) p = 1.02 * p + Vec3(0, 0, 0.2);
  const Similarity fit = fit_to_surface(positions, TetherSurface(sphere, 1), true);
  EXPECT_LT((fit.turn - Mat3::Identity()).norm(), 1e-6);
  EXPECT_NEAR(fit.scale, 1 / 1.02, 1e-3);
}

}  // namespace
}  // namespace nanocarbon
