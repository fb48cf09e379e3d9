using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A liquid's surface as the mesh of a Mesh Filter: its content on the GPU, its growth, what it says.</summary>
    public sealed class FluidSurfaceMeshTests
    {
        private SimulationRig rig;
        private Material material;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            material = new Material(rig.Profile.Shaders.Find("SPH Fluid/Surface"));
        }

        [TearDown]
        public void TearDown()
        {
            rig.Dispose();
            Object.DestroyImmediate(material);
        }

        [Test]
        public void TheMeshIsTheSurface()
        {
            FluidSurfaceMesh handed = Start(rig.Create());
            handed.DrawFrame();
            AssertIsSurface(handed);
            Assert.AreEqual(Vector3.zero, handed.Mesh.bounds.center);
            Assert.AreEqual(new Vector3(0.4f, 0.4f, 0.4f), handed.Mesh.bounds.size);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void TheMeshGrowsWithTheSurface()
        {
            FluidSurfaceMesh handed = Start(rig.Create());
            handed.Surface.CellSize = 1f;
            handed.DrawFrame();
            long coarse = handed.GpuBytes;
            handed.Surface.CellSize = 0.25f;
            Settle(handed);
            Assert.Greater(handed.GpuBytes, coarse);
            AssertIsSurface(handed);

            // A coarser surface again leaves a long tail.
            handed.Surface.CellSize = 1f;
            Settle(handed);
            AssertIsSurface(handed);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void TheMeshLiesInTheSpaceOfItsObject()
        {
            FluidSimulation simulation = rig.Create(position: new Vector3(3f, 0f, 0f));
            simulation.transform.rotation = Quaternion.Euler(0f, 0f, 30f);
            GameObject other = rig.NewObject("Other");
            other.transform.SetPositionAndRotation(new Vector3(0f, 5f, 0f), Quaternion.Euler(40f, 0f, 0f));
            other.transform.localScale = new Vector3(-2f, 1f, 0.5f);
            Assert.IsTrue(simulation.StartSimulation(), simulation.StatusMessage);
            FluidSurfaceMesh handed = Add(other);
            handed.Simulation = simulation;
            handed.DrawFrame();

            List<Vector3> world = MeshTriangles.Read(handed.Mesh, other.transform.localToWorldMatrix);
            SurfaceMesh expected = handed.Sparse.ReadMesh().Transformed(simulation.LocalToWorld);
            Assert.AreEqual(expected.Indices.Length, world.Count);

            // Triangles face outwards in the mesh's own space, whose units have the volume -1: Unity turns them round for mirrored objects.
            List<Vector3> local = MeshTriangles.Read(handed.Mesh, Matrix4x4.identity);
            Assert.AreEqual(expected.Volume(), MeshTriangles.Volume(local, local[0]), 1e-4 * expected.Volume());
            Assert.AreEqual(-expected.Volume(), MeshTriangles.Volume(world, simulation.transform.position), 1e-4 * expected.Volume());
            Bounds bounds = handed.Mesh.bounds;
            foreach (Vector3 corner in local) Assert.Less(bounds.SqrDistance(corner), 1e-8f, $"{corner} outside {bounds}");
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void TheMeshComesAndGoesWithTheSimulationAndTheComponent()
        {
            FluidSimulation simulation = rig.Create();
            FluidSurfaceMesh handed = Start(simulation);
            var filter = handed.GetComponent<MeshFilter>();
            handed.DrawFrame();
            Assert.AreSame(handed.Mesh, filter.sharedMesh);

            simulation.StopSimulation();
            handed.DrawFrame();
            Assert.IsTrue(filter.sharedMesh == null, "no mesh without a running simulation");
            Assert.IsTrue(simulation.StartSimulation(), simulation.StatusMessage);
            handed.DrawFrame();
            Assert.AreSame(handed.Mesh, filter.sharedMesh);

            handed.enabled = false;
            Assert.IsTrue(filter.sharedMesh == null, "no mesh of a component that is off");
            Assert.AreEqual(0, handed.GpuBytes);
            Assert.IsTrue(handed.Mesh == null);
            handed.enabled = true;
            handed.DrawFrame();
            Assert.AreSame(handed.Mesh, filter.sharedMesh);

            Object.DestroyImmediate(handed);
            Assert.IsTrue(filter.sharedMesh == null);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void AMeshOfItsOwnerIsLeftAlone()
        {
            FluidSurfaceMesh handed = Start(rig.Create());
            handed.DrawFrame();
            var own = new Mesh { name = "Own" };
            handed.GetComponent<MeshFilter>().sharedMesh = own;
            handed.enabled = false;
            Assert.AreSame(own, handed.GetComponent<MeshFilter>().sharedMesh);
            Object.DestroyImmediate(own);
        }

        [Test]
        public void NothingThatDrawsTheMeshIsSaidOnce()
        {
            FluidSimulation simulation = rig.Create();
            Assert.IsTrue(simulation.StartSimulation(), simulation.StatusMessage);
            var handed = simulation.gameObject.AddComponent<FluidSurfaceMesh>();
            LogAssert.Expect(LogType.Warning, new Regex("'Fluid'.*Nothing draws the mesh.*Add a Mesh Renderer"));
            handed.DrawFrame();
            handed.DrawFrame();

            handed.enabled = false;
            simulation.gameObject.AddComponent<MeshRenderer>();
            handed.enabled = true;
            LogAssert.Expect(LogType.Warning, new Regex("'Fluid'.*has no material.*Assign one"));
            handed.DrawFrame();
            handed.DrawFrame();
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void CellsThatCannotBeAreNamedUntilTheyAreMended()
        {
            FluidSurfaceMesh handed = Start(rig.Create());
            handed.Surface.CellSize = 7f;
            LogAssert.Expect(LogType.Error, new Regex("'Fluid'.*not 7\\. Choose another cell size"));
            handed.DrawFrame();
            handed.DrawFrame();
            Assert.IsTrue(handed.GetComponent<MeshFilter>().sharedMesh == null);
            handed.Surface.CellSize = 0f;
            handed.DrawFrame();
            AssertIsSurface(handed);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void ABudgetThatIsTooSmallIsReportedOnce()
        {
            FluidSurfaceMesh handed = Start(rig.Create());
            handed.Surface.TriangleBudget = 50;
            LogAssert.Expect(LogType.Warning, new Regex("'Fluid'.*budget is 50.*Raise the triangle budget"));
            Settle(handed);
            Assert.LessOrEqual(handed.Mesh.GetIndexCount(0), 150u);
            Assert.IsEmpty(MeshTriangles.Read(handed.Mesh, Matrix4x4.identity), "no part of a surface");
            handed.Surface.TriangleBudget = 0;
            Settle(handed);
            AssertIsSurface(handed);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void AFlatTransformIsNamedAndShowsNothing()
        {
            FluidSimulation simulation = rig.Create();
            Assert.IsTrue(simulation.StartSimulation(), simulation.StatusMessage);
            GameObject other = rig.NewObject("Flat");
            other.transform.localScale = new Vector3(1f, 0f, 1f);
            FluidSurfaceMesh handed = Add(other);
            handed.Simulation = simulation;
            LogAssert.Expect(LogType.Warning, new Regex("'Flat'.*flattens.*scale other than 0"));
            handed.DrawFrame();
            handed.DrawFrame();
            Assert.IsTrue(other.GetComponent<MeshFilter>().sharedMesh == null);
            other.transform.localScale = Vector3.one;
            handed.DrawFrame();
            Assert.AreSame(handed.Mesh, other.GetComponent<MeshFilter>().sharedMesh);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void AShaderSetWithoutTheKernelIsNamed()
        {
            FluidSimulation simulation = rig.Create();
            Assert.IsTrue(simulation.StartSimulation(), simulation.StatusMessage);
            FluidShaderSet incomplete = TestShaders.Without(rig.Profile.Shaders, "WriteSurfaceMesh");
            rig.Profile.Shaders = incomplete;
            FluidSurfaceMesh handed = Add(simulation.gameObject);
            LogAssert.Expect(LogType.Error, new Regex("'Fluid'.*WriteSurfaceMesh.*not drawn"));
            handed.DrawFrame();
            handed.DrawFrame();
            LogAssert.NoUnexpectedReceived();
            Object.DestroyImmediate(incomplete);
        }

        private FluidSurfaceMesh Start(FluidSimulation simulation)
        {
            Assert.IsTrue(simulation.StartSimulation(), simulation.StatusMessage);
            return Add(simulation.gameObject);
        }

        private FluidSurfaceMesh Add(GameObject holder)
        {
            var handed = holder.AddComponent<FluidSurfaceMesh>();
            holder.AddComponent<MeshRenderer>().sharedMaterial = material;
            return handed;
        }

        // What a surface wants is known when the GPU has counted: its buffers grow before the next one.
        private static void Settle(FluidSurfaceMesh handed)
        {
            for (int i = 0; i < 3; i++)
            {
                handed.DrawFrame();
                AsyncGPUReadback.WaitAllRequests();
            }
        }

        private static void AssertIsSurface(FluidSurfaceMesh handed)
        {
            SurfaceMesh surface = handed.Sparse.ReadMesh();
            Assert.Greater(surface.TriangleCount, 100);
            var expected = new List<Vector3>(surface.Indices.Length);
            foreach (int index in surface.Indices) expected.Add(surface.Positions[index]);
            CollectionAssert.AreEqual(MeshTriangles.Ordered(expected),
                MeshTriangles.Ordered(MeshTriangles.Read(handed.Mesh, Matrix4x4.identity)));
        }
    }
}
