using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>ResolveContacts on lists that the test makes, at walls where the end of each step is known.</summary>
    public sealed class ResolveContactsTests
    {
        private const float Spacing = 0.02f;
        private const float Rest = 0.1f * Spacing;
        private const float TimeStep = 1e-3f;

        private static readonly Vector3[] Floor =
        {
            new Vector3(-0.4f, 0f, -0.4f), new Vector3(0f, 0f, 0.4f), new Vector3(0.4f, 0f, -0.4f),
        };

        // A third of the particles goes through the floor, a third comes near it, a third stays off.
        [Test]
        public void ListedParticlesStopAtTheContactDistanceAndOthersAreLeftAlone(
            [Values(0, 1, 63, 64, 65, 257)] int listed)
        {
            const int count = 300;
            var random = new System.Random(listed);
            var from = new Vector3[count];
            var to = new Vector3[count];
            for (int i = 0; i < count; i++)
            {
                from[i] = Vector3.Scale(ParticleSets.RandomVector(random), new Vector3(0.1f, 0f, 0.1f));
                from[i].y = Rest * (1.2f + 5f * (float)random.NextDouble());
                float end = i % 3 == 0 ? -0.05f : i % 3 == 1 ? 0.5f * Rest : 1.5f * Rest;
                to[i] = from[i] + 0.02f * ParticleSets.RandomVector(random);
                to[i].y = end;
            }

            int[] list = Enumerable.Range(0, count).OrderBy(_ => random.Next()).Take(listed).ToArray();
            using (var rig = new BodyRig(Settings()))
            {
                rig.Add(Floor);
                Vector4[] places = Resolve(rig, from, to, list, out Vector3[] velocities);
                for (int i = 0; i < count; i++)
                {
                    Vector3 expected = to[i], velocity = (to[i] - from[i]) / TimeStep;
                    if (list.Contains(i) && i % 3 != 2)
                    {
                        expected.y = Rest;
                        velocity.y = 0f;
                    }

                    Assert.That(((Vector3)places[i] - expected).magnitude, Is.LessThan(2e-3f * Rest), $"place of {i}");
                    Assert.That((velocities[i] - velocity).magnitude, Is.LessThan(1e-4f), $"velocity of {i}");
                }

                StandardStateRig.AssertCounted(rig.State, places, list);
                Assert.That(rig.Solver.ReadCountersNow().Contacts, Is.EqualTo(list.Count(i => i % 3 != 2)));
            }
        }

        // Floor and wall at a right angle: along the edge the motion stays, square to it both planes hold it.
        [Test]
        public void InAnEdgeAParticleStopsAtBothPlanes([Values(1, 65)] int count)
        {
            var random = new System.Random(count);
            var from = new Vector3[count];
            var to = new Vector3[count];
            for (int i = 0; i < count; i++)
            {
                float x = 1.5f + (float)random.NextDouble(), y = 1.5f + (float)random.NextDouble();
                from[i] = Rest * new Vector3(x, y, i - 0.5f * count);
                to[i] = from[i] + new Vector3(-0.01f, -0.02f, 0.003f);
            }

            using (var rig = new BodyRig(Settings()))
            {
                var wall = Floor.Select(p => new Vector3(p.y, p.x, p.z));
                rig.Add(Floor.Concat(wall).ToArray());
                int[] list = Enumerable.Range(0, count).ToArray();
                Vector4[] places = Resolve(rig, from, to, list, out Vector3[] velocities);
                for (int i = 0; i < count; i++)
                {
                    Vector3 expected = new Vector3(Rest, Rest, to[i].z), velocity = new Vector3(0f, 0f, 3f);
                    Assert.That(((Vector3)places[i] - expected).magnitude, Is.LessThan(4e-3f * Rest), $"place of {i}");
                    Assert.That((velocities[i] - velocity).magnitude, Is.LessThan(2e-3f), $"velocity of {i}");
                }
            }
        }

        // The floor comes up by two contact distances under particles at rest and gives them its speed.
        [Test]
        public void AWallThatMovesPushesParticlesAheadOfIt([Values(1, 64, 65)] int count)
        {
            const float rise = 2f * Rest;
            int[] list = Enumerable.Range(0, count).ToArray();
            Vector3[] from = list.Select(i => new Vector3(1e-3f * (i - 32), 1.5f * Rest, 0f)).ToArray();
            using (var rig = new BodyRig(Settings()))
            {
                Transform floor = rig.Add(Floor);
                Start(rig, from);
                floor.localPosition = rise * Vector3.up;
                rig.UpdateBodies();
                rig.State.BeginBodyStep(0, 1, TimeStep);
                Vector4[] places = Run(rig, from, from, list, out Vector3[] velocities);
                rig.State.EndBodySteps();
                for (int i = 0; i < count; i++)
                {
                    Assert.That(places[i].y, Is.EqualTo(rise + Rest).Within(4e-3f * Rest), $"place of {i}");
                    Assert.That(velocities[i].y, Is.EqualTo(rise / TimeStep).Within(0.1).Percent, $"speed of {i}");
                }
            }
        }

        private static FluidSolverSettings Settings()
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            settings.TimeStep = TimeStep;
            return settings;
        }

        private static Vector4[] Resolve(BodyRig rig, Vector3[] from, Vector3[] to, int[] list, out Vector3[] velocities)
        {
            Start(rig, from);
            return Run(rig, from, to, list, out velocities);
        }

        private static void Start(BodyRig rig, Vector3[] from)
        {
            rig.Start(from.Select((p, i) => new FluidParticle(p, Vector3.zero, (uint)i)).ToArray());
            rig.Setup();
        }

        private static Vector4[] Run(BodyRig rig, Vector3[] from, Vector3[] to, int[] list, out Vector3[] velocities)
        {
            StandardState state = rig.State;
            int count = from.Length;
            state.Buffers.NewPositions.SetData(to.Select(p => (Vector4)p).ToArray());
            state.Buffers.NewVelocities.SetData(from.Select((p, i) =>
                StandardStateRig.WithW((to[i] - p) / TimeStep, StandardStateRig.FromBits(7u * (uint)i))).ToArray());
            StandardStateRig.EmptyCells(state);
            uint[] arguments = { (uint)(list.Length + 63) / 64u, 1u, 1u, (uint)list.Length };
            uint Bits(float value) => StandardStateRig.ToBits(value);
            state.Walls.Contacts.SetData(arguments
                .Concat(list.SelectMany(i => new[] { Bits(from[i].x), Bits(from[i].y), Bits(from[i].z), (uint)i })).ToArray());
            FluidShaderSet shaders = TestShaders.CreateSet();
            var pass = new ResolveContactsPass(shaders);
            GpuTest.Run(cmd => pass.Record(cmd, state, new FluidStep(TimeStep, TimeStep, false)));
            Object.DestroyImmediate(shaders);
            Vector4[] moved = GpuTest.Read<Vector4>(state.Buffers.NewVelocities, count);
            for (int i = 0; i < count; i++) Assert.That(StandardStateRig.ToBits(moved[i].w), Is.EqualTo(7u * (uint)i), $"id of {i}");
            velocities = moved.Select(v => (Vector3)v).ToArray();
            return GpuTest.Read<Vector4>(state.Buffers.NewPositions, count);
        }
    }
}
