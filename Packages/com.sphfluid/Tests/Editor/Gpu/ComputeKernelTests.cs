using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class ComputeKernelTests
    {
        [TestCase(0, 0, 0)]
        [TestCase(1, 1, 1)]
        [TestCase(65535, 65535, 1)]
        [TestCase(65536, 65535, 2)]
        [TestCase(65538, 65535, 2)]
        [TestCase(131071, 65535, 3)]
        public void GroupsBeyondTheLimitContinueInY(int groups, int x, int y)
        {
            Assert.That(ComputeKernel.SplitGroups(groups), Is.EqualTo(new Vector2Int(x, y)));
        }

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(255)]
        [TestCase(256)]
        [TestCase(257)]
        [TestCase(65535 * 256 + 1)]
        public void EachElementHasOneThread(int count)
        {
            var kernel = new ComputeKernel(TestShaders.Load("Tests/Editor/Gpu/LayoutEcho.compute"), "CountThreads");
            using (GraphicsBuffer threads = GpuBuffers.Create("Threads", 2, sizeof(uint)))
            {
                threads.SetData(new uint[2]);
                GpuTest.Run(cmd =>
                {
                    kernel.SetInt(cmd, Shader.PropertyToID("_ThreadCount"), count);
                    kernel.SetBuffer(cmd, Shader.PropertyToID("_Threads"), threads);
                    kernel.DispatchThreads(cmd, count);
                });
                uint[] result = GpuTest.Read<uint>(threads, 2);
                Assert.That(result[0], Is.EqualTo((uint)count), "threads");
                Assert.That(result[1], Is.EqualTo((uint)((long)count * (count - 1) / 2 % 4294967296L)), "sum of indices");
            }
        }

        [Test]
        public void AKernelWithoutAKeywordIsNamed()
        {
            var kernel = new ComputeKernel(TestShaders.Load("Thesis/Shaders/Solver/ResetGridIndices.compute"), "ResetGridIndices");
            Assert.That(() => GpuTest.Run(cmd => kernel.SetKeyword(cmd, "FLUID_PERIODIC", true)),
                Throws.TypeOf<FluidDeviceException>().With.Message.Contains("multi_compile_local _ FLUID_PERIODIC"));
        }

        [Test]
        public void GroupSizeComesFromTheShader()
        {
            var kernel = new ComputeKernel(TestShaders.Load("Thesis/Shaders/Solver/BitonicSort.compute"), "MatrixTranspose");
            Assert.That(kernel.GroupSize, Is.EqualTo(new Vector3Int(32, 32, 1)));
        }

        [Test]
        public void MissingKernelIsNamed()
        {
            ComputeShader shader = TestShaders.Load("Thesis/Shaders/Solver/BitonicSort.compute");
            var error = Assert.Throws<FluidDeviceException>(() => new ComputeKernel(shader, "QuickSort"));
            Assert.That(error.Message, Does.Contain("QuickSort"));
        }

        [Test]
        public void MissingShaderIsNamed()
        {
            var error = Assert.Throws<FluidDeviceException>(() => new ComputeKernel(null, "CalculateDensity"));
            Assert.That(error.Message, Does.Contain("CalculateDensity").And.Contain("shader set"));
        }

        [Test]
        public void BufferBeyondTheDeviceIsNamed()
        {
            var error = Assert.Throws<FluidDeviceException>(() => GpuBuffers.Create("Huge", long.MaxValue / 64, 48));
            Assert.That(error.Message, Does.Contain("Huge"));
        }
    }
}
