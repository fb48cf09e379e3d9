using System;
using System.Collections;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>The tables of the manual: a dam of 8,000 particles that breaks at a level of detail.</summary>
    [Explicit("Takes minutes.")]
    public sealed class LevelOfDetailFigures
    {
        private const float Spacing = 0.02f;
        private const int SecondsShown = 4;

        [UnityTest]
        public IEnumerator Motion([Values(FluidMethodKind.Standard, FluidMethodKind.Robust)] FluidMethodKind method,
            [Values(1f, 1.5f, 2f)] float factor)
        {
            using (var rig = new SimulationRig(1f / 60f))
            {
                FluidSimulation dam = Dam(rig, new FluidDetailLevel { Distance = 1f, StepFactor = factor });
                dam.Method = method;
                string row = FormattableString.Invariant($"| {method} | {factor} |");
                double most = 0.0, mean = 0.0, front = 0.0;
                long steps = 0;
                while (!dam.IsRunning) yield return null;
                for (int frame = 1; frame <= 60 * SecondsShown; frame++)
                {
                    yield return null;
                    if (frame == 22)
                    {
                        float[] places = Sorted(SimulationRig.Read(dam).Select(p => p.Position.x + 0.2f));
                        front = places[(int)(0.99 * places.Length)];
                    }
                    if (frame % 6 == 0)
                    {
                        float[] pressed = Compressions(dam);
                        most = Math.Max(most, pressed[(int)(0.99 * pressed.Length)]);
                        mean = pressed.Average();
                    }
                    if (frame % 60 != 0) continue;
                    if (frame == 60 || frame == 60 * SecondsShown)
                    {
                        row += FormattableString.Invariant($" {(dam.StepCount - steps) / 60.0:0.0} |");
                    }
                    steps = dam.StepCount;
                }
                row += FormattableString.Invariant($" {100.0 * most:0.0} % | {100.0 * mean:0.0} % | {front:0.000} m | ");
                Console.WriteLine(row + FormattableString.Invariant($"{1e3 * (SimulationRig.MeanHeight(dam) + 0.3):0.0} mm |"));
            }
        }

        [UnityTest]
        public IEnumerator Surface([Values(1f, 1.5f, 2f, 2.67f)] float factor)
        {
            using (var rig = new SimulationRig(1f / 60f))
            {
                FluidSimulation dam = Dam(rig, new FluidDetailLevel { Distance = 1f, CellFactor = factor });
                var view = dam.gameObject.AddComponent<FluidSurfaceRenderer>();
                GameObject lamp = rig.NewObject("Light");
                lamp.AddComponent<Light>().type = LightType.Directional;
                lamp.transform.rotation = Quaternion.Euler(50f, 20f, 0f);
                Camera camera = Camera.allCameras.First(c => c.name == "Far");
                camera.transform.position = new Vector3(0f, 0.3f, -1.9f);
                camera.transform.rotation = Quaternion.Euler(12f, 0f, 0f);
                var target = new RenderTexture(640, 360, 24);
                camera.targetTexture = target;
                for (int frame = 0; frame < 30; frame++) yield return null;
                using (var meter = new OverlayMeter(StageClock.Gpu))
                {
                    meter.Update(dam, 0.01, 1.0, true);
                    for (int frame = 0; frame < 20; frame++)
                    {
                        yield return null;
                        meter.Update(dam, 0.01, 10.0, true);
                    }
                    meter.Update(dam, 10.0, 1.0, true);
                    string row = FormattableString.Invariant($"cells {factor}: {view.Status.Triangles} triangles, {view.GpuBytes} bytes");
                    Console.WriteLine($"{row}\n{meter.Text}");
                }
                var picture = new Texture2D(640, 360, TextureFormat.RGBA32, false);
                RenderTexture.active = target;
                picture.ReadPixels(new Rect(0, 0, 640, 360), 0, 0);
                picture.Apply();
                RenderTexture.active = null;
                string path = Path.Combine(Path.GetTempPath(), FormattableString.Invariant($"detail-{factor}.png"));
                File.WriteAllBytes(path, picture.EncodeToPNG());
                Console.WriteLine(path);
                camera.targetTexture = null;
                UnityEngine.Object.DestroyImmediate(picture);
                UnityEngine.Object.DestroyImmediate(target);
            }
        }

        private static FluidSimulation Dam(SimulationRig rig, FluidDetailLevel level)
        {
            FluidSimulation dam = rig.Create(liquid: false);
            (dam.Spacing, dam.DomainSize, dam.SleepsAtRest) = (Spacing, new Vector3(1.2f, 0.6f, 0.4f), false);
            FluidVolume block = rig.AddVolume(dam);
            block.Size = 0.4f * Vector3.one;
            block.transform.localPosition = new Vector3(-0.4f, -0.1f, 0f);
            Camera far = rig.NewObject("Far").AddComponent<Camera>();
            far.transform.position = 10f * Vector3.back;
            FluidLevelOfDetail detail = dam.gameObject.AddComponent<FluidLevelOfDetail>();
            detail.UseLodBias = false;
            detail.Levels.Clear();
            detail.Levels.Add(level);
            return dam;
        }

        private static float[] Compressions(FluidSimulation dam)
        {
            var densities = new float[dam.ParticleCount];
            dam.Solver.Density.GetData(densities);
            return Sorted(densities.Select(d => Mathf.Max(0f, d / 1000f - 1f)));
        }

        private static float[] Sorted(System.Collections.Generic.IEnumerable<float> values)
        {
            float[] sorted = values.ToArray();
            Array.Sort(sorted);
            return sorted;
        }
    }
}
