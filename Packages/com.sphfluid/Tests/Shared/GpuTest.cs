using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>Runs recorded work and reads results back; tests skip with a reason where the device has no compute shaders.</summary>
    public static class GpuTest
    {
        /// <summary>Ignores the running test on devices that cannot run it.</summary>
        public static void Require()
        {
            if (!SystemInfo.supportsComputeShaders)
            {
                Assert.Ignore($"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) has no compute shaders.");
            }
        }

        /// <summary>Records into a command buffer of its own and executes it.</summary>
        public static void Run(Action<CommandBuffer> record)
        {
            using (var cmd = new CommandBuffer { name = "Test" })
            {
                record(cmd);
                Graphics.ExecuteCommandBuffer(cmd);
            }
        }

        /// <summary>Waits for the GPU and reads the first elements of a buffer.</summary>
        public static T[] Read<T>(GraphicsBuffer buffer, int count) where T : struct
        {
            var data = new T[count];
            if (count > 0) buffer.GetData(data, 0, 0, count);

            return data;
        }
    }
}
