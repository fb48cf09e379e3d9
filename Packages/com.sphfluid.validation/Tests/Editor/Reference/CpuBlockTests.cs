using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The blocks of the CPU solver, in double precision, against brute force over all pairs and all triangles.</summary>
    public sealed class CpuBlockTests
    {
        private static readonly Vector3 Domain = new Vector3(0.4f, 0.4f, 0.4f);

        [Test]
        public void DensityAndPressureAreTheReference([Values(1, 257, 1009)] int count, [Values] bool octant, [Values] bool self)
        {
            FluidSolverSettings settings = Settings(octant);
            settings = settings.WithOwn((ref ThesisSettings own) => own.SelfDensity = self);
            settings.PressureClamp = !self;
            using (var solver = new CpuFluidSolver(settings, Particles(count)))
            {
                solver.UpdateDensity();
                FluidParticle[] particles = solver.ToFloat();
                for (int i = 0; i < count; i++)
                {
                    double expected = ThesisReference.Density(particles, i, settings);
                    Assert.That(solver.Density[i], Is.EqualTo(expected).Within(1e-11 * settings.RestDensity), $"density of {i}");
                    double pressure = ThesisReference.Pressure(solver.Density[i], settings);
                    Assert.That(solver.Pressure[i], Is.EqualTo(pressure).Within(1e-10 * Math.Abs(pressure)), $"pressure of {i}");
                }
            }
        }

        [Test]
        public void AccelerationIsTheReference([Values(1, 257, 1009)] int count, [Values] bool closed)
        {
            FluidSolverSettings settings = Settings(octant: closed);
            ReferenceMesh[] meshes = CpuScenes.Meshes(closed);
            using (var solver = new CpuFluidSolver(settings, Particles(count)))
            {
                CpuScenes.AddMeshes(solver, meshes);
                solver.UpdateDensity();
                FluidParticle[] particles = solver.ToFloat();
                solver.Step(1);

                // The reference takes densities in float, which is all of the difference.
                float[] density = solver.Density.ToArray().Select(d => (float)d).ToArray();
                float[] pressure = solver.Pressure.ToArray().Select(p => (float)p).ToArray();
                int touching = 0;
                for (int i = 0; i < count; i++)
                {
                    Double3 fluid = ThesisReference.Force(particles, density, pressure, i, settings, out double magnitude) / density[i];
                    double scale = magnitude / density[i];
                    fluid = Math.Min(1.0, settings.Own<ThesisSettings>().AccelerationLimit / Math.Max(1e-30, fluid.Length)) * fluid;
                    Double3 collision = CollisionReference.Force(meshes, particles[i].Position, particles[i].VelT0, settings);
                    touching += collision.Length > 0.0 ? 1 : 0;
                    Double3 expected = fluid + collision + settings.Gravity;
                    var actual = new Double3(solver.Acceleration[i].x, solver.Acceleration[i].y, solver.Acceleration[i].z);
                    double tolerance = 1e-6 * scale + 1e-11 * (expected.Length + 1.0);
                    Assert.That((actual - expected).Length, Is.LessThan(tolerance), $"particle {i}");
                }

                Assert.That(touching, Is.GreaterThanOrEqualTo(count / 50), "the set exercises the collision");
            }
        }

        [Test]
        public void SortKeepsTheOrderWithinACell()
        {
            FluidSolverSettings settings = Settings(octant: true);
            FluidParticle[] initial = Particles(1009);
            using (var solver = new CpuFluidSolver(settings, initial))
            {
                solver.UpdateDensity();
                FluidGrid grid = FluidGrid.For(settings);
                var neighbours = new CpuNeighbours(grid, settings, default);
                IEnumerable<uint> expected = initial.OrderBy(p => neighbours.Cell(CpuFluidParticle.Double(p.Position))).ThenBy(p => p.Id)
                    .Select(p => p.Id);
                Assert.That(solver.ToFloat().Select(p => p.Id), Is.EqualTo(expected));
            }
        }

        private static FluidSolverSettings Settings(bool octant)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.02f);
            settings.OctantSearch = octant;
            return settings;
        }

        private static FluidParticle[] Particles(int count) => ParticleSets.Random(count, Domain, 4f, count);
    }
}
