using System.Linq;
using NUnit.Framework;
using SphFluid.Laboratory;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class SolverLaboratoryTests
    {
        private static readonly Vector3 Domain = 0.4f * Vector3.one;

        private FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders()
        {
            GpuTest.Require();
            shaders = TestShaders.CreateSet();
        }

        [TearDown]
        public void DestroyShaders() => Object.DestroyImmediate(shaders);

        [Test]
        public void ConstantsThatTheSolverRefusesAreTaken()
        {
            using (FluidSolver solver = Solver(FluidMethodKind.Thesis, out FluidSolverSettings settings))
            {
                settings.OctantSearch = !settings.OctantSearch;
                Assert.That(() => solver.ApplySettings(settings), Throws.ArgumentException);
                SolverLaboratory.SetUnchecked(solver, settings);
                Assert.That(solver.Settings.OctantSearch, Is.EqualTo(settings.OctantSearch));

                settings.Method = FluidMethodKind.Standard;
                Assert.That(() => SolverLaboratory.SetUnchecked(solver, settings), Throws.ArgumentException);
            }
        }

        [Test]
        public void WithoutTheResetEmptiedCellsKeepTheirRanges()
        {
            using (FluidSolver solver = Solver(FluidMethodKind.Thesis, out _))
            {
                GpuTest.Run(cmd => solver.RecordNeighbourSetup(cmd));
                FluidParticle[] later = GpuTest.Read<FluidParticle>(solver.Particles, solver.ParticleCount);
                for (int i = 0; i < later.Length; i++) later[i].Position.x = -later[i].Position.x;

                Assert.That(Ranged(solver, later, "ResetGridIndices"), Is.GreaterThan(Ranged(solver, later, null)));
            }
        }

        [Test]
        public void OnlyPassesThatAMethodCanDoWithoutAreLeftOut()
        {
            foreach (FluidMethodKind method in new[] { FluidMethodKind.Thesis, FluidMethodKind.Standard })
            {
                using (FluidSolver solver = Solver(method, out _))
                {
                    GpuTest.Run(cmd => Assert.That(() => SolverLaboratory.RecordNeighbourSetup(solver, cmd, "CalculateDensity"),
                        Throws.ArgumentException.With.Message.Contains("'CalculateDensity'")));
                }
            }
        }

        // Cells with a range after a setup at other places.
        private static int Ranged(FluidSolver solver, FluidParticle[] places, string without)
        {
            solver.Particles.SetData(places);
            GpuTest.Run(cmd => SolverLaboratory.RecordNeighbourSetup(solver, cmd, without));
            return GpuTest.Read<Vector2Int>(solver.GridIndices, solver.CellCount).Count(range => range.y > range.x);
        }

        private FluidSolver Solver(FluidMethodKind method, out FluidSolverSettings settings)
        {
            FluidRuleInput input = method == FluidMethodKind.Thesis ? FluidRuleInput.ThesisWater : FluidRuleInput.Water;
            input.Method = method;
            input.DomainSize = Domain;
            input.Spacing = 0.02f;
            input.LiquidHeight = input.LiquidDepth = 0.2f;
            settings = FluidRules.Derive(input);
            FluidParticle[] particles = ParticleSets.Lattice(new Vector3Int(6, 5, 5), 0.02f, 0f, 1);
            for (int i = 0; i < particles.Length; i++) particles[i].Position.x -= 0.13f;
            return new FluidSolver(settings, shaders, particles);
        }
    }
}
