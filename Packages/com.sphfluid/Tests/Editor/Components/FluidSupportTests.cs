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
            Assert.That(support.Simulation && support.Runs(GeometrySurface.Group) && support.AsyncReadback);
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

        [Test]
        public void GroupsOf256ThreadsRunTheStandardMethodOnly()
        {
            DeviceCapabilities device = Device();
            device.GroupThreads = 256;
            FluidSupport support = FluidSupport.From(device);
            Assert.That(support.Simulation && support.Supports(FluidMethodKind.Standard) && support.Surface);
            Assert.That(support.ErrorsOf(FluidMethodKind.Standard), Is.Empty);
            Assert.That(support.Messages.Single().Severity, Is.EqualTo(FluidSeverity.Info), "the liquid runs");
            foreach (FluidMethodKind method in new[] { FluidMethodKind.Thesis, FluidMethodKind.ThesisPrinted })
            {
                Assert.That(support.Supports(method), Is.False);
                FluidMessage refusal = support.ErrorsOf(method).Single();
                Assert.That(refusal.Severity, Is.EqualTo(FluidSeverity.Error));
                Assert.That(refusal.Text, Does.Contain("Old Card runs compute groups of 256 threads; the thesis method needs 1024"));
                Assert.That(refusal.Cure, Does.Contain("Method to Standard"));
            }
        }

        [Test]
        public void FewBuffersLeaveTheMethodThatNeedsFewer()
        {
            DeviceCapabilities device = Device();
            device.ComputeBuffers = 8;
            FluidSupport support = FluidSupport.From(device);
            Assert.That(support.Simulation && support.Supports(FluidMethodKind.Thesis) && !support.Supports(FluidMethodKind.Standard));
            Assert.That(support.ErrorsOf(FluidMethodKind.Standard).Single().ToString(),
                Does.Contain("binds 8 buffers").And.Contain("Method to Thesis"));
        }

        [Test]
        public void ThirteenBuffersRunEverything()
        {
            DeviceCapabilities device = Device();
            device.ComputeBuffers = 13;
            FluidSupport support = FluidSupport.From(device);
            foreach (FluidMethodKind method in new[] { FluidMethodKind.Standard, FluidMethodKind.Robust, FluidMethodKind.Thesis })
            {
                Assert.That(support.ErrorsOf(method), Is.Empty, method.ToString());
            }
            Assert.That(support.Surface && support.WallForces);
            Assert.That(support.Messages, Is.Empty);
        }

        [Test]
        public void TwelveBuffersRunStandardWithoutWallForces()
        {
            DeviceCapabilities device = Device();
            device.ComputeBuffers = 12;
            FluidSupport support = FluidSupport.From(device);
            Assert.That(support.ErrorsOf(FluidMethodKind.Standard), Is.Empty);
            Assert.That(support.ErrorsOf(FluidMethodKind.Thesis), Is.Empty);
            Assert.That(support.ErrorsOf(FluidMethodKind.Robust), Is.Not.Empty);
            Assert.That(support.Surface && !support.WallForces);
            FluidMessage message = support.Messages.Single(m => m.Text.Contains("the force on walls needs 13"));
            Assert.That(message.Severity, Is.EqualTo(FluidSeverity.Info));
            Assert.That(message.ToString(), Does.Contain("Liquid Pressure"));
        }

        [TestCase(128, 64, "groups of 128 threads")]
        [TestCase(1024, 4, "binds 4 buffers")]
        public void SmallLimitsStopTheSimulation(int threads, int buffers, string reason)
        {
            DeviceCapabilities device = Device();
            device.GroupThreads = threads;
            device.ComputeBuffers = buffers;
            FluidSupport support = FluidSupport.From(device);
            Assert.That(support.Simulation || support.Surface, Is.False);
            Assert.That(support.Messages.Select(m => m.Text), Has.Some.Contain(reason).And.Some.Contain("the Standard method"));
            Assert.That(support.Messages.Select(m => m.Severity), Has.Some.EqualTo(FluidSeverity.Error));
            foreach (FluidMethodKind method in new[] { FluidMethodKind.Standard, FluidMethodKind.Thesis })
            {
                Assert.That(support.ErrorsOf(method).Single().Cure, Does.Contain("another graphics device"));
            }
        }

        [Test]
        public void WithoutBuffersInVertexShadersNoSurfaceIsDrawn()
        {
            DeviceCapabilities device = Device();
            device.VertexBuffers = 0;
            FluidSupport support = FluidSupport.From(device);
            Assert.That(support.Simulation && !support.Surface);
            Assert.That(support.Messages.First().Text, Does.Contain("binds 0 buffers to a vertex shader; the drawing needs 1"));
            Assert.That(support.Messages.Skip(1).Single().Text, Does.Contain("whitewater needs"));
        }

        [Test]
        public void ADeviceRunsWhatItSupports()
        {
            FluidSupport support = FluidSupport.Query();
            foreach (FluidMethodKind method in new[] { FluidMethodKind.Standard, FluidMethodKind.Thesis })
            {
                Assert.That(support.Supports(method), Is.EqualTo(support.ErrorsOf(method).Count == 0));
            }
        }

        [Test]
        public void NoGeometryShadersStopsOnlyThatSurface()
        {
            DeviceCapabilities device = Device();
            device.GeometryShaders = false;
            FluidSupport support = FluidSupport.From(device);
            Assert.That(support.Simulation);
            Assert.That(support.Runs(GeometrySurface.Group), Is.False);
            Assert.That(support.Messages.Single().Cure, Does.Contain("Fluid Surface Renderer"));
        }

        private static DeviceCapabilities Device() => new DeviceCapabilities
        {
            Name = "Old Card", ComputeShaders = true, GeometryShaders = true, AsyncReadback = true, GroupThreads = 1024,
            ComputeBuffers = 20,
            VertexBuffers = 16,
        };
    }
}
