using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Profiling;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// Every public component around one liquid is turned off and on, destroyed and added, and gives all back. SPHFLUID_LONG_PLAY=50 does
    /// it so many times and judges by the memory of the whole process as well.
    /// </summary>
    public sealed class TogglingTests
    {
        private const int Warm = 3;

        [UnityTest]
        public IEnumerator EveryComponentReturnsItsMemory()
        {
            int cycles = int.Parse(Environment.GetEnvironmentVariable("SPHFLUID_LONG_PLAY") ?? "3", CultureInfo.InvariantCulture);
            using var rig = new SimulationRig();
            FluidSimulation simulation = rig.Create();
            var parts = new List<(GameObject Holder, Type Type)>();
            foreach (Type type in ProductTypes.All)
                if (type.IsPublic && !type.IsAbstract && typeof(MonoBehaviour).IsAssignableFrom(type) && type != typeof(FluidSimulation))
                {
                    parts.Add((Holder(rig, simulation, type), type));
                }
            Assert.That(parts, Has.Count.GreaterThan(16));
            SwitchAll(parts, true);
            long running = 0, gpu = 0, process = 0;
            int objects = 0;
            for (int cycle = 1; cycle <= Warm + cycles; cycle++)
            {
                SwitchAll(parts, false);
                yield return null;
                SwitchAll(parts, true);
                for (int frame = 0; frame < 5 && !simulation.IsRunning; frame++) yield return null;
                Assert.That(simulation.IsRunning, simulation.StatusMessage);
                foreach ((GameObject holder, Type type) in parts) Object.DestroyImmediate(holder.GetComponent(type));
                SwitchAll(parts, true);
                yield return null;
                running = Math.Max(running, simulation.GpuBytes);
                simulation.enabled = false;
                SwitchAll(parts, false);
                yield return null;
                if (cycle == Warm) (gpu, objects, process) = (Profiler.GetAllocatedMemoryForGraphicsDriver(), Made(), ProcessBytes());
                simulation.enabled = true;
            }
            simulation.enabled = false;
            yield return null;
            Assert.That(running, Is.Positive);
            Assert.That(Made(), Is.EqualTo(objects), "meshes, materials and textures");
            Assert.That(Profiler.GetAllocatedMemoryForGraphicsDriver(), Is.EqualTo(gpu), "bytes of the device");
            long grown = ProcessBytes() - process;
            TestContext.WriteLine($"{cycles} times: the process grew by {grown >> 10} kB");
            if (cycles >= 50) Assert.That(grown, Is.LessThan(5 << 20), "bytes of the process");
        }

        // What draws, or needs a simulation on its object, gets the liquid's.
        private static GameObject Holder(SimulationRig rig, FluidSimulation simulation, Type type)
        {
            if (typeof(FluidView).IsAssignableFrom(type) || type == typeof(FluidDiagnostics) || type == typeof(FluidWhitewater) ||
                type == typeof(FluidLevelOfDetail))
            {
                return simulation.gameObject;
            }
            GameObject holder = rig.NewObject(type.Name);
            holder.transform.SetParent(simulation.transform, false);
            holder.transform.localPosition = new Vector3(0.1f, 0.15f, 0.1f);
            holder.transform.localScale = 0.1f * Vector3.one;
            return holder;
        }

        private static void SwitchAll(List<(GameObject Holder, Type Type)> parts, bool on)
        {
            foreach ((GameObject holder, Type type) in parts)
            {
                if (!holder.TryGetComponent(type, out Component part)) part = holder.AddComponent(type);
                ((Behaviour)part).enabled = on;
            }
        }

        private static int Made() => Resources.FindObjectsOfTypeAll<Object>().Count(o => o is Mesh || o is Material || o is Texture);

        private static long ProcessBytes()
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
            return System.Diagnostics.Process.GetCurrentProcess().WorkingSet64;
        }
    }
}
