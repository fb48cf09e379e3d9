using System;
using System.Collections;
using System.IO;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Profiling;
using UnityEngine.SceneManagement;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Scenes with liquid come and go: nothing of them stays.</summary>
    public sealed class SceneLoadTests
    {
        private const int Scenes = 50, Settled = 9;

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
            UnityEngine.Object.DestroyImmediate(material);
        }

        [UnityTest]
        public IEnumerator FiftyScenesReturnTheirGpuMemory()
        {
            long first = 0, running = 0, most = 0;
            for (int i = 0; i < Scenes; i++)
            {
                Scene scene = SceneManager.CreateScene($"Level {i}");
                FluidSimulation simulation = Furnish(scene);
                for (int wait = 0; wait < 20 && !simulation.IsRunning; wait++) yield return null;
                Assert.That(simulation.IsRunning, simulation.StatusMessage);
                yield return null;
                simulation.GetComponent<FluidSurfaceMesh>().DrawFrame();
                var save = new MemoryStream();
                simulation.Save(save);
                save.Position = 0;
                Assert.That(simulation.Restore(save), simulation.StatusMessage);
                yield return null;
                running = Math.Max(running, simulation.GpuBytes);
                most = Math.Max(most, Profiler.GetAllocatedMemoryForGraphicsDriver());
                yield return SceneManager.UnloadSceneAsync(scene);
                Assert.That(simulation == null, "the scene took it along");
                yield return null;
                if (i == Settled) first = Profiler.GetAllocatedMemoryForGraphicsDriver();
            }
            Assert.That(FluidSimulation.Active, Is.Empty);
            Assert.That(most - first, Is.GreaterThan(running / 2), "what is measured counts buffers");
            Assert.That(Profiler.GetAllocatedMemoryForGraphicsDriver() - first, Is.LessThan(running),
                "a fortieth of a scene's memory that stayed would show");
        }

        private FluidSimulation Furnish(Scene scene)
        {
            FluidSimulation simulation = rig.Create();
            SceneManager.MoveGameObjectToScene(simulation.gameObject, scene);
            simulation.gameObject.AddComponent<MeshFilter>();
            simulation.gameObject.AddComponent<MeshRenderer>().sharedMaterial = material;
            simulation.gameObject.AddComponent<FluidSurfaceMesh>();
            GameObject crate = rig.NewObject("Crate");
            crate.AddComponent<BoxCollider>().size = new Vector3(0.1f, 0.06f, 0.1f);
            crate.AddComponent<Rigidbody>().mass = 0.3f;
            GameObject nozzle = rig.NewObject("Nozzle");
            nozzle.transform.localPosition = new Vector3(0.1f, 0.15f, 0.1f);
            nozzle.AddComponent<FluidEmitter>().Size = new Vector2(0.1f, 0.1f);
            SceneManager.MoveGameObjectToScene(crate, scene);
            SceneManager.MoveGameObjectToScene(nozzle, scene);
            return simulation;
        }
    }
}
