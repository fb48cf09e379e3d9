using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Play mode without a domain reload: a second play begins with the statics of the first, and goes as the first did.</summary>
    public sealed class PlayTwiceTests
    {
        private const int Frames = 3;

        private static readonly List<string> Planted = new List<string>();

        private SimulationRig rig;
        private RenderTexture picture;

        [TearDown]
        public void TearDown()
        {
            rig?.Dispose();
            UnityEngine.Object.DestroyImmediate(picture);
        }

        [UnityTest]
        public IEnumerator ASecondPlayBeginsAndGoesAsTheFirst()
        {
            GpuTest.Require();
            if (!EditorSettings.enterPlayModeOptionsEnabled ||
                (EditorSettings.enterPlayModeOptions & EnterPlayModeOptions.DisableDomainReload) == 0)
            {
                Assert.Ignore("This project's settings reload the domain when play mode is entered.");
            }
            var begun = new Dictionary<string, string>[2];
            var hashes = new ulong[2];
            for (int play = 0; play < 2; play++)
            {
                yield return new EnterPlayMode(expectDomainReload: false);
                begun[play] = StaticState.Read();
                FluidSimulation simulation = PlayEverything();
                for (int frame = 0; frame < Frames; frame++) yield return null;
                Assert.That(simulation.StepCount, Is.Positive, simulation.StatusMessage);
                Assert.That((WaterCameras.IsListening, MainLightShadows.IsListening), Is.EqualTo((true, true)),
                    "water and shadows are part of it");
                hashes[play] = simulation.ComputeStateHash();
                yield return new ExitPlayMode();
                TearDown();
                Assert.That(StaticState.Read().Where(s => StaticState.LeadsToTheEngine(s.Value)).Select(s => $"{s.Key}: {Start(s.Value)}"),
                    Is.Empty, "after play");
            }
            Assert.That(begun[0].Count, Is.GreaterThan(100));
            Assert.That(begun[1].Where(s => begun[0][s.Key] != s.Value)
                .Select(s => $"{s.Key}: {Start(begun[0][s.Key])}, then {Start(s.Value)}"), Is.Empty, "as play begins");
            Assert.That(hashes[1], Is.EqualTo(hashes[0]));
        }

        [Test]
        public void WhatAStaticHoldsIsTold()
        {
            Planted.Add("a");
            string told = StaticState.Tell(Planted);
            Planted.Add("b");
            Assert.That(StaticState.Tell(Planted), Is.Not.EqualTo(told));
            var cyclic = new object[] { 1, null };
            cyclic[1] = cyclic;
            Assert.That(StaticState.Tell(cyclic), Is.EqualTo("[1; as above; ]"));
            var holder = new GameObject("Held");
            Assert.That(
                StaticState.LeadsToTheEngine(
                    StaticState.Tell(
                        new List<KeyValuePair<string, Transform>> { new KeyValuePair<string, Transform>("", holder.transform) })));
            UnityEngine.Object.DestroyImmediate(holder);
        }

        private static string Start(string text) => text.Length > 80 ? text.Substring(0, 80) : text;

        // A liquid with one of every component of the package at it.
        private FluidSimulation PlayEverything()
        {
            rig = new SimulationRig();
            LogAssert.ignoreFailingMessages = true;
            var camera = rig.NewObject("Camera").AddComponent<Camera>();
            camera.transform.position = new Vector3(0f, 0f, -1f);
            camera.targetTexture = picture = new RenderTexture(64, 48, 24);
            Light light = rig.NewObject("Light").AddComponent<Light>();
            light.type = LightType.Directional;
            light.shadows = LightShadows.Soft;
            FluidSimulation simulation = rig.Create();
            simulation.Method = FluidMethodKind.Standard;
            foreach (Type type in ProductTypes.All
                .Where(t => t.IsPublic && !t.IsAbstract && typeof(MonoBehaviour).IsAssignableFrom(t)))
            {
                if (type == typeof(FluidSimulation)) continue;
                bool beside = type.GetCustomAttributes(typeof(RequireComponent), true).Cast<RequireComponent>()
                    .Any(r => r.m_Type0 == typeof(FluidSimulation));
                GameObject holder = beside ? simulation.gameObject : rig.NewObject(type.Name);
                if (!beside) holder.transform.SetParent(simulation.transform, false);
                if (type == typeof(FluidCollider)) holder.AddComponent<BoxCollider>().size = 0.1f * Vector3.one;
                Component part = holder.AddComponent(type);
                if (part is FluidView view) view.Simulation = simulation;
                if (part is FluidGeometrySurfaceRenderer grid) grid.GridSize = SurfaceGridSize.Cells32; // the smallest
            }
            return simulation;
        }
    }
}
