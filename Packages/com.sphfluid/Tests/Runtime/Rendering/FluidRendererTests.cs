using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>The two components on a simulation: what they find, what they say, what they make.</summary>
    public sealed class FluidRendererTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        [Test]
        public void SimulationOnTheSameObjectIsFound()
        {
            FluidSimulation simulation = rig.Create();
            Assert.AreSame(simulation, simulation.gameObject.AddComponent<FluidParticleRenderer>().Simulation);
            Assert.AreSame(simulation, simulation.gameObject.AddComponent<FluidGeometrySurfaceRenderer>().Simulation);
        }

        [Test]
        public void MissingSimulationIsNamedOnce()
        {
            var drawing = rig.NewObject("Alone").AddComponent<FluidGeometrySurfaceRenderer>();
            LogAssert.Expect(LogType.Warning, new Regex("'Alone'.*FluidGeometrySurfaceRenderer has no simulation to draw"));
            drawing.DrawFrame();
            drawing.DrawFrame();
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void WithoutGeometryShadersTheSparseSurfaceIsDrawnAndThisIsSaidOnce()
        {
            var drawing = StartLiquid().gameObject.AddComponent<FluidGeometrySurfaceRenderer>();
            drawing.MissingSupport = () => "The toaster has no geometry shaders.";
            LogAssert.Expect(LogType.Warning, new Regex("'Fluid'.*The toaster has no geometry shaders.*sparse surface is drawn instead"));
            drawing.DrawFrame();
            drawing.DrawFrame();
            Assert.IsTrue(drawing.UsesFallback);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void GridFollowsItsSettingAndTheDomain()
        {
            FluidSimulation simulation = StartLiquid();
            var drawing = AddSurface(simulation);
            drawing.GridSize = SurfaceGridSize.Cells32;
            drawing.DrawFrame();
            Assert.AreEqual(33 * 33 * 33 * sizeof(float), drawing.GpuBytes);
            drawing.GridSize = SurfaceGridSize.Cells64;
            drawing.DrawFrame();
            Assert.AreEqual(65 * 65 * 65 * sizeof(float), drawing.GpuBytes);

            simulation.StopSimulation();
            drawing.DrawFrame();
            simulation.DomainSize = new Vector3(0.6f, 1f, 0.6f);
            Assert.IsTrue(simulation.StartSimulation(), simulation.StatusMessage);
            drawing.DrawFrame();
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void DisablingFreesTheGrid()
        {
            FluidGeometrySurfaceRenderer drawing = AddSurface(StartLiquid());
            drawing.DrawFrame();
            Assert.Greater(drawing.GpuBytes, 0);
            drawing.enabled = false;
            Assert.AreEqual(0, drawing.GpuBytes);
            drawing.enabled = true;
            drawing.DrawFrame();
            Assert.Greater(drawing.GpuBytes, 0);
        }

        [Test]
        public void ShaderSetWithoutTheShaderIsNamedOnceAndDrawingStops()
        {
            FluidSimulation simulation = StartLiquid();
            FluidShaderSet incomplete = TestShaders.Without(rig.Profile.Shaders, "SPH Fluid/Particles");
            rig.Profile.Shaders = incomplete;
            var drawing = simulation.gameObject.AddComponent<FluidParticleRenderer>();
            LogAssert.Expect(LogType.Error, new Regex("'Fluid'.*SPH Fluid/Particles.*not drawn"));
            drawing.DrawFrame();
            drawing.DrawFrame();
            LogAssert.NoUnexpectedReceived();
            Object.DestroyImmediate(incomplete);
        }

        [Test]
        public void WaterWithoutItsShaderIsNamedOnce()
        {
            FluidSimulation simulation = StartLiquid();
            FluidShaderSet incomplete = TestShaders.Without(rig.Profile.Shaders, "Hidden/SPH Fluid/Water Thickness");
            rig.Profile.Shaders = incomplete;
            var drawing = simulation.gameObject.AddComponent<FluidSurfaceRenderer>();
            LogAssert.Expect(LogType.Error, new Regex("'Fluid'.*SPH Fluid/Water Thickness.*not drawn"));
            drawing.DrawFrame();
            drawing.DrawFrame();
            LogAssert.NoUnexpectedReceived();
            Object.DestroyImmediate(incomplete);
        }

        [Test]
        public void DisablingFreesTheSparseSurface()
        {
            var drawing = StartLiquid().gameObject.AddComponent<FluidSurfaceRenderer>();
            Assert.AreEqual(0, drawing.GpuBytes);
            drawing.DrawFrame();
            Assert.Greater(drawing.GpuBytes, 0);
            drawing.enabled = false;
            Assert.AreEqual(0, drawing.GpuBytes);
            Assert.AreEqual(default(SurfaceStatus), drawing.Status);
        }

        [Test]
        public void AutomaticGridIsOneOfTheSizes()
        {
            int cells = SurfaceGridSize.Automatic.Cells();
            Assert.IsTrue(cells == 64 || cells == 128);
            Assert.AreEqual(256, SurfaceGridSize.Cells256.Cells());
        }

        [Test]
        public void MeshOfARunningLiquidHoldsItsVolume()
        {
            FluidSimulation simulation = StartLiquid();
            SurfaceMesh mesh = ThesisSurfaceMesher.Extract(simulation.Solver, rig.Profile.Shaders, SurfaceGridSize.Cells32);
            Assert.AreEqual(0.008, mesh.Volume(), 0.3 * 0.008);
            Assert.AreEqual(mesh.Volume(), mesh.Transformed(simulation.LocalToWorld).Volume(), 1e-5);
        }

        private FluidSimulation StartLiquid()
        {
            FluidSimulation simulation = rig.Create();
            Assert.IsTrue(simulation.StartSimulation(), simulation.StatusMessage);
            return simulation;
        }

        private static FluidGeometrySurfaceRenderer AddSurface(FluidSimulation simulation)
        {
            var drawing = simulation.gameObject.AddComponent<FluidGeometrySurfaceRenderer>();
            string shortfall = drawing.MissingSupport();
            if (shortfall != null) Assert.Ignore(shortfall);
            return drawing;
        }
    }
}
