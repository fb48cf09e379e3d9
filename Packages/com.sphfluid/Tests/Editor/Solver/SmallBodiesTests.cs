using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Bodies of a few spacings and less, of any density, dropped, placed among the particles and thrown: the liquid makes none faster than
    /// a fall does, and each is named.
    /// </summary>
    public sealed class SmallBodiesTests
    {
        private const float Spacing = 0.05f, Pitch = 4f, Deep = 6f, High = 14f;
        private const double FrameTime = 1.0 / 60.0;

        private static readonly string[] Starts = { "dropped", "placed", "thrown" };

        private sealed class Small
        {
            public string Row;
            public float Edge, Density, Fastest;
            public Vector3 Start, Throw;
            public FloatingBody Body;

            /// <summary>Speed of its fall to the floor without liquid [m/s].</summary>
            public float Fall => Mathf.Sqrt(Throw.sqrMagnitude + 2f * 9.81f * (Start.y + 0.5f * High * Spacing));
        }

        [TestCase(FluidMethodKind.Standard)]
        [TestCase(FluidMethodKind.Robust)]
        public void NoneIsShotAway(FluidMethodKind method) => Check(method, 9, new[] { 0.1f, 1.5f }, new[] { 100f, 8000f });

        [TestCase(FluidMethodKind.Standard)]
        [TestCase(FluidMethodKind.Robust)]
        [Explicit("The whole table.")]
        public void NoneOfAllIsShotAway(FluidMethodKind method) =>
            Check(method, 30, new[] { 0.1f, 0.2f, 0.4f, 0.6f, 0.8f, 1f, 1.2f, 1.5f, 2f }, new[] { 100f, 250f, 500f, 1000f, 2500f, 8000f });

        private static void Check(FluidMethodKind method, int frames, float[] edges, float[] densities)
        {
            var bodies = new List<Small>();
            foreach (string start in Starts)
                foreach (float density in densities)
                    foreach (float edge in edges)
                    {
                        bodies.Add(new Small
                        {
                            Row = $"{start}, {density} kg/m3", Edge = edge, Density = density,
                            Start = (start == "placed" ? -2.7f : 2f) * Spacing * Vector3.up,
                            Throw = start == "thrown" ? new Vector3(3f, -4f, 0f) : Vector3.zero,
                        });
                    }
            int named = Play(method, frames, bodies);
            foreach (IGrouping<string, Small> row in bodies.GroupBy(b => b.Row))
            {
                TestContext.Out.WriteLine($"{row.Key}: " + string.Join(", ", row.Select(b => $"{b.Edge} dx {b.Fastest / b.Fall:0.00}")));
            }
            Assert.That(named, Is.EqualTo(bodies.Count), "named once each");
            foreach (Small small in bodies) Assert.That(small.Fastest, Is.LessThan(1.5f * small.Fall), $"{small.Row}, {small.Edge} dx");
        }

        private static int Play(FluidMethodKind method, int frames, List<Small> bodies)
        {
            int across = Mathf.CeilToInt(Mathf.Sqrt(bodies.Count)), wide = (int)(across * Pitch), named = 0;
            Vector3 domain = new Vector3(wide, High, wide) * Spacing;
            FluidSolverSettings settings = BodyRig.Water(domain, Spacing, Deep * Spacing, 0f, method);
            FluidParticle[] block = FloatingRig.Block(new Vector3Int(wide, (int)Deep, wide), Spacing, -0.5f * domain);
            using (var rig = new FloatingRig(settings, block))
            {
                for (int i = 0; i < bodies.Count; i++)
                {
                    Small small = bodies[i];
                    small.Start += new Vector3((i % across + 0.53f) * Pitch * Spacing - 0.5f * domain.x, (Deep - 0.5f * High) * Spacing,
                        (i / across + 0.51f) * Pitch * Spacing - 0.5f * domain.z);
                    small.Body =
                        rig.AddBox(small.Edge * Spacing * Vector3.one, small.Density, small.Start, Quaternion.Euler(10f, 20f, 30f));
                    small.Body.Velocity = small.Throw;
                }
                for (int frame = 0; frame < frames; frame++)
                {
                    rig.Frame(Mathf.CeilToInt((float)FrameTime / settings.TimeStep - 1e-4f));
                    named += rig.Obstacles.Messages.Count(m => m.Issue == FluidIssue.BodyTooSmall);
                    FloatingState[] states = rig.Floating.ReadNow();
                    foreach (Small small in bodies)
                    {
                        FloatingState state = states[rig.Floating.NumberOf(small.Body) - 1];
                        // The domain's faces do not hold bodies: what has left it goes on to fall.
                        bool isFalling = state.Centre.y < -0.5f * domain.y && state.Velocity.y < 0f && state.Velocity.y > -10f;
                        if (!isFalling && !(state.Velocity.magnitude <= small.Fastest)) small.Fastest = state.Velocity.magnitude;
                    }
                }
                Assert.That(rig.Solver.ReadCountersNow().NonFinite, Is.Zero);
            }
            return named;
        }
    }
}
