using System.Collections;
using System.Linq;
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
                bool Inside(Vector3 p, Vector3 centre) => Mathf.Abs(p.x - centre.x) < 0.16f && Mathf.Abs(p.y - centre.y) < 0.16f && Mathf.Abs(p.z - centre.z) < 0.16f;
                int inside = start.Count(p => Inside(p.Position, Vector3.zero));
                Assert.That(inside, Is.EqualTo(start.Length));
                Assert.That(end.Count(p => Inside(p.Position, at)), Is.EqualTo(start.Length), $"contacts {counters.Contacts}, squeezed {counters.Squeezed}");
                Assert.That(counters.Squeezed + counters.NonFinite + counters.Overlaps, Is.Zero);
                Object.DestroyImmediate(mesh);
            }
        }

        // Faces inward: a room, not a solid.
        static Mesh Box(float half)
        {
            var corners = Enumerable.Range(0, 8).Select(i => half * new Vector3((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1)).ToArray();
            return new Mesh { vertices = corners, triangles = new[] { 0, 1, 2, 1, 3, 2, 4, 6, 5, 5, 6, 7, 0, 4, 1, 1, 4, 5, 2, 3, 6, 3, 7, 6, 0, 2, 4, 2, 6, 4, 1, 5, 3, 3, 5, 7 } };
        }
    }
}
