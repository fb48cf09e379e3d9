using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>Where contact puts single particles at walls of known shape.</summary>
    public sealed class ContactStepTests
    {
        const float Spacing = 0.02f, Rest = 0.1f * Spacing;

        // Ends of steps among triangles that rest.
        static Vector3[] Resolve(IReadOnlyList<Vector3> corners, Vector3[] from, Vector3[] to, out FluidCounters counters)
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            settings.TimeStep = 1e-3f;
            FluidShaderSet set = TestShaders.CreateSet();
            try
            {
                using (var rig = new BodyRig(settings))
                {
                    rig.Add(corners);
                    rig.Start(from.Select((p, i) => new FluidParticle(p, Vector3.zero, (uint)i)).ToArray());
                    rig.Setup();
                    FluidState state = rig.Solver.State;
                    state.Standard.Positions.SetData(from.Select(p => (Vector4)p).ToArray());
                    state.Standard.NewPositions.SetData(to.Select(p => (Vector4)p).ToArray());
                    state.Standard.NewVelocities.SetData(from.Select((p, i) => (Vector4)((to[i] - p) / settings.TimeStep)).ToArray());
                    GpuTest.Run(cmd =>
                    {
                        new GatherWallsPass(set).Record(cmd, state);
                        new ContactPass(set).Record(cmd, state, settings.TimeStep);
                    });
                    counters = rig.Solver.ReadCountersNow();
                    return GpuTest.Read<Vector4>(state.Standard.NewPositions, from.Length).Select(p => (Vector3)p).ToArray();
                }
            }
            finally
            {
                Object.DestroyImmediate(set);
            }
        }

        static readonly Vector3[] floor = { new Vector3(-0.4f, 0f, -0.4f), new Vector3(0f, 0f, 0.4f), new Vector3(0.4f, 0f, -0.4f) };

        [TestCase(0.3f, 0.4f)]
        [TestCase(0.5f, 0.6f)]
        [TestCase(0.85f, 0.9f)] // no farther than the distance of sweeps
        [TestCase(0.95f, 1f)] // then a second plane: it rests too near
        public void APressedParticleIsPushedOffATenthOfTheContactDistanceAStep(float gap, float expected)
        {
            Vector3 from = gap * Rest * Vector3.up;
            Vector3 end = Resolve(floor, new[] { from }, new[] { from + new Vector3(0.001f, -0.003f, 0f) }, out FluidCounters counters)[0];
            Assert.That(end.y / Rest, Is.EqualTo(expected).Within(2e-3f));
            Assert.That(end.x, Is.EqualTo(0.001f).Within(1e-5f), "smooth");
            Assert.That(counters.Contacts, Is.EqualTo(1));
        }

        [Test]
        public void AParticleThatSlidesTooNearIsPushedOffToo()
        {
            Vector3 from = 0.5f * Rest * Vector3.up;
            Vector3 end = Resolve(floor, new[] { from }, new[] { from + new Vector3(0.004f, 0f, 0f) }, out _)[0];
            Assert.That(end.y / Rest, Is.EqualTo(0.6f).Within(2e-3f));
            Assert.That(end.x, Is.EqualTo(0.004f).Within(1e-5f));
        }

        [Test]
        public void InANarrowWedgeEachParticleGoesAsFarAsItIsFree()
        {
            // Two sheets that meet at an angle of 2 degrees; no plane of either lets the step pass.
            const int count = 61;
            float slope = Mathf.Tan(Mathf.Deg2Rad);
            var corners = new List<Vector3>();
            foreach (float side in new[] { -1f, 1f })
                corners.AddRange(new[] { new Vector3(0f, 0f, -0.4f), new Vector3(0f, 0f, 0.4f), new Vector3(0.4f * slope * side, 0.4f, 0f) });
            var from = new Vector3[count];
            var to = new Vector3[count];
            for (int i = 0; i < count; i++)
            {
                from[i] = new Vector3(0f, 0.14f + 1e-3f * i, 1e-3f * (i - 30)); // 1.2 to 1.8 contact distances from both
                to[i] = from[i] + new Vector3(2e-4f, -0.12f, 1e-3f);
            }
            Vector3[] end = Resolve(corners, from, to, out FluidCounters counters);
            Assert.That(counters.ContactFallbacks, Is.GreaterThan(count / 2));
            Assert.That(counters.Squeezed, Is.Zero);
            for (int i = 0; i < count; i++)
            {
                float gap = (end[i].y * slope - Mathf.Abs(end[i].x)) * Mathf.Cos(Mathf.Deg2Rad) / Rest;
                Assert.That(gap, Is.GreaterThan(0.5f), $"particle {i}");
                Assert.That(gap, Is.LessThan(1.02f), $"particle {i} came to where the wedge is as narrow as contact allows");
            }
        }
    }
}
