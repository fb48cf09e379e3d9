using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Colliders of a scene under the Standard method, frame by frame.</summary>
    public sealed class MeshColliderPlayTests
    {
        [UnityTest]
        public IEnumerator ABoxOfSingleTrianglesCarriesItsLiquid()
        {
            using (var rig = new SimulationRig(0.016f))
            {
                FluidSimulation simulation = rig.Create();
                simulation.Method = FluidMethodKind.Standard;
                simulation.DomainSize = new Vector3(1.2f, 0.6f, 0.6f);
                GameObject holder = rig.NewObject("Box");
                Mesh mesh = Box(0.16f);
                holder.AddComponent<MeshCollider>().sharedMesh = mesh;
                yield return null;
                yield return null;
                FluidParticle[] start = SimulationRig.Read(simulation);
                Assert.That(start.Any(p => p.Position.magnitude < 0.1f), Is.True);
                for (int frame = 1; frame <= 20; frame++)
                {
                    holder.transform.position = new Vector3(0.3f * Mathf.Sin(0.3f * frame), 0f, 0f); // 5.6 m/s
                    yield return null;
                }
                FluidCounters counters = simulation.Solver.ReadCountersNow();
                FluidParticle[] end = SimulationRig.Read(simulation);
                Vector3 at = holder.transform.position;
                int inside = start.Count(p => IsInside(p.Position, 0.16f));
                Assert.That(inside, Is.EqualTo(start.Length));
                Assert.That(end.Count(p => IsInside(p.Position - at, 0.16f)), Is.EqualTo(start.Length),
                    $"contacts {counters.Contacts}, squeezed {counters.Squeezed}");
                Assert.That(counters.Squeezed + counters.NonFinite + counters.Overlaps, Is.Zero);
                Object.DestroyImmediate(mesh);
            }
        }

        // Counts and bounds stay as they were: without the call the liquid stays behind.
        [UnityTest]
        public IEnumerator AMeshEditedInPlaceCarriesItsLiquidOnceItIsRefreshed()
        {
            using (var rig = new SimulationRig(0.016f))
            {
                FluidSimulation simulation = rig.Create();
                simulation.DomainSize = new Vector3(0.6f, 0.8f, 0.6f);
                Mesh mesh = Box(0.16f);
                rig.NewObject("Box").AddComponent<MeshCollider>().sharedMesh = mesh;
                yield return null;
                yield return null;
                Bounds bounds = mesh.bounds;
                for (int frame = 0; frame < 12; frame++)
                {
                    mesh.vertices = mesh.vertices.Select(v => v + 0.015f * Vector3.up).ToArray();
                    mesh.bounds = bounds;
                    simulation.RefreshColliders();
                    yield return null;
                }
                FluidParticle[] end = SimulationRig.Read(simulation);
                Assert.That(end.Count(p => IsInside(p.Position - 0.18f * Vector3.up, 0.16f)), Is.EqualTo(64));
                Assert.That(simulation.Messages, Is.Empty, "nothing jumped");
                Object.DestroyImmediate(mesh);
            }
        }

        [UnityTest]
        public IEnumerator CollidersThatCloseOnLiquidAreNamed([Values] bool bothMove)
        {
            using (var rig = new SimulationRig(0.016f))
            {
                FluidSimulation simulation = rig.Create();
                Transform left = Plate(rig, "Left press", -0.12f), right = Plate(rig, "Right press", 0.12f);
                string found = null;
                simulation.Reported += message => found = message.Issue == FluidIssue.GuardActed ? message.Text : found;
                LogAssert.Expect(LogType.Warning, new Regex("had no place between"));
                for (int frame = 0; frame < 40 && found == null; frame++)
                {
                    if (simulation.IsRunning) left.position += 0.012f * Vector3.right;
                    if (simulation.IsRunning && bothMove) right.position -= 0.012f * Vector3.right;
                    yield return null;
                }
                Assert.That(found,
                    Does.Contain("had no place between").And.Contain("'Left press'").And
                        .Contain(bothMove ? "'Right press'" : "a collider at rest"));
            }
        }

        // As wide as the domain, so that liquid cannot get past.
        private static Transform Plate(SimulationRig rig, string name, float x)
        {
            Transform plate = rig.NewObject(name).transform;
            plate.gameObject.AddComponent<BoxCollider>().size = new Vector3(0.04f, 0.5f, 0.5f);
            plate.position = new Vector3(x, 0f, 0f);
            return plate;
        }

        // 0.3 m wide at its smallest; liquid of 0.2 m.
        [UnityTest]
        public IEnumerator ABoxWhoseScaleSwingsKeepsItsLiquid([Values("even", "uneven", "turned below a parent")] string motion)
        {
            using (var rig = new SimulationRig(0.016f))
            {
                FluidSimulation simulation = rig.Create();
                simulation.Method = FluidMethodKind.Standard;
                simulation.DomainSize = 1.2f * Vector3.one;
                GameObject parent = rig.NewObject("Parent"), holder = rig.NewObject("Box");
                holder.transform.SetParent(parent.transform, false);
                Mesh mesh = Box(0.2f);
                holder.AddComponent<MeshCollider>().sharedMesh = mesh;
                holder.AddComponent<FluidCollider>();
                yield return null;
                yield return null;
                Assert.That(SimulationRig.Read(simulation).All(p => IsInside(holder.transform.InverseTransformPoint(p.Position), 0.2f)),
                    Is.True);
                for (int frame = 1; frame <= 30; frame++)
                {
                    float swing = 0.25f * Mathf.Sin(0.4f * frame); // 4 Hz
                    if (motion == "even") holder.transform.localScale = (1f + swing) * Vector3.one;
                    else if (motion == "uneven") holder.transform.localScale = new Vector3(1f + swing, 1f, 1f / (1f + swing));
                    else
                    {
                        parent.transform.localScale = new Vector3(1f + 0.04f * Mathf.Min(frame, 10), 1f, 1f);
                        holder.transform.localRotation = Quaternion.Euler(0f, 8f * frame, 3f * frame);
                    }
                    yield return null;
                }
                FluidCounters counters = simulation.Solver.ReadCountersNow();
                foreach (FluidParticle particle in SimulationRig.Read(simulation))
                {
                    Vector3 local = holder.transform.InverseTransformPoint(particle.Position);
                    Assert.That(IsInside(local, 0.2f), Is.True,
                        $"particle {particle.Id} is at {local} of the box, contacts {counters.Contacts}, squeezed {counters.Squeezed}");
                }
                Assert.That(counters.Squeezed + counters.NonFinite + counters.Overlaps, Is.Zero);
                Assert.That(simulation.Messages.Any(m => m.Issue == FluidIssue.ColliderJumped), Is.False);
                Object.DestroyImmediate(mesh);
            }
        }

        [UnityTest]
        public IEnumerator WhatLiquidCannotFollowIsNamedInThatFrameAndCounted([Values("mirrored", "zero", "triangles")] string change)
        {
            using (var rig = new SimulationRig(0.016f))
            {
                FluidSimulation simulation = rig.Create();
                simulation.Method = FluidMethodKind.Standard;
                simulation.DomainSize = 1.2f * Vector3.one;
                GameObject holder = rig.NewObject("Vessel");
                Mesh mesh = Box(0.16f);
                var collider = holder.AddComponent<MeshCollider>();
                collider.sharedMesh = mesh;
                yield return null;
                yield return null;
                Assert.That(SimulationRig.Read(simulation).All(p => IsInside(p.Position, 0.16f)), Is.True);
                LogAssert.Expect(LogType.Warning,
                    new Regex("'Vessel'.*(" + (change == "zero" ? "zero or non-finite scale" : "put at its new place at once") + ")"));
                if (change == "mirrored") holder.transform.localScale = new Vector3(-1f, 1f, 1f);
                else if (change == "zero") holder.transform.localScale = new Vector3(1f, 0f, 1f);
                else
                {
                    mesh.vertices = mesh.vertices.Select(v => v + 0.5f * Vector3.right).ToArray();
                    // others than those before, corner by corner
                    mesh.triangles = mesh.triangles.Skip(3).Concat(mesh.triangles.Take(3)).ToArray();
                    mesh.RecalculateBounds();
                    collider.sharedMesh = mesh;
                }
                yield return null;
                FluidIssue expected = change == "zero" ? FluidIssue.ColliderTransformSingular : FluidIssue.ColliderJumped;
                FluidMessage message = simulation.Messages.Single(m => m.Issue == expected);
                Assert.That(message.Context, Is.SameAs(collider));
                if (change == "triangles")
                {
                    Assert.That(SimulationRig.Read(simulation).Count(p => !IsInside(p.Position - 0.5f * Vector3.right, 0.16f)),
                        Is.GreaterThan(30), "they were left behind");
                }
                Object.DestroyImmediate(mesh);
            }
        }

        private static bool IsInside(Vector3 p, float half) => Mathf.Abs(p.x) < half && Mathf.Abs(p.y) < half && Mathf.Abs(p.z) < half;

        // Faces inward: a hollow, not a solid.
        private static Mesh Box(float half)
        {
            var corners = Enumerable.Range(0, 8).Select(i => half * new Vector3((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1)).ToArray();
            return new Mesh
            {
                vertices = corners,
                triangles =
                    new[] { 0, 1, 2, 1, 3, 2, 4, 6, 5, 5, 6, 7, 0, 4, 1, 1, 4, 5, 2, 3, 6, 3, 7, 6, 0, 2, 4, 2, 6, 4, 1, 5, 3, 3, 5, 7 }
            };
        }
    }
}
