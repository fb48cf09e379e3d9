using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A little liquid in a level of a hundred metres: it starts, steps, is drawn, asked and made white.</summary>
    public sealed class LargeDomainTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator ALevelPlays([Values(FluidMethodKind.Standard, FluidMethodKind.Robust)] FluidMethodKind method)
        {
            FluidSimulation simulation = rig.Create(liquid: false);
            simulation.Method = method;
            simulation.DomainSize = new Vector3(100f, 20f, 100f);
            simulation.Spacing = 0.05f;
            FluidVolume volume = rig.AddVolume(simulation);
            volume.transform.localPosition = new Vector3(49.8f, -9.8f, -49.8f);
            Assert.That(simulation.Validate().Where(m => m.Severity == FluidSeverity.Error), Is.Empty);
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            int count = simulation.ParticleCount;
            Assert.That(count, Is.EqualTo(64));
            simulation.gameObject.AddComponent<FluidWhitewater>().MaxParticles = 1024;
            FluidSurfaceMesh surface = simulation.gameObject.AddComponent<FluidSurfaceMesh>();
            var material = new Material(rig.Profile.Shaders.Find("SPH Fluid/Surface"));
            simulation.gameObject.AddComponent<MeshRenderer>().sharedMaterial = material;
            FluidQuery wet = simulation.Queries.AddPoint(volume.transform.position - 0.05f * Vector3.up);
            FluidQuery dry = simulation.Queries.AddPoint(Vector3.zero);
            for (int frame = 0; frame < 6; frame++) yield return null;
            simulation.Queries.Complete();
            Assert.That(simulation.Queries.TryGet(wet, out FluidPointResult inside));
            Assert.That(inside.Density, Is.EqualTo(1000f).Within(200f));
            Assert.That(simulation.Queries.TryGet(dry, out FluidPointResult outside));
            Assert.That(outside.Density, Is.Zero);
            FluidParticle[] particles = SimulationRig.Read(simulation);
            Assert.That(particles.Length, Is.EqualTo(count));
            Assert.That(particles.All(p => (p.Position - volume.transform.localPosition).magnitude < 0.3f));
            for (int i = 0; i < 3; i++)
            {
                surface.DrawFrame();
                AsyncGPUReadback.WaitAllRequests();
            }
            Vector3[] corners = MeshTriangles.Read(surface.Mesh, Matrix4x4.identity).ToArray();
            Assert.That(corners.Length, Is.GreaterThan(300));
            Assert.That(corners.All(corner => particles.Any(p => (p.Position - corner).magnitude < 0.1f)), "the surface is at the liquid");
            Assert.That(simulation.GpuBytes, Is.LessThan(10_000_000L));
            LogAssert.NoUnexpectedReceived();
            Object.DestroyImmediate(material);
        }
    }
}
