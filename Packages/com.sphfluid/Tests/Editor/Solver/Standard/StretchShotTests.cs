using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// Shots at triangles that move, turn, scale, shear and deform in the step: no path that the contact kernels let pass crosses one.
    /// </summary>
    public sealed class StretchShotTests
    {
        private const float Spacing = 0.01f;

        // Fans near the origin, soups and patches two metres off it, where floats are coarser.
        [TestCase(0f, 1, false)]
        [TestCase(0f, 1, true)]
        [TestCase(2f, 0, true)]
        [TestCase(2f, 2, true)]
        public void NoShotCrosses(float offset, int kind, bool deforms) => Shoot(offset, kind, deforms, 1024);

        [Test]
        [Explicit("Four times as many shots: a minute.")]
        public void NoShotOfManyCrosses([Values(0f, 2f)] float offset, [Values(0, 1, 2)] int kind, [Values] bool deforms) =>
            Shoot(offset, kind, deforms, 4096);

        private static void Shoot(float offset, int kind, bool deforms, int count)
        {
            FluidSolverSettings settings = BodyRig.Water(new Vector3(2f * offset + 1.2f, 1.2f, 1.2f), Spacing, 0.3f);
            settings.TimeStep = 1e-3f;
            var centre = new Vector3(offset, 0f, 0f);
            var random = new System.Random(31 + kind);
            FluidShaderSet set = TestShaders.CreateSet();
            var walls = new GatherWallsPass(set);
            var find = new FindContactsPass(set);
            var resolve = new ResolveContactsPass(set);
            long crossings = 0, shots = 0, squeezed = 0;
            for (int scene = 0; scene < 5; scene++)
            {
                List<Vector3> corners = ContactShotTests.Scene(kind, Vector3.zero, random);
                using (var rig = new BodyRig(settings))
                {
                    var parent = new GameObject("parent");
                    Transform body = rig.Add(corners);
                    body.SetParent(parent.transform, false);
                    parent.transform.localPosition = centre;
                    parent.transform.localScale = Scale(random, 0.2f);
                    body.localRotation = ParticleSets.RandomRotation(random);
                    List<Vector3> start = corners.ConvertAll(body.TransformPoint);
                    var from = new Vector4[count];
                    var to = new Vector4[count];
                    for (int i = 0; i < count; i++) ContactShotTests.Shoot(start, random, out from[i], out to[i]);
                    rig.Start(from.Select((p, i) => new FluidParticle(p, Vector3.zero, (uint)i)).ToArray());
                    FluidObstacle before = rig.Solids.Single();
                    StandardState state = rig.State;
                    rig.Setup();

                    // By up to a sixth of the scale, a turn of up to 40 degrees, up to 4 dx.
                    float reach = Mathf.Pow(10f, -3f + 2.5f * (float)random.NextDouble());
                    parent.transform.localScale = Vector3.Scale(parent.transform.localScale, Scale(random, reach));
                    body.localRotation *= Quaternion.AngleAxis(40f * (float)random.NextDouble(), ParticleSets.RandomVector(random));
                    parent.transform.localPosition += 5f * Spacing * (float)random.NextDouble() * ParticleSets.RandomVector(random);
                    if (deforms) Deform(body.GetComponent<MeshCollider>().sharedMesh, reach, random);
                    rig.UpdateBodies();
                    Assert.That(rig.Bodies.HasStretch, Is.True);
                    var motion = new BodyMotion(before);
                    motion.MoveTo(rig.Solids.Single());

                    state.Buffers.Positions.SetData(from);
                    StandardStateRig.EmptyContacts(state);
                    state.Buffers.PositionTerms.SetData(from);
                    state.Buffers.NewPositions.SetData(to);
                    state.Buffers.NewVelocities.SetData(from.Select((p, i) => (to[i] - p) / settings.TimeStep).ToArray());
                    state.BeginBodyStep(0, 1, settings.TimeStep);
                    GpuTest.Run(cmd =>
                    {
                        walls.Record(cmd, state, state.Buffers.Positions);
                        find.Record(cmd, state, new FluidStep(settings.TimeStep, settings.TimeStep, false), state.Buffers.PositionTerms);
                        resolve.Record(cmd, state, new FluidStep(settings.TimeStep, settings.TimeStep, false));
                    });
                    state.EndBodySteps();
                    Vector4[] end = GpuTest.Read<Vector4>(state.Buffers.NewPositions, count);
                    shots += count;
                    Vector4[] velocities = GpuTest.Read<Vector4>(state.Buffers.NewVelocities, count);
                    bool[] isSqueezed = end.Select((p, i) => p == from[i] && (Vector3)velocities[i] == Vector3.zero).ToArray();
                    crossings += Crossings(motion, from, end, isSqueezed);
                    FluidCounters counters = rig.Solver.ReadCountersNow();
                    squeezed += counters.Squeezed;
                    Assert.That(counters.Contacts, Is.GreaterThan(count / 20));
                    Object.DestroyImmediate(parent);
                }
            }
            Object.DestroyImmediate(set);
            if (deforms) Assert.That(squeezed, Is.LessThan(shots / 100), "between corners that go anywhere");
            else Assert.That(squeezed, Is.Zero, "what is carried keeps its place among the triangles");
            TestContext.WriteLine($"{crossings} crossings, {squeezed} squeezed of {shots} shots");
            Assert.That(crossings, Is.Zero, $"of {shots} shots");
        }

        private static Vector3 Scale(System.Random random, float reach)
        {
            Vector3 v = ParticleSets.RandomVector(random);
            return new Vector3(Mathf.Exp(reach * v.x), Mathf.Exp(reach * v.y), Mathf.Exp(reach * v.z));
        }

        // Corners at one place stay together.
        private static void Deform(Mesh mesh, float reach, System.Random random)
        {
            var moved = new Dictionary<Vector3, Vector3>();
            Vector3[] corners = mesh.vertices;
            for (int i = 0; i < corners.Length; i++)
            {
                if (!moved.TryGetValue(corners[i], out Vector3 to))
                {
                    moved.Add(corners[i], to = corners[i] + 6f * Spacing * reach * ParticleSets.RandomVector(random));
                }
                corners[i] = to;
            }
            mesh.vertices = corners;
            mesh.RecalculateBounds();
        }

        // In the rigid frame, in double: there particle and corners go straight.
        private static long Crossings(BodyMotion motion, Vector4[] from, Vector4[] end, bool[] isSqueezed)
        {
            AffineMap toFrame0 = Frame(motion.Rotation0, motion.Position0), toFrame1 = Frame(motion.Rotation1, motion.Position1);
            TriangleMesh mesh = motion.Mesh;
            var starts = new Double3[mesh.Vertices.Length];
            var ends = new Double3[mesh.Vertices.Length];
            for (int i = 0; i < starts.Length; i++)
            {
                starts[i] = At(motion.Stretch0.Map, mesh.Vertices[i]);
                ends[i] = At(motion.Stretch1.Map, (motion.Deformation?.End ?? mesh).Vertices[i]);
            }
            long crossings = 0;
            for (int p = 0; p < from.Length; p++)
            {
                if (isSqueezed[p]) continue;
                Double3 x0 = At(toFrame0, from[p]), x1 = At(toFrame1, end[p]);
                for (int t = 0; t < mesh.TriangleCount; t++)
                {
                    int a = mesh.Indices[3 * t], b = mesh.Indices[3 * t + 1], c = mesh.Indices[3 * t + 2];
                    if (!MovingTriangle.Crosses(x0, x1, new[] { starts[a], starts[b], starts[c] }, new[] { ends[a], ends[b], ends[c] }))
                    {
                        continue;
                    }
                    crossings++;
                    break;
                }
            }
            return crossings;
        }

        private static AffineMap Frame(Quaternion rotation, Vector3 position)
        {
            double x = rotation.x, y = rotation.y, z = rotation.z, w = rotation.w, s = 2.0 / (x * x + y * y + z * z + w * w);
            return new AffineMap(
                1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w),
                s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w),
                s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y), position.x, position.y, position.z).Inverse;
        }

        private static Double3 At(in AffineMap m, Vector3 p) => new Double3(
            m.M00 * p.x + m.M01 * p.y + m.M02 * p.z + m.X, m.M10 * p.x + m.M11 * p.y + m.M12 * p.z + m.Y,
            m.M20 * p.x + m.M21 * p.y + m.M22 * p.z + m.Z);
    }
}
