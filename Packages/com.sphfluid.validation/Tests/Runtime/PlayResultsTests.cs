using System.Collections;
using System.Collections.Generic;
using System.IO;
using NUnit.Framework;
using SphFluid.Laboratory;
using SphFluid.Validation;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>What a play leaves behind: the surface as a file, and what summary.json says of it.</summary>
    public sealed class PlayResultsTests
    {
        private SimulationRig rig;
        private string folder;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            folder = TestFolder.Fresh();
        }

        [TearDown]
        public void TearDown()
        {
            rig.Dispose();
            TestFolder.Delete(folder);
        }

        [UnityTest]
        public IEnumerator TheMeshIsIndexedAndClosedWhateverIsDrawn(
            [Values("marching-cubes", "marching-cubes-gs", "particles", "none")] string surface)
        {
            if (surface == "marching-cubes-gs" && MeasuredGeometrySurface.MissingSupport() != null)
            {
                Assert.Ignore(MeasuredGeometrySurface.MissingSupport());
            }
            string file = Path.Combine(folder, "mesh.ply");
            FluidSimulation simulation = rig.Create();
            PlayArguments arguments = PlayArguments.Parse(new[] { "player", "--out", folder, "--", "--surface", surface, "--mesh", file });
            PlayOverrides.Apply(arguments, new[] { simulation });
            for (int frame = 0; frame < 4; frame++) yield return null;

            new PlayResults(arguments, new[] { simulation }, new Dictionary<FluidSimulation, SurfaceCaps>(),
                new Dictionary<FluidSimulation, ColliderSides>())
                .Write(new FrameTable("steps"), new FrameTable("steps"), new InstrumentRecord());

            SurfaceMesh mesh = PlyMesh.Read(file);
            MeshEdges edges = MeshEdges.Of(mesh);
            Assert.That((edges.OpenEdges, edges.NonManifoldEdges, edges.FlippedEdges), Is.EqualTo((0, 0, 0)));
            Assert.That(mesh.TriangleCount, Is.GreaterThan(100));
            Assert.That(mesh.VertexCount, Is.LessThan(mesh.TriangleCount), "vertices are shared");
            // 64 particles of 0.05 m: 8 litres.
            Assert.That(mesh.Volume(), Is.EqualTo(0.008).Within(30).Percent);
            string summary = File.ReadAllText(Path.Combine(folder, "summary.json"));
            Assert.That(summary, Does.Contain($"\"surface\": \"{surface}\""));
        }
    }
}
