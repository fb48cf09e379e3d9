using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A dam break, frame by frame: column, splash, wave and drops.</summary>
    public sealed class SparseSurfaceMotionTests
    {
        private const int Frames = 16;
        private const int StepsAFrame = 30;
        private const float Spacing = 0.03f;

        private static readonly Vector3 Domain = new Vector3(0.9f, 0.6f, 0.12f);
        private static readonly Vector3Int Column = new Vector3Int(12, 16, 4);

        [Test]
        public void SurfaceOfADamBreakIsClosedInEveryFrame()
        {
            FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
            FluidRuleInput input = FluidRuleInput.Water;
            input.DomainSize = Domain;
            input.Spacing = Spacing;
            input.LiquidHeight = Column.y * Spacing;
            input.LiquidDepth = Column.y * Spacing;
            FluidParticle[] particles = ParticleSets.Lattice(Column, Spacing, 0.05f * Spacing, 1);
            for (int i = 0; i < particles.Length; i++) particles[i].Position -= 0.5f * (Domain - Spacing * (Vector3)Column);

            var volumes = new List<double>();
            using (var solver = new FluidSolver(FluidRules.Derive(input), shaders, particles))
            using (var surface = new SparseSurface(shaders))
            {
                SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, solver.Settings);
                SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, field.CellSize);
                for (int frame = 0; frame < Frames; frame++)
                {
                    GpuTest.Run(cmd =>
                    {
                        solver.RecordSteps(cmd, StepsAFrame);
                        surface.Record(cmd, solver, field, grid, SurfaceWalls.Closed);
                    });
                    SurfaceMesh mesh = surface.ReadMesh();
                    MeshChecks.AssertClosed(mesh);
                    volumes.Add(mesh.Volume() / (particles.Length * Spacing * Spacing * Spacing));
                    Assert.AreEqual(0, surface.Status.OpenFaces, $"frame {frame}");
                    Assert.AreEqual(0, surface.Status.LateBlocks, $"frame {frame}");
                }
                Assert.IsNull(surface.TakeWarning());
            }
            // Drops and sheets come out thicker than they are.
            TestContext.WriteLine(
                $"volume of the mesh over that of the particles: {volumes[0]:F3} at first, {volumes.Max():F3} at most, " +
                $"{volumes[Frames - 1]:F3} at last");
            foreach (double volume in volumes) Assert.AreEqual(1.0, volume, 0.25);
        }
    }
}
