using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class RobustMomentumTests
    {
        [Test]
        public void TwoBlocksThatCollideKeepTheirMomentum()
        {
            const float dx = 0.05f;
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = FluidMethodKind.Robust;
            input.DomainSize = new Vector3(1.5f, 1f, 1f);
            input.Spacing = dx;
            input.Gravity = Vector3.zero;
            input.InitialSpeed = 1f;
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.Boundaries.Periodic = FluidAxes.All; // no wall takes any
            FluidParticle[] block = ParticleSets.Lattice(6 * Vector3Int.one, dx, 0.05f * dx, 1);
            var start = new FluidParticle[2 * block.Length];
            for (int i = 0; i < block.Length; i++)
            {
                start[i] = new FluidParticle(block[i].Position - 0.2f * Vector3.right, new Vector3(1f, 0.2f, 0f), (uint)i);
                start[block.Length + i] = new FluidParticle(block[i].Position + new Vector3(0.2f, 0.06f, 0f), new Vector3(-0.5f, 0.2f, 0f),
                    (uint)(block.Length + i));
            }
            using (var liquid = new RobustLiquid(settings, start))
            {
                (Double3 before, double size) = Momentum(start);
                for (int frame = 0; frame < 20; frame++) liquid.Frame(10);
                Double3 after = Momentum(liquid.Particles()).momentum;
                TestContext.Out
                    .WriteLine(
                        $"momentum of {before} has changed by {(after - before).Length / size:G2}, speed {liquid.Speed():G3} m/s at " +
                        $"{liquid.Solver.SimulatedTime:G3} s");
                Assert.That((after - before).Length / size, Is.LessThan(1e-5));
                Assert.That(liquid.Speed(), Is.LessThan(0.75), "they have collided");
            }
        }

        // Sum of the velocities, and of the speeds.
        private static (Double3 momentum, double size) Momentum(FluidParticle[] particles)
        {
            var sum = new Double3();
            double size = 0.0;
            foreach (FluidParticle particle in particles)
            {
                sum += particle.VelT0;
                size += ((Double3)particle.VelT0).Length;
            }
            return (sum, size);
        }
    }
}
