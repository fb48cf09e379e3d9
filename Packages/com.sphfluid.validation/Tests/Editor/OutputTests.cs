using System;
using System.IO;
using System.Text;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class OutputTests
    {
        private string folder;

        [SetUp]
        public void MakeFolder()
        {
            folder = TestFolder.Fresh();
            Directory.CreateDirectory(folder);
        }

        [TearDown]
        public void RemoveFolder() => TestFolder.Delete(folder);

        [Test]
        public void JsonHasArraysOfNumbers()
        {
            Assert.That(new JsonObject().Add("some", new[] { 1.5, double.NaN, -2 }).Add("none", new double[0]).ToString(),
                Is.EqualTo("{\n  \"some\": [1.5,null,-2],\n  \"none\": []\n}"));
        }

        [Test]
        public void JsonIsAddedToAnObjectOnDisk()
        {
            string file = Path.Combine(folder, "summary.json");
            File.WriteAllText(file, "{\n  \"device\": \"a \\\"b\\\"\"\n}\n");

            new JsonObject().Add("steps", 3L).Add("inner", new JsonObject().Add("x", 0.5)).AppendTo(file);

            string text = File.ReadAllText(file).Replace("\n", "").Replace(" ", "");
            Assert.That(text, Is.EqualTo("{\"device\":\"a\\\"b\\\"\",\"steps\":3,\"inner\":{\"x\":0.5}}"));
        }

        [Test]
        public void JsonIsAddedToAnEmptyObjectAndToNoFile()
        {
            string empty = Path.Combine(folder, "empty.json"), missing = Path.Combine(folder, "missing.json");
            File.WriteAllText(empty, "{}");

            new JsonObject().Add("a", "b").AppendTo(empty);
            new JsonObject().Add("a", "b").AppendTo(missing);

            Assert.That(File.ReadAllText(empty).Replace("\n", "").Replace(" ", ""), Is.EqualTo("{\"a\":\"b\"}"));
            Assert.That(File.ReadAllText(missing).Replace("\n", "").Replace(" ", ""), Is.EqualTo("{\"a\":\"b\"}"));
        }

        [Test]
        public void JsonHasNoWordForNaN()
        {
            Assert.That(new JsonObject().Add("a", double.NaN).Add("b", double.PositiveInfinity).ToString(),
                Does.Not.Contain("NaN").And.Not.Contain("Inf"));
        }

        [Test]
        public void TableColumnsGoBehindANamedColumn()
        {
            string file = Path.Combine(folder, "timings.csv");
            File.WriteAllText(file, "frame,time_s,cpu_ms\n0,0,5\n1,0.5,6\n2,1,7\n");
            var table = new FrameTable("steps", "particles");
            table.Add(0, 100);
            table.Add(28, 100);

            table.InsertInto(file, "time_s");

            Assert.That(File.ReadAllLines(file), Is.EqualTo(new[]
            {
                "frame,time_s,steps,particles,cpu_ms", "0,0,0,100,5", "1,0.5,28,100,6", "2,1,,,7",
            }));
            Assert.That(() => table.InsertInto(file, "nothing"), Throws.TypeOf<InvalidDataException>().With.Message.Contains("nothing"));
        }

        [Test]
        public void ParticlesAreWrittenInTheOrderOfTheirIds()
        {
            var particles = new[]
            {
                new FluidParticle(new Vector3(4, 5, 6), new Vector3(7, 8, 9), 1),
                new FluidParticle(new Vector3(0.001f, 2, 3), Vector3.zero, 0),
            };
            // At 100 km neighbouring floats lie 8 mm apart.
            FluidSnapshot snapshot = FluidSnapshot.FromParticles(particles, new[] { 1001f, 1000f }, new[] { 5f, 0f },
                Matrix4x4.Translate(new Vector3(1e5f, 0f, -0.5f)));
            string file = Path.Combine(folder, "state.ply");

            PlyWriter.WriteParticles(file, snapshot);

            byte[] bytes = File.ReadAllBytes(file);
            int data = Encoding.ASCII.GetString(bytes).IndexOf("end_header\n", StringComparison.Ordinal) + 11;
            Assert.That(bytes.Length - data, Is.EqualTo(2 * 48));
            Assert.That(BitConverter.ToDouble(bytes, data), Is.EqualTo(100000.001).Within(1e-9), "x of id 0 in world space");
            Assert.That(BitConverter.ToDouble(bytes, data + 16), Is.EqualTo(2.5), "z of id 0 in world space");
            Assert.That(BitConverter.ToDouble(bytes, data + 48), Is.EqualTo(100004.0), "x of id 1 in world space");
            Assert.That(BitConverter.ToSingle(bytes, data + 48 + 36), Is.EqualTo(1001f), "density of id 1");
            Assert.That(BitConverter.ToUInt32(bytes, data + 48 + 44), Is.EqualTo(1u));
            Assert.That(Encoding.ASCII.GetString(bytes, 0, data),
                Does.Contain("\ncomment metres in world space; the centre of the domain is at 100000 0 -0.5\n"));
            var settings =
                new FluidSolverSettings { DomainSize = Vector3.one, TimeStep = 0.001f, RestDensity = 1000f, ParticleMass = 0.5f };
            Assert.That(SnapshotStatistics.Of(snapshot, settings).Centre.X, Is.EqualTo(100002.0005).Within(1e-9));
        }

        [Test]
        public void MeshIsWrittenWithNormalsAndFaces()
        {
            var mesh = new SurfaceMesh(new[] { Vector3.zero, Vector3.right, Vector3.up },
                new[] { Vector3.back, Vector3.back, Vector3.back }, new[] { 0, 2, 1 });
            string file = Path.Combine(folder, "sub", "mesh.ply");

            PlyWriter.WriteMesh(file, mesh, Matrix4x4.TRS(new Vector3(1e5f, 0f, 0f), Quaternion.Euler(0f, 90f, 0f), Vector3.one));

            byte[] bytes = File.ReadAllBytes(file);
            string text = Encoding.ASCII.GetString(bytes);
            int data = text.IndexOf("end_header\n", StringComparison.Ordinal) + 11;
            Assert.That(text, Does.Contain("element vertex 3").And.Contain("element face 1"));
            Assert.That(bytes.Length - data, Is.EqualTo(3 * 36 + 13));
            Assert.That(BitConverter.ToDouble(bytes, data + 36 + 16), Is.EqualTo(-1.0).Within(1e-6), "z of the second vertex, turned");
            Assert.That(BitConverter.ToSingle(bytes, data + 24), Is.EqualTo(-1f).Within(1e-6f), "x of the first normal, turned");
            Assert.That(BitConverter.ToInt32(bytes, data + 108 + 5), Is.EqualTo(2), "second corner");
        }
    }
}
