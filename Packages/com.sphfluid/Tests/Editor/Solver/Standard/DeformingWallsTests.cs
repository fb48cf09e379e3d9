using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>GatherWalls: the walls that particles feel of triangles that deform.</summary>
    public sealed class DeformingWallsTests
    {
        private const float Spacing = 0.05f;

        // Between corners that go different ways the wall has the mean of their velocities by the place's weights; at half of the frame it
        // is halfway.
        [Test]
        public void ASheetThatDeformsHasThePlacesAndVelocitiesOfItsCorners()
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            var corners = new List<Vector3>();
            GatherWallsTests.Sheet(corners, p => new Vector3(0.8f * p.x - 0.4f, 0.02f * Mathf.Sin(9f * p.x + 4f * p.y), 0.8f * p.y - 0.4f),
                5, false);
            Vector3 Moved(Vector3 p) => p + 0.03f * new Vector3(Mathf.Sin(7f * p.z), Mathf.Cos(5f * p.x + 3f * p.z), Mathf.Sin(6f * p.x));
            using (var rig = new BodyRig(settings))
            {
                Transform sheet = rig.Add(corners);
                Vector3[] points = GatherWallsTests.Points(257, new Vector3(0.7f, 0.1f, 0.7f), 8);
                rig.Start(points.Select((p, i) => new FluidParticle(p, Vector3.zero, (uint)i)).ToArray());
                rig.Setup();
                Mesh mesh = sheet.GetComponent<MeshCollider>().sharedMesh;
                mesh.vertices = corners.Select(Moved).ToArray();
                mesh.RecalculateBounds();
                rig.UpdateBodies();
                Assert.That(rig.Bodies.Jumps, Is.Zero);
                StoredWall[] walls = StoredWall.Gather(rig.State, 1, 2);
                Vector4[] at = GpuTest.Read<Vector4>(rig.State.Buffers.Positions, points.Length);
                int felt = 0;
                for (int i = 0; i < points.Length; i++)
                {
                    Vector3 best = Vector3.zero, velocity = Vector3.zero;
                    float nearest = settings.SupportRadius;
                    for (int t = 0; t < corners.Count; t += 3)
                    {
                        Vector3[] half = { 0.5f * (corners[t] + Moved(corners[t])), 0.5f * (corners[t + 1] + Moved(corners[t + 1])),
                            0.5f * (corners[t + 2] + Moved(corners[t + 2])) };
                        Vector3 foot = TriangleMath.ClosestPoint(at[i], half[0], half[1], half[2]);
                        if (((Vector3)at[i] - foot).magnitude >= nearest) continue;
                        nearest = ((Vector3)at[i] - foot).magnitude;
                        best = foot;
                        Vector3 n = Vector3.Cross(half[1] - half[0], half[2] - half[0]);
                        float b = Vector3.Dot(Vector3.Cross(foot - half[0], half[2] - half[0]), n) / n.sqrMagnitude;
                        float c = Vector3.Dot(Vector3.Cross(half[1] - half[0], foot - half[0]), n) / n.sqrMagnitude;
                        Vector3 Half(int k) => 0.5f * (Moved(corners[t + k]) - corners[t + k]) / settings.TimeStep;
                        velocity = (1f - b - c) * Half(0) + b * Half(1) + c * Half(2);
                    }
                    if (nearest > 0.9f * settings.SupportRadius || nearest < 1e-3f) continue;
                    felt++;
                    Assert.That(walls[i].Distance, Is.EqualTo(nearest).Within(1e-5), $"at {at[i]}");
                    Assert.That((walls[i].Velocity - velocity).magnitude, Is.LessThan(2e-3f * velocity.magnitude), $"at {at[i]}, {best}");
                }
                Assert.That(felt, Is.GreaterThan(150));
            }
        }

        // Another body that moves keeps the frame's steps going, but they do not take the sheet to where it jumped.
        [Test]
        public void CornersThatGoTooFarAreThereAtOnce()
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            var corners = new List<Vector3>();
            GatherWallsTests.Sheet(corners, p => new Vector3(0.8f * p.x - 0.4f, 0f, 0.8f * p.y - 0.4f), 2, false);
            TriangleMesh near = TriangleMesh.FromCorners(corners);
            TriangleMesh At(float far) => near.Deformed(near.Vertices.Select((v, i) => v + (far + 0.01f * i) * Vector3.forward).ToArray());
            using (var obstacles = new FluidObstacles(settings))
            using (var liquid = new StandardRig(settings, new[] { new FluidParticle(0.02f * Vector3.up, Vector3.zero, 0u) }))
            {
                int sheet = obstacles.Add(At(0f), Matrix4x4.identity),
                    other = obstacles.Add(TriangleMesh.Box(Matrix4x4.Scale(0.1f * Vector3.one)), Matrix4x4.Translate(0.4f * Vector3.up));
                foreach (float far in new[] { 100f * settings.SupportRadius, 99f * settings.SupportRadius })
                {
                    obstacles.Reshape(sheet, At(far));
                    obstacles.Update(Matrix4x4.identity);
                    obstacles.Bodies.Arrive();
                }
                liquid.Solver.SetObstacles(obstacles);
                liquid.Setup();
                int jumps = obstacles.Jumps;
                obstacles.Reshape(sheet, near);
                obstacles.MoveTo(other, Matrix4x4.Translate(0.41f * Vector3.up));
                obstacles.Update(Matrix4x4.identity);
                Assert.That(obstacles.Jumps, Is.EqualTo(jumps + 1));
                Assert.That(obstacles.Bodies.IsUnderWay, Is.True);
                StoredWall wall = StoredWall.Gather(liquid.State, 0, 2)[0];
                liquid.State.EndBodySteps();
                Assert.That(wall.Distance, Is.EqualTo(0.02f).Within(1e-5));
                Assert.That(wall.Velocity.magnitude, Is.LessThan(1e-3f));
            }
        }
    }
}
