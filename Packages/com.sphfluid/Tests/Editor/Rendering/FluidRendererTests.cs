using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>The two components on a simulation: what they find, what they say, what they make.</summary>
    public sealed class FluidRendererTests
    {
        GameObject tank;
        FluidProfile profile;

        [SetUp]
        public void SetUp()
        {
            profile = ScriptableObject.CreateInstance<FluidProfile>();
            profile.Shaders = SurfaceTestScene.LoadShaders();
            tank = new GameObject("Tank");
        }

        [TearDown]
        public void TearDown()
        {
            var simulation = tank.GetComponent<FluidSimulation>();
            if (simulation != null)
                simulation.StopSimulation();
            foreach (FluidRenderer drawing in tank.GetComponents<FluidRenderer>())
                Object.DestroyImmediate(drawing);
            Object.DestroyImmediate(tank);
            Object.DestroyImmediate(profile);
        }

        [Test]
        public void SimulationOnTheSameObjectIsFound()
        {
            FluidSimulation simulation = StartLiquid();
            Assert.AreSame(simulation, tank.AddComponent<FluidParticleRenderer>().Simulation);
            Assert.AreSame(simulation, tank.AddComponent<FluidSurfaceRenderer>().Simulation);
        }

        [Test]
        public void MissingSimulationIsNamedOnce()
        {
            var drawing = tank.AddComponent<FluidSurfaceRenderer>();
            LogAssert.Expect(LogType.Warning, new Regex("'Tank'.*FluidSurfaceRenderer has no simulation to draw"));
            drawing.DrawFrame();
            drawing.DrawFrame();
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void WithoutGeometryShadersTheParticlesAreDrawnAndThisIsSaidOnce()
        {
            StartLiquid();
            var drawing = tank.AddComponent<FluidSurfaceRenderer>();
            drawing.MissingSupport = () => "The toaster has no geometry shaders.";
            LogAssert.Expect(LogType.Warning, new Regex("'Tank'.*The toaster has no geometry shaders.*particles are drawn instead"));
            drawing.DrawFrame();
            drawing.DrawFrame();
            Assert.IsTrue(drawing.UsesFallback);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void GridFollowsItsSettingAndTheDomain()
        {
            if (GeometrySurface.MissingSupport() != null)
                Assert.Ignore(GeometrySurface.MissingSupport());
            FluidSimulation simulation = StartLiquid();
            var drawing = tank.AddComponent<FluidSurfaceRenderer>();
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
        public void ShaderSetWithoutTheShaderIsNamedOnceAndDrawingStops()
        {
            StartLiquid();
            var incomplete = Object.Instantiate(profile.Shaders);
            incomplete.ParticleShader = null;
            profile.Shaders = incomplete;
            var drawing = tank.AddComponent<FluidParticleRenderer>();
            LogAssert.Expect(LogType.Error, new Regex("'Tank'.*particleShader.*not drawn"));
            drawing.DrawFrame();
            drawing.DrawFrame();
            LogAssert.NoUnexpectedReceived();
            Object.DestroyImmediate(incomplete);
        }

        [Test]
        public void AutomaticGridIsOneOfTheSizes()
        {
            int cells = SurfaceGridSize.Automatic.Cells();
            Assert.IsTrue(cells == 64 || cells == 128);
            Assert.AreEqual(256, SurfaceGridSize.Cells256.Cells());
        }

        FluidSimulation StartLiquid()
        {
            var simulation = tank.AddComponent<FluidSimulation>();
            simulation.Profile = profile;
            simulation.DomainSize = Vector3.one;
            simulation.Spacing = 0.05f;
            var liquid = new GameObject("Liquid");
            liquid.transform.SetParent(tank.transform, false);
            var volume = liquid.AddComponent<FluidVolume>();
            volume.Size = new Vector3(0.3f, 0.3f, 0.3f);
            volume.Simulation = simulation;
            Assert.IsTrue(simulation.StartSimulation(), simulation.StatusMessage);
            return simulation;
        }
    }
}
