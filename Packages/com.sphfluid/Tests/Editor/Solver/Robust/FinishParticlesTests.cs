using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class FinishParticlesTests
    {
        private const float Spacing = 0.05f;
        private const float TimeStep = 1f / 240f;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.35f, 0.36f);
        private static readonly FluidStep Step = new FluidStep(TimeStep, TimeStep, false);

        [TestCase(1, FluidAxes.None)]
        [TestCase(63, FluidAxes.All)]
        [TestCase(64, FluidAxes.None)]
        [TestCase(65, FluidAxes.X)]
        [TestCase(251, FluidAxes.None)]
        public void VelocitiesAreTheDisplacements(int count, FluidAxes periodic)
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing, periodic);
            settings.Viscosity = 2f;
            using (var rig = new RobustStateRig(settings, count))
            {
                FluidParticle[] particles = Prepared(rig);
                var pass = new FinishParticlesPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State, Step, false));
                Vector4[] velocities = GpuTest.Read<Vector4>(rig.State.Buffers.NewVelocities, count),
                    places = GpuTest.Read<Vector4>(rig.State.Buffers.NewPositions, count);
                Vector4[] carried = GpuTest.Read<Vector4>(rig.State.Motion.NewStarts, count);
                RobustStateRig.AssertCounted(rig.State, places, Enumerable.Range(0, count).ToArray());
                for (int i = 0; i < count; i++)
                {
                    Assert.That(((Vector3)velocities[i] - particles[i].VelT0).magnitude, Is.LessThan(1e-3f), $"velocity of {i}");
                    Assert.That(RobustStateRig.ToBits(velocities[i].w), Is.EqualTo(particles[i].Id));
                    Assert.That(((Vector3)places[i] - particles[i].Position).magnitude, Is.LessThan(1e-6f));
                    Assert.That(carried[i].w, Is.EqualTo(1e-6f * i * settings.RestDensity / (TimeStep * TimeStep)).Within(1e-3).Percent,
                        "pressure");
                }
            }
        }

        [TestCase(251, FluidAxes.None)]
        [TestCase(257, FluidAxes.Y)]
        public void TheLastMotionIsThatOfAnyIteration(int count, FluidAxes periodic)
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing, periodic);
            settings.Viscosity = 0f;
            using (var rig = new RobustStateRig(settings, count))
            {
                Prepared(rig, true);
                CellBuffers buffers = rig.State.Buffers;
                Vector4[] before = GpuTest.Read<Vector4>(buffers.NewPositions, count);
                var move = new MoveByConstraintsPass(rig.Shaders);
                var finish = new FinishParticlesPass(rig.Shaders);
                Vector4[] displacements = GpuTest.Read<Vector4>(rig.State.Motion.Displacements, count);
                GpuTest.Run(cmd => move.Record(cmd, rig.State, TimeStep, 2, false));
                Vector4[] moved = GpuTest.Read<Vector4>(buffers.NewPositions, count);
                rig.State.Motion.Displacements.SetData(displacements);
                buffers.NewPositions.SetData(before);
                GpuTest.Run(cmd => finish.Record(cmd, rig.State, Step, false));
                Vector4[] finished = GpuTest.Read<Vector4>(buffers.NewPositions, count),
                    carried = GpuTest.Read<Vector4>(rig.State.Motion.NewStarts, count);
                double factor = settings.RestDensity / (TimeStep * TimeStep);
                for (int i = 0; i < count; i++)
                {
                    Assert.That(((Vector3)(finished[i] - moved[i])).magnitude, Is.LessThan(1e-6f * Spacing), $"place of {i}");
                    Assert.That(carried[i].w, Is.EqualTo(-moved[i].w * factor).Within(1e-3).Percent, $"pressure of {i}");
                }
                Assert.That(Enumerable.Range(0, count).Max(i => ((Vector3)(moved[i] - before[i])).magnitude),
                    Is.GreaterThan(1e-3f * Spacing));
            }
        }

        [Test]
        public void WhatIsNoNumberStaysWhereItWasPredicted()
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing);
            using (var rig = new RobustStateRig(settings, 3))
            {
                FluidParticle[] particles = Prepared(rig);
                Vector4[] displacements = GpuTest.Read<Vector4>(rig.State.Motion.Displacements, 3);
                displacements[1].y = float.NaN;
                rig.State.Motion.Displacements.SetData(displacements);
                var pass = new FinishParticlesPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State, Step, false));
                Vector4[] after = GpuTest.Read<Vector4>(rig.State.Buffers.NewPositions, 3),
                    velocities = GpuTest.Read<Vector4>(rig.State.Buffers.NewVelocities, 3);
                Assert.That((Vector3)after[1], Is.EqualTo(particles[1].Position));
                Assert.That((Vector3)velocities[1], Is.EqualTo(Vector3.zero));
                Assert.That(rig.Counters()[2], Is.EqualTo(1u));
            }
        }

        // Particles as an iteration left them, and what the last one has found: that it changes the multipliers of -i 1e-6 m2, or not.
        private static FluidParticle[] Prepared(RobustStateRig rig, bool changes = false)
        {
            FluidParticle[] particles = rig.Constrained(TimeStep);
            if (!changes) rig.SetTerms(new Vector2[particles.Length]);
            rig.State.Motion.Starts.SetData(particles.Select(p => RobustStateRig.WithW(p.Position - TimeStep * p.VelT0, 0f)).ToArray());
            rig.State.Motion.Displacements
                .SetData(particles.Select(p => RobustStateRig.WithW(TimeStep * p.VelT0, RobustStateRig.FromBits(p.Id))).ToArray());
            rig.State.Buffers.NewPositions.SetData(particles.Select((p, i) => RobustStateRig.WithW(p.Position, -1e-6f * i)).ToArray());
            return particles;
        }
    }
}
