using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Open meshes that enclose a solid together have an inside; what has an opening that liquid gets through has none.</summary>
    public sealed class JoinedSolidsTests
    {
        private const float Edge = 0.4f, Spacing = 0.02f;

        private ColliderRig rig;

        [SetUp]
        public void SetUp() => rig = new ColliderRig { Spacing = Spacing };

        [TearDown]
        public void TearDown() => rig.Dispose();

        private static readonly Vector3[] Probes =
        {
            Vector3.zero, new Vector3(0f, 0.17f, 0f), new Vector3(0.13f, -0.11f, 0.17f), new Vector3(-0.17f, 0.17f, -0.17f),
            new Vector3(0.05f, 0.02f, -0.17f),
        };

        [Test]
        public void SixFacesHaveAnInside([Values(0f, 33f)] float turn, [Values(1, 3)] int cutsOfTheTop, [Values(0f, 0.25f)] float gap)
        {
            AddFaces(turn, cutsOfTheTop, gap * Spacing);
            AddGround();
            Assert.That(Probes.Select(Covering), Has.All.GreaterThanOrEqualTo(0));
            Assert.That(Probes.Select(p => Covering(p + 1.1f * Edge * Vector3.right)), Has.All.EqualTo(-1), "beside it");
            Assert.That(Probes.Select(p => Covering(p - 1.1f * Edge * Vector3.right)), Has.All.EqualTo(-1), "before it");
            Assert.That(rig.Scene.NameOf(Covering(Vector3.zero)), Is.EqualTo("'face 0', 'face 1', 'face 2' and 3 more"));
        }

        [TestCase(2.5f, false, 6, TestName = "AGapThatLiquidGetsThrough")]
        [TestCase(0f, true, 6, TestName = "AFaceThatLooksInward")]
        [TestCase(0f, false, 5, TestName = "AFaceThatIsMissing")]
        public void HasNoInside(float gap, bool flips, int faces)
        {
            AddFaces(33f, 1, gap * Spacing, faces, flips);
            Assert.That(Probes.Select(Covering), Has.All.EqualTo(-1));
        }

        // Its neck is a fiftieth as wide as it is deep: at its bottom the surface winds round a place 0.9999 times.
        [Test]
        public void ABottleOfSingleFacesHoldsLiquid()
        {
            var profile = new[] { new Vector2(0f, -0.5f), new Vector2(0.3f, -0.5f), new Vector2(0.3f, 0.2f), new Vector2(0.04f, 0.4f),
                new Vector2(0.04f, 1.5f) };
            rig.AddMesh(Turned(profile, 24, 0f));
            rig.Gather();
            for (float y = -0.45f; y < 1.5f; y += 0.1f) Assert.That(Covering(new Vector3(0.003f, y, 0.001f)), Is.EqualTo(-1), $"{y} m");
        }

        // As a program writes sin(2π): the last ring of corners is not the first.
        [TestCase(2.4e-17f)]
        [TestCase(1e-8f)]
        [TestCase(3e-7f)]
        public void ASeamOfRoundingIsClosed(float parted)
        {
            var profile = new[] { new Vector2(0f, -0.5f), new Vector2(0.3f, -0.5f), new Vector2(0.3f, 0.5f), new Vector2(0f, 0.5f) };
            TriangleMesh pillar = new MeshReader().Read(rig.AddMesh(Turned(profile, 24, parted)).sharedMesh);
            Assert.That(pillar.IsClosed);
            for (int i = -14; i <= 14; i++)
                for (int k = -14; k <= 14; k++)
                {
                    var place = new Vector3(0.02f * i, 0.1f, 0.02f * k);
                    Assert.That(pillar.Winding(place),
                        Is.EqualTo(new Vector2(place.x, place.z).magnitude < 0.3f * Mathf.Cos(Mathf.PI / 24f) ? 1 : 0).Or.EqualTo(
                        new Vector2(place.x, place.z).magnitude < 0.3f ? 1 : 0), $"{place}");
                }
        }

        [Test]
        public void BuiltInSolidsAreClosed([Values(PrimitiveType.Cube, PrimitiveType.Cylinder, PrimitiveType.Sphere,
            PrimitiveType.Capsule)] PrimitiveType type)
        {
            GameObject made = GameObject.CreatePrimitive(type);
            Assert.That(new MeshReader().Read(made.GetComponent<MeshFilter>().sharedMesh).IsClosed);
            UnityEngine.Object.DestroyImmediate(made);
        }

        private int Covering(Vector3 place) => rig.Scene.FindCovering(Quaternion.Euler(0f, turned, 0f) * place, 0f);

        private float turned;

        // The faces of a cube, each a collider; the top cut into so many strips by as many squares, all a gap apart.
        private void AddFaces(float turn, int cuts, float gap, int count = 6, bool flips = false)
        {
            turned = turn;
            var looks = new[] { Quaternion.identity, Quaternion.Euler(90f, 0f, 0f), Quaternion.Euler(180f, 0f, 0f),
                Quaternion.Euler(270f, 0f, 0f), Quaternion.Euler(0f, 0f, 90f), Quaternion.Euler(0f, 0f, 270f) };
            for (int face = 0; face < count; face++)
            {
                Transform place = rig.AddMesh(Face(face == 0 ? cuts : 1, flips && face == 2), $"face {face}").transform;
                place.SetPositionAndRotation(Quaternion.Euler(0f, turn, 0f) * (looks[face] * ((0.5f * Edge + 0.5f * gap) * Vector3.up)),
                    Quaternion.Euler(0f, turn, 0f) * looks[face]);
                place.localScale = Edge * Vector3.one;
            }
            rig.Gather();
        }

        // A sheet below that sees the cube.
        private void AddGround()
        {
            Transform ground = rig.AddMesh(Face(1, false), "ground").transform;
            ground.localScale = 3f * Vector3.one;
            ground.position = 0.7f * Edge * Vector3.down;
            rig.Gather();
        }

        private static Mesh Face(int cuts, bool flips)
        {
            var vertices = new List<Vector3>();
            var indices = new List<int>();
            for (int i = 0; i < cuts; i++)
            {
                TriangleMesh sheet = TestMeshes.Sheet();
                indices.AddRange((flips ? sheet.Indices.Reverse() : sheet.Indices).Select(n => n + vertices.Count).ToArray());
                vertices.AddRange(sheet.Vertices.Select(v => new Vector3((v.x + 0.5f + i) / cuts - 0.5f, v.y, v.z)));
            }
            return new Mesh { name = "Test Face", vertices = vertices.ToArray(), triangles = indices.ToArray() };
        }

        // A profile of radius and height turned about y, outward from below up; the last corners of each ring a little off the first.
        private static Mesh Turned(Vector2[] profile, int sides, float parted)
        {
            var vertices = new List<Vector3>();
            var indices = new List<int>();
            foreach (Vector2 ring in profile)
                for (int i = 0; i <= sides; i++)
                {
                    double angle = 2.0 * Math.PI * (i % sides) / sides;
                    vertices
                        .Add(new Vector3(ring.x * (float)Math.Cos(angle), ring.y,
                            ring.x * (float)Math.Sin(angle) + (i < sides || ring.x == 0f ? 0f : parted)));
                }
            for (int r = 0; r + 1 < profile.Length; r++)
                for (int i = 0; i < sides; i++)
                {
                    int a = r * (sides + 1) + i, b = a + sides + 1;
                    indices.AddRange(new[] { a, b, a + 1, a + 1, b, b + 1 });
                }
            return new Mesh { name = "Test Turned", vertices = vertices.ToArray(), triangles = indices.ToArray() };
        }
    }
}
