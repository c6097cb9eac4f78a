// SPDX-License-Identifier: BSD-3-Clause
// The equations of finite-element radiosity, and their solution.
//
// E(x) is the illuminance of x by reflected light, B = rho (D + E) with D the direct illuminance, and
//
//   E(x_k) = sum over the elements j of  F(x_k, j) V(x_k, y) B(y),   y in j
//
// at three points x_k of every element: F is Lambert's polygon formula, V is traced to a point y drawn uniformly from
// the solid angle of j where that is near, else from its area. Constant elements have the mean over the three; linear
// ones the plane through them (Gauss's points of the second degree, so that this is Galerkin's projection of E).
#ifndef kalos_estimator_methods_RadiositySystem_h
#define kalos_estimator_methods_RadiositySystem_h

#include "estimator/control/Workers.h"
#include "estimator/direct/DirectLight.h"
#include "estimator/methods/RadiosityMesh.h"

namespace kalos
{
class RadiositySystem
{
public:
  /// Both must outlive the system. `shadows` false: nothing can occlude.
  RadiositySystem(const Scene& scene, const RadiosityMesh& mesh, const DirectLight& luminaires, bool linear,
                  bool shadows);

  static constexpr int points = 3;  ///< of an element

  /// Bytes of the form factors of so many elements.
  static double bytes(std::size_t elements, bool linear)
  {
    const double unknowns = static_cast<double>(elements) * (linear ? points : 1);
    return unknowns * unknowns * sizeof(float);
  }

  /// Draws form factors and solves by Gauss-Seidel iteration. Returns false when aborted.
  bool solve(std::uint64_t seed, int replicate, Workers& workers);

  /// Largest change of an unknown in the last iteration over the largest unknown, and the number of iterations.
  double residual() const { return this->Residual; }
  int iterations() const { return this->Iterations; }

  /// At a place of the mesh, lx per band: illuminance by light that was reflected once or more, and that straight from
  /// emitting meshes.
  Bands reflected(const RadiosityMesh::Place& place) const { return this->at(place, this->Reflected); }
  Bands meshes(const RadiosityMesh::Place& place) const { return this->at(place, this->FromMeshes); }

  /// What the surface reflects there, lm/m2 per band.
  Bands exitance(const RadiosityMesh::Place& place) const;

private:
  std::size_t unknowns() const { return this->Mesh.elements().size() * this->Each; }
  Vec3 point(std::size_t element, int k) const;
  Bands at(const RadiosityMesh::Place& place, const std::vector<Bands>& values) const;
  void drawRows(std::size_t element, std::uint64_t seed, int replicate);
  void drawDirect(std::size_t element, std::uint64_t seed, int replicate);
  // Form factor from x to element j, its weights of the corners, and whether a shadow ray must be traced to y.
  double formFactor(const Vec3& x, const Vec3& n, std::size_t j, SampleStream& random, Vec3& y, double* weight) const;
  void iterate();

  const Scene& Scene_;
  const RadiosityMesh& Mesh;
  const DirectLight& Luminaires;
  std::size_t Each;  // unknowns of an element
  bool Shadows;
  std::vector<float> Matrix;                         // form factors between unknowns, row by row
  std::vector<Bands> Direct, FromMeshes, Reflected;  // lx, per unknown
  double Residual = 0;
  int Iterations = 0;
};
}  // namespace kalos

#endif
