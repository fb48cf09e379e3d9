using System.Linq;
using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>Each missing capability is one sentence with the device's name; only those the solver needs stop it.</summary>
    public sealed class FluidSupportTests
    {
        [Test]
        public void FullDeviceHasNothingToReport()
        {
            FluidSupport support = FluidSupport.From(Device());
            Assert.That(support.Simulation && support.GeometrySurface && support.AsyncReadback);
            Assert.That(support.Messages, Is.Empty);
        }

        [Test]
        public void NoComputeShadersStopsTheSimulation()
        {
            DeviceCapabilities device = Device();
            device.ComputeShaders = false;
            FluidSupport support = FluidSupport.From(device);
            Assert.That(support.Simulation, Is.False);
            Assert.That(support.Messages.Single().ToString(), Does.Contain("Old Card has no compute shaders").And.Contain("Use Direct3D"));
            Assert.That(support.Messages.Single().Severity, Is.EqualTo(FluidSeverity.Error));
        }

        [TestCase(256, 16, "groups of 256 threads")]
        [TestCase(1024, 4, "binds 4 buffers")]
        public void SmallLimitsStopTheSimulation(int threads, int buffers, string reason)
        {
            DeviceCapabilities device = Device();
            device.GroupThreads = threads;
            device.ComputeBuffers = buffers;
            FluidSupport support = FluidSupport.From(device);
            Assert.That(support.Simulation, Is.False);
            Assert.That(support.Messages.Single().Text, Does.Contain(reason));
        }

        [Test]
        public void NoGeometryShadersStopsOnlyThatSurface()
        {
            DeviceCapabilities device = Device();
            device.GeometryShaders = false;
            FluidSupport support = FluidSupport.From(device);
            Assert.That(support.Simulation);
            Assert.That(support.GeometrySurface, Is.False);
            Assert.That(support.Messages.Single().Cure, Does.Contain("Fluid Surface Renderer"));
        }

        static DeviceCapabilities Device() => new DeviceCapabilities
        {
            Name = "Old Card", ComputeShaders = true, GeometryShaders = true, AsyncReadback = true, GroupThreads = 1024, ComputeBuffers = 16,
        };
    }
}
