#include "nanocarbon/relaxation/certificate.h"

#include "nanocarbon/rebo2/rebo2.h"
#include "nanocarbon/relaxation/hessian_spectrum.h"
#include "nanocarbon/relaxation/minimise_rebo2.h"

namespace nanocarbon {

Certificate certify(Molecule& molecule, const CertificateOptions& options) {
  const Rebo2MinimisationResult minimised =
      minimise_rebo2(molecule, {.force_tolerance = options.force_tolerance, .max_iterations = 20000});
  Rebo2 rebo2;
  const auto energy = [&](std::span<const Vec3> positions, std::span<Vec3> gradient) {
    const Rebo2Result& result = rebo2.evaluate(positions, molecule.elements);
    for (std::size_t a = 0; a < gradient.size(); ++a) gradient[a] -= result.forces[a];
    return result.energy;
  };
  const HessianSpectrum spectrum =
      smallest_hessian_eigenvalues(molecule.positions, energy, {.count = options.eigenvalues});
  return {minimised.energy, minimised.max_force, spectrum.smallest, spectrum.converged, minimised.intact};
}

}  // namespace nanocarbon
