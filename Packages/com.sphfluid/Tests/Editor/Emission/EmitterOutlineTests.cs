using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>Nozzles of the shape of a mesh: where their layers begin, and that they are one lattice that moves.</summary>
    public sealed class EmitterOutlineTests
    {
        private const float Spacing = 0.02f;

        private readonly List<Object> made = new List<Object>();

        [TearDown]
        public void TearDown()
        {
            foreach (Object item in made) Object.DestroyImmediate(item);
            made.Clear();
        }

        private Mesh Made(TriangleMesh triangles)
        {
            var mesh = new Mesh { name = "nozzle", vertices = triangles.Vertices, triangles = triangles.Indices };
            made.Add(mesh);
            return mesh;
        }

        private EmitterSpec Nozzle(Mesh mesh, Vector3? scale = null)
        {
            var owner = new GameObject("Tap") { hideFlags = HideFlags.HideAndDontSave };
            made.Add(owner);
            return new EmitterSpec
            {
                Owner = owner.transform,
                State = new EmitterState { IsOn = true },
                Rotation = Quaternion.identity,
                Shape = FluidEmitterShape.Mesh,
                Mesh = mesh,
                Scale = scale ?? Vector3.one,
                Amount = 1.3f,
            };
        }

        // A flat frame: a square with a square hole.
        private static TriangleMesh Frame(float outer, float inner)
        {
            var corners = new List<Vector3>();
            foreach (float half in new[] { outer, inner })
            {
                corners
                    .AddRange(new[] { new Vector3(-half, -half), new Vector3(half, -half), new Vector3(half, half),
                        new Vector3(-half, half) });
            }
            var indices = new List<int>();
            for (int i = 0; i < 4; i++) indices.AddRange(new[] { i, (i + 1) % 4, 4 + (i + 1) % 4, i, 4 + (i + 1) % 4, 4 + i });
            return new TriangleMesh(corners.ToArray(), indices.ToArray());
        }

        [TestCase(5, 0)]
        [TestCase(6, 2)]
        [TestCase(9, 3)]
        public void AFlatMeshHasAPlaceForEachSquareOfTheSpacing(int outer, int inner)
        {
            EmitterSpec nozzle = Nozzle(Made(Frame(0.5f * outer * Spacing, 0.5f * inner * Spacing)));
            EmitterSites sites = EmitterSites.For(nozzle, Spacing);
            Assert.That(sites.Places.Length, Is.EqualTo(outer * outer - inner * inner));
            Assert.That(sites.LayerDistance, Is.EqualTo(Spacing).Within(1e-7));
            Assert.That(sites.Places.Max(p => Mathf.Max(Mathf.Abs(p.x), Mathf.Abs(p.y))),
                Is.EqualTo(0.5f * (outer - 1) * Spacing).Within(1e-6f), "centres of the squares");
            Assert.That(sites.Places.All(p => p.z == 0f));
            Assert.That(nozzle.Area(Spacing), Is.EqualTo(sites.Places.Length * Spacing * Spacing).Within(1e-8));
        }

        [Test]
        public void OfARoundMeshItIsTheFrontThatGives()
        {
            EmitterSpec nozzle =
                Nozzle(Made(PrimitiveTessellator.Capsule(Matrix4x4.identity, 0.5f, 0f, 0.005f)), new Vector3(0.3f, 0.2f, 0.4f));
            Vector3[] places = EmitterSites.For(nozzle, Spacing).Places;
            Assert.That(places.Length, Is.EqualTo(Mathf.PI * 0.15f * 0.1f / (Spacing * Spacing)).Within(6).Percent);
            foreach (Vector3 place in places)
            {
                float x = place.x / 0.15f, y = place.y / 0.1f, z = 0.2f * Mathf.Sqrt(Mathf.Max(0f, 1f - x * x - y * y));
                float steepness = 1f / Mathf.Max(0.2f, z / 0.2f);
                Assert.That(place.z, Is.EqualTo(z).Within(0.5f * Spacing + 0.004f * steepness + 0.002f), $"{place}");
                Assert.That(place.z / Spacing, Is.EqualTo(Mathf.Round(place.z / Spacing)).Within(1e-3f));
            }
        }

        // Whatever the mesh, its layers are one lattice: no two particles are nearer than a spacing, and behind the front no place is
        // empty.
        [Test]
        public void LayersOfACurvedFrontAreOneLattice()
        {
            EmitterSpec nozzle = Nozzle(Made(PrimitiveTessellator.Capsule(Matrix4x4.identity, 0.1f, 0f, 0.002f)));
            var run = new EmitterRun(1);
            var births = new BirthQueue(0u);
            int layer = EmitterSites.For(nozzle, Spacing).Places.Length;
            double time = 5.5 * Spacing / 1.3;
            run.Emit(nozzle, new FluidSpec { Spacing = Spacing, Rotation = Quaternion.identity }, 0.0, time, births,
                new ParticleLifetimes());
            births.CollectDue(time, 0f, Vector3.zero);
            Vector3[] born = births.Due.Take(6 * layer).Select(b => b.Position).ToArray();
            Assert.That(born.Length, Is.EqualTo(6 * layer));
            for (int i = 0; i < born.Length; i++)
                for (int k = 0; k < i; k++) Assert.That((born[i] - born[k]).sqrMagnitude, Is.GreaterThan(0.998f * Spacing * Spacing));
            foreach (IGrouping<(int,
                int), Vector3> column in born.GroupBy(p => (Mathf.RoundToInt(2f * p.x / Spacing), Mathf.RoundToInt(2f * p.y / Spacing))))
            {
                Assert.That(column.Max(p => p.z) - column.Min(p => p.z), Is.EqualTo(5f * Spacing).Within(1e-4f));
            }
        }

        [Test]
        public void AnotherMeshOrScaleIsSeenAndTheSameOneIsNotDrawnAgain()
        {
            Mesh mesh = Made(Frame(0.05f, 0f));
            EmitterSpec nozzle = Nozzle(mesh);
            EmitterOutline first = EmitterOutline.Create(nozzle, Spacing);
            Assert.That(EmitterOutline.Create(nozzle, Spacing), Is.SameAs(first));
            nozzle.Scale = new Vector3(2f, 1f, 1f);
            Assert.That(EmitterOutline.Create(nozzle, Spacing).Places.Length, Is.EqualTo(2 * first.Places.Length));
            nozzle.Mesh = Made(Frame(0.1f, 0f));
            nozzle.Scale = Vector3.one;
            Assert.That(EmitterOutline.Create(nozzle, Spacing).Places.Length, Is.EqualTo(4 * first.Places.Length));
        }

        [Test]
        public void AMeshThatGivesNothingIsNamedWithTheCure()
        {
            FluidSpec liquid = new FluidSpec { Spacing = Spacing };
            string Said(EmitterSpec nozzle) => EmitterChecks.Check(nozzle, liquid)?.ToString();
            Assert.That(Said(Nozzle(Made(Frame(0.05f, 0f)))), Is.Null);
            Assert.That(Said(Nozzle(null)), Does.Contain("'Tap'").And.Contain("Assign a mesh"));
            Assert.That(Said(Nozzle(Made(Frame(0.05f, 0f)), new Vector3(1f, 0f, 1f))), Does.Contain("no place for a particle"),
                "seen edge on");
            Assert.That(Said(Nozzle(Made(Frame(1e6f, 0f)))), Does.Contain("for too many"));
            EmitterSpec pump = Nozzle(Made(Frame(0.05f, 0f)));
            pump.UnderWater = true;
            Assert.That(Said(pump), Does.Contain("Switch Under Water off"));
            Mesh closed = Made(Frame(0.05f, 0f));
            closed.UploadMeshData(true);
            Assert.That(Said(Nozzle(closed)), Does.Contain("Read/Write"));
        }
    }
}
