using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class PredictParticlesTests
    {
        private const float Spacing = 0.05f;
        private const float TimeStep = 1f / 240f;

        private static readonly Vector3 Domain = new Vector3(0.6f, 0.5f, 0.4f);

        // Runs the pass on random particles: what they were, where they come to, their velocities and what the sort takes along.
        private static (FluidParticle[] before, Vector4[] after, Vector4[] velocities, Vector4[] starts) Run(FluidSolverSettings settings,
            int count, bool isLeft, FluidStep step, bool checksCells = true)
        {
            using (var rig = new RobustStateRig(settings, count))
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, settings.DomainSize, 8f, 3));
                CellBuffers buffers = rig.State.Buffers;
                if (isLeft)
                {
                    RobustStateRig.Fill(buffers.NewPositions, particles.Select(p => RobustStateRig.WithW(p.Position, 0f)).ToArray());
                    RobustStateRig.Fill(buffers.NewVelocities,
                        particles.Select(p => RobustStateRig.WithW(p.VelT0, RobustStateRig.FromBits(p.Id))).ToArray());
                    RobustStateRig.Fill(buffers.Positions, new Vector4[count]);
                    RobustStateRig.Fill(buffers.Velocities, new Vector4[count]);
                }
                var pass = new PredictParticlesPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State, step, isLeft));
                Vector4[] after = GpuTest.Read<Vector4>(buffers.NewPositions, count);
                if (checksCells) RobustStateRig.AssertCounted(rig.State, after, Enumerable.Range(0, count).ToArray());
                return (particles, after, GpuTest.Read<Vector4>(buffers.NewVelocities, count),
                    GpuTest.Read<Vector4>(rig.State.Motion.NewStarts, count));
            }
        }

        [Test]
        public void GravityMovesThemAndFacesHoldThem([Values(1, 63, 64, 65, 257)] int count, [Values] bool isLeft)
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing);
            (FluidParticle[] before, Vector4[] after, Vector4[] velocities, Vector4[] starts) =
                Run(settings, count, isLeft, new FluidStep(TimeStep, TimeStep, false));
            Vector3 half = 0.5f * Domain;
            for (int i = 0; i < count; i++)
            {
                Assert.That((Vector3)starts[i], Is.EqualTo(before[i].Position));
                Assert.That(RobustStateRig.ToBits(velocities[i].w), Is.EqualTo(before[i].Id));
                for (int axis = 0; axis < 3; axis++)
                {
                    double x = before[i].Position[axis], v = before[i].VelT0[axis] + (double)TimeStep * settings.Gravity[axis],
                        shell = 0.25 * Spacing;
                    double low = -System.Math.Max(x + half[axis] - shell, 0.0) / TimeStep,
                        high = System.Math.Max(half[axis] - x - shell, 0.0) / TimeStep;
                    double held = System.Math.Min(System.Math.Max(v, low), high);
                    Assert.That(velocities[i][axis], Is.EqualTo(held).Within(1e-4), $"velocity of {i}");
                    Assert.That(after[i][axis], Is.EqualTo(x + TimeStep * held).Within(2e-6), $"place of {i}");
                }
            }
        }

        [Test]
        public void TheFirstStepKicksByHalf()
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing, FluidAxes.All);
            (FluidParticle[] before, _, Vector4[] velocities, _) = Run(settings, 65, false, new FluidStep(TimeStep, TimeStep, true));
            for (int i = 0; i < before.Length; i++)
            {
                Assert.That(velocities[i].y - before[i].VelT0.y, Is.EqualTo(0.5f * TimeStep * settings.Gravity.y).Within(1e-5));
            }
        }

        [Test]
        public void WhatPassesAPeriodicFaceComesInAtTheOther()
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing, FluidAxes.All);
            (FluidParticle[] before, Vector4[] after, _, _) = Run(settings, 257, false, new FluidStep(0.02f, 0.02f, false));
            Assert.That(Enumerable.Range(0, 257).Count(i => Mathf.Abs(after[i].x - before[i].Position.x) > 0.4f), Is.GreaterThan(5));
            foreach (Vector4 place in after)
                for (int axis = 0; axis < 3; axis++) Assert.That(Mathf.Abs(place[axis]), Is.LessThanOrEqualTo(0.5f * Domain[axis]));
        }

        [Test]
        public void BeyondAnOpenFaceTheyLeave()
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing);
            settings.Boundaries.Open = FluidFaces.HighX;
            (FluidParticle[] before, Vector4[] after, _, _) = Run(settings, 257, false, new FluidStep(0.02f, 0.02f, false));
            bool[] leaves = before.Select(p => p.Position.x + 0.02f * p.VelT0.x > 0.5f * Domain.x).ToArray();
            Assert.That(leaves.Count(l => l), Is.GreaterThan(5));
            Assert.That(after.Select(p => p.w < 0f), Is.EqualTo(leaves));
        }
    }
}
