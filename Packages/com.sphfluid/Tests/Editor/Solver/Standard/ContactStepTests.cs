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
        private const float Spacing = 0.02f, Rest = 0.1f * Spacing;

        // Ends of steps among triangles that rest.
        private static Vector3[] Resolve(IReadOnlyList<Vector3> corners, Vector3[] from, Vector3[] to, out FluidCounters counters) =>
            Resolve(corners, from, to, out counters, out _);

        // listed: particles that FindContacts left to ResolveContacts.
        private static Vector3[] Resolve(
            IReadOnlyList<Vector3> corners, Vector3[] from, Vector3[] to, out FluidCounters counters, out uint listed)
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
                    Vector3[] end = Step(rig, set, from, to);
                    counters = rig.Solver.ReadCountersNow();
                    listed = GpuTest.Read<uint>(rig.State.Walls.Contacts, 4)[3];
                    return end;
                }
            }
            finally
            {
                Object.DestroyImmediate(set);
            }
        }

        private static Vector3[] Step(BodyRig rig, FluidShaderSet set, Vector3[] from, Vector3[] to)
        {
            StandardState state = rig.State;
            float timeStep = rig.Settings.TimeStep;
            state.Buffers.Positions.SetData(from.Select(p => (Vector4)p).ToArray());
            StandardStateRig.EmptyContacts(state);
            state.Buffers.PositionTerms.SetData(from.Select(p => (Vector4)p).ToArray());
            var step = new FluidStep(timeStep, timeStep, false);
            state.Buffers.NewPositions.SetData(to.Select(p => (Vector4)p).ToArray());
            state.Buffers.NewVelocities.SetData(from.Select((p, i) => (Vector4)((to[i] - p) / timeStep)).ToArray());
            GpuTest.Run(cmd =>
            {
                new GatherWallsPass(set).Record(cmd, state, state.Buffers.Positions);
                new FindContactsPass(set).Record(cmd, state, step, state.Buffers.PositionTerms);
                new ResolveContactsPass(set).Record(cmd, state, step);
            });
            return GpuTest.Read<Vector4>(state.Buffers.NewPositions, from.Length).Select(p => (Vector3)p).ToArray();
        }

        private static readonly Vector3[] floor = { new Vector3(-0.4f, 0f, -0.4f), new Vector3(0f, 0f, 0.4f),
            new Vector3(0.4f, 0f, -0.4f) };

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

        // In three passes, one a plane: a plane that kept the gap instead would need a second pass for each.
        [Test]
        public void InACornerAPressedParticleIsPushedOffAllThreePlanes()
        {
            var corners = new List<Vector3>();
            for (int axis = 0; axis < 3; axis++)
                foreach (Vector3 p in new[] { new Vector3(0f, -0.3f, -0.3f), new Vector3(0f, 0.8f, -0.3f), new Vector3(0f, -0.3f, 0.8f) })
                {
                    corners.Add(axis == 0 ? p : axis == 1 ? new Vector3(p.z, p.x, p.y) : new Vector3(p.y, p.z, p.x));
                }
            Vector3 from = Rest * new Vector3(0.5f, 0.54f, 0.58f);
            Vector3 end = Resolve(corners, new[] { from }, new[] { from - 0.003f * Vector3.one }, out FluidCounters counters)[0];
            for (int axis = 0; axis < 3; axis++)
            {
                Assert.That(end[axis] / Rest, Is.EqualTo(from[axis] / Rest + 0.1f).Within(2e-3f), $"axis {axis}");
            }
            Assert.That(counters.ContactFallbacks, Is.Zero);
        }

        // A small triangle in the corner of a long step's box, whose plane the step crosses, two R from where it does: box and plane do
        // not distinguish it from one in between, but no cell along the step lists it.
        [TestCase(0f, 0u)]
        [TestCase(1f, 1u)]
        public void OnlyTrianglesOfCellsAlongAStepMakeItAContact(float shift, uint expected)
        {
            const float length = 0.98f * 8f * Spacing / 1.4142f;
            Vector3 along = length * new Vector3(1f, 1f, 0f), corner = length * new Vector3(0.96f, 0.04f, 0f),
                size = 0.02f * length * Vector3.one;
            var side = new Vector3(size.x, -size.x, 0f);
            var corners = new[] { corner - side, corner + side, corner + new Vector3(0f, 0f, size.z) };
            Vector3 from = shift * (corner - 0.5f * along) + 0.1f * size.z * Vector3.forward;
            Vector3 end = Resolve(corners, new[] { from }, new[] { from + along }, out _, out uint listed)[0];
            Assert.That(listed, Is.EqualTo(expected));
            Assert.That((end - from - along).magnitude, expected == 0u ? Is.LessThan(1e-6f) : Is.GreaterThan(0.1f * length));
        }

        // A press comes down on a floor beside the press's rim. The particle between them cannot be carried by either; a third
        // body that goes aside would take it along, but not once it is gone: its record is still behind the last one.
        [TestCase(true)]
        [TestCase(false)]
        public void ASqueezedParticleIsCarriedByBodiesThatAreThereAndByNoOther(bool isThere)
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            settings.TimeStep = 1e-3f;
            FluidShaderSet set = TestShaders.CreateSet();
            try
            {
                using (var rig = new BodyRig(settings))
                {
                    rig.Add(floor);
                    float rim = 0.2f * Rest;
                    var plate = new[] { new Vector3(rim, 0f, -0.3f), new Vector3(rim, 0f, 0.3f), new Vector3(-0.3f, 0f, 0f) };
                    Transform press = rig.Add(plate), other = rig.Add(plate);
                    press.localPosition = 2.04f * Rest * Vector3.up;
                    other.localPosition = new Vector3(0f, 0.3f, 0f);
                    Vector3 from = 1.02f * Rest * Vector3.up;
                    rig.Start(new[] { new FluidParticle(from, Vector3.zero, 0u) });
                    rig.Setup();
                    press.localPosition = 0.05f * Rest * Vector3.up;
                    other.localPosition += 60f * Rest * Vector3.right;
                    rig.UpdateBodies();
                    Assert.That(rig.Bodies.Count, Is.EqualTo(3));
                    other.gameObject.SetActive(isThere);
                    rig.UpdateBodies();
                    Assert.That(rig.Bodies.Count, Is.EqualTo(isThere ? 3 : 2));
                    rig.Solver.State.BeginBodyStep(0, 1, settings.TimeStep);
                    Vector3 end = Step(rig, set, new[] { from }, new[] { from })[0];
                    rig.Solver.State.EndBodySteps();
                    FluidCounters counters = rig.Solver.ReadCountersNow();
                    Assert.That(counters.ContactFallbacks, Is.EqualTo(1));
                    Assert.That(counters.Squeezed, Is.EqualTo(isThere ? 0 : 1));
                    Assert.That(end.x, isThere ? Is.GreaterThan(10f * Rest) : Is.EqualTo(from.x));
                }
            }
            finally
            {
                Object.DestroyImmediate(set);
            }
        }

        [Test]
        public void InANarrowWedgeEachParticleGoesAsFarAsItIsFree()
        {
            // Two sheets that join at an angle of 2 degrees; no plane of either lets the step pass.
            const int count = 61;
            float slope = Mathf.Tan(Mathf.Deg2Rad);
            var corners = new List<Vector3>();
            foreach (float side in new[] { -1f, 1f })
            {
                corners
                    .AddRange(new[] { new Vector3(0f, 0f, -0.4f), new Vector3(0f, 0f, 0.4f), new Vector3(0.4f * slope * side, 0.4f, 0f) });
            }
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
                // Sweeps end at 0.9; a thousandth of 0.1 m on the slope of 1 degree is less than 0.001.
                Assert.That(gap, Is.LessThan(0.902f), $"particle {i} came to where the wedge is as narrow as contact allows");
            }
        }
    }
}
