using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>DriftParticles does with given velocities what MoveParticles does with those that its forces make.</summary>
    public sealed class DriftParticlesTests
    {
        private const float Spacing = 0.05f;
        private const float TimeStep = 1e-3f;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.5f, 0.35f);

        [Test]
        public void ParticlesMoveAsMoveParticlesMovesThem([Values(1, 63, 64, 65, 1009)] int count,
            [Values(FluidAxes.None, FluidAxes.X)] FluidAxes periodic)
        {
            FluidSolverSettings settings = StandardStateRig.Water(Domain, Spacing, periodic);
            settings.Gravity = Vector3.zero;
            settings.Boundaries.Open = FluidFaces.HighY;
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] start = rig.FillSorted(ParticleSets.Random(count, 1.02f * Domain, 30f, 4)); // some beyond a face, some fast
                rig.SetTerms(new Vector2[count]);
                rig.State.List.Counts.SetData(new uint[count]); // nobody feels another
                rig.State.RequireViscous();
                StandardStateRig.Fill(rig.State.Viscous.Diffused, start.Select(p => StandardStateRig.WithW(p.VelT0, 0f)).ToArray());
                var step = new FluidStep(TimeStep, TimeStep, false);
                var move = new MoveParticlesPass(rig.Shaders);
                GpuTest.Run(cmd => move.Record(cmd, rig.State, step));
                (Vector4[] places, Vector4[] velocities, uint[] counters, uint[] cells) expected = Read(rig);
                StandardStateRig.EmptyCells(rig.State);
                rig.State.Published.Counters.SetData(new uint[CounterReadback.Slots]);
                var drift = new DriftParticlesPass(rig.Shaders);
                GpuTest.Run(cmd => drift.Record(cmd, rig.State, step));
                (Vector4[] places, Vector4[] velocities, uint[] counters, uint[] cells) = Read(rig);
                Assert.That(places, Is.EqualTo(expected.places));
                Assert.That(velocities, Is.EqualTo(expected.velocities));
                Assert.That(counters, Is.EqualTo(expected.counters));
                Assert.That(cells, Is.EqualTo(expected.cells));
                Assert.That(places.Zip(start, (a, b) => (Vector3)a != b.Position).Count(moved => moved), Is.GreaterThan(count / 2));
            }
        }

        private static (Vector4[], Vector4[], uint[], uint[]) Read(StandardStateRig rig)
        {
            int count = rig.State.ParticleCount;
            return (GpuTest.Read<Vector4>(rig.State.Buffers.NewPositions, count),
                GpuTest.Read<Vector4>(rig.State.Buffers.NewVelocities, count),
                rig.Counters(), rig.State.Buffers.CellCount.Read<uint>(rig.State.Cells.CellCount + 1));
        }
    }
}
