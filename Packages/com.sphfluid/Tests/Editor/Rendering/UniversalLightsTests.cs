using System;
using NUnit.Framework;
using UnityEngine;
using Random = System.Random;

namespace SphFluid.Tests
{
    /// <summary>Further lights as the Universal Render Pipeline hands them over: which ones a point gets, and how much light.</summary>
    public sealed class UniversalLightsTests
    {
        private const int MostLights = 256;

        private readonly Vector4[] positions = new Vector4[MostLights];
        private readonly Vector4[] colours = new Vector4[MostLights];
        private readonly Vector4[] attenuations = new Vector4[MostLights];
        private readonly Vector4[] directions = new Vector4[MostLights];

        private ComputeShader shader;

        [SetUp]
        public void SetUp()
        {
            shader = TestShaders.Load("Tests/Editor/Rendering/SumLamps.compute");
            shader.SetMatrix("unity_MatrixV", Matrix4x4.Scale(new Vector3(1f, 1f, -1f))); // a camera in the origin that looks along z
            shader.SetVector("_WorldSpaceCameraPos", Vector3.zero);
            shader.SetVector("unity_OrthoParams", Vector4.zero);
            for (int i = 0; i < MostLights; i++) Directional(i, 0f);
        }

        // At half the range a sixteenth of the falloff's square is gone: (1 - 1 / 16)^2 of the inverse square.
        [TestCase(2f, 0.25f * 0.87890625f)]
        [TestCase(1f, 0.9921875f)]
        [TestCase(4f, 0f)]
        [TestCase(5f, 0f)]
        public void APointLightFallsOffToItsRange(float metres, float expected)
        {
            positions[0] = new Vector4(0f, metres, 3f, 1f);
            attenuations[0] = new Vector4(1f / 16f, 0f, 0f, 1f);
            colours[0] = Vector4.one;
            Assert.AreEqual(expected, Listed(new Vector3(0f, 0f, 3f), 0).x, 1e-4f);
        }

        // Full inside 20 degrees, nothing beyond 30, the square between; straight above, the axis leans away from the point.
        [TestCase(0f, 1f)]
        [TestCase(19f, 1f)]
        [TestCase(31f, 0f)]
        [TestCase(25f, -1f)]
        public void ASpotLightFallsOffBetweenItsCones(float lean, float expected)
        {
            float inner = Mathf.Cos(20f * Mathf.Deg2Rad), outer = Mathf.Cos(30f * Mathf.Deg2Rad);
            float axis = lean * Mathf.Deg2Rad;
            positions[0] = new Vector4(0f, 1f, 3f, 1f);
            attenuations[0] = new Vector4(0f, 0f, 1f / (inner - outer), -outer / (inner - outer));
            directions[0] = new Vector4(Mathf.Sin(axis), Mathf.Cos(axis), 0f, 0f);
            colours[0] = Vector4.one;
            float share = (Mathf.Cos(axis) - outer) / (inner - outer);
            Assert.AreEqual(expected >= 0f ? expected : share * share, Listed(new Vector3(0f, 0f, 3f), 0).x, 1e-3f);
        }

        [Test]
        public void AnObjectGetsTheLightsOfItsList()
        {
            for (int i = 0; i < 9; i++) Directional(i, 1 << i);
            Vector4 lit = Listed(Vector3.forward, 7, 0, 8, 3, 2);
            Assert.AreEqual((1 << 7) + 1 + (1 << 8) + (1 << 3) + (1 << 2), lit.x);
            Assert.AreEqual(5f, lit.w);
        }

        // 3 directional lights, and 70 others whose bits fill three words of 8 tiles and 6 bins at random.
        [Test]
        public void APointGetsTheLightsOfItsTileAndBin()
        {
            const int directional = 3, others = 70, words = 3, columns = 4, rows = 2, bins = 6;
            var random = new Random(7);
            for (int i = 0; i < directional + others; i++) Directional(i, i + 1f);
            uint[] tiles = Words(random, columns * rows * words);
            var binned = new uint[bins * (2 + words)];
            for (int bin = 0; bin < bins; bin++)
            {
                uint first = (uint)random.Next(40), last = (uint)random.Next(40, others);
                binned[bin * (2 + words)] = bin == 2 ? 0xFFFFu : first | (last << 16); // an empty bin has its first light after its last
                Words(random, words).CopyTo(binned, bin * (2 + words) + 2);
            }

            const int points = 64;
            var places = new Vector4[2 * points];
            for (int i = 0; i < points; i++)
            {
                float bin = (float)random.NextDouble() * (bins + 1); // the last ones lie beyond the far plane
                places[2 * i] = new Vector3(0f, 0f, Mathf.Pow(2f, (bin - 1f) / 2f));
                places[2 * i + 1] = new Vector2((float)random.NextDouble(), (float)random.NextDouble());
            }
            shader.DisableKeyword("_ADDITIONAL_LIGHTS");
            shader.EnableKeyword("_CLUSTER_LIGHT_LOOP");
            shader.SetVector("_FPParams0", new Vector4(2f, 1f, others, directional)); // bin 2 log2 z + 1
            shader.SetVector("_FPParams1", new Vector4(columns, rows, columns, words));
            shader.SetVector("_FPParams2", new Vector4(bins, columns * rows, 0f, 0f));
            using (GraphicsBuffer binBuffer = Constants(binned, 1024))
            using (GraphicsBuffer tileBuffer = Constants(tiles, 4096))
            {
                shader.SetConstantBuffer("urp_ZBinBuffer", binBuffer, 0, 1024 * 16);
                shader.SetConstantBuffer("urp_TileBuffer", tileBuffer, 0, 4096 * 16);
                Vector4[] lit = Sum(places);
                int most = 0;
                for (int i = 0; i < points; i++)
                {
                    int bin = Mathf.Min((int)(2f * Mathf.Log(places[2 * i].z, 2f) + 1f), bins - 1) * (2 + words);
                    Vector4 screen = places[2 * i + 1];
                    int tile = ((int)(screen.y * rows) * columns + (int)(screen.x * columns)) * words;
                    float sum = directional * (directional + 1) / 2f;
                    int count = directional;
                    for (int light = 0; light < others; light++)
                    {
                        uint bits = tiles[tile + light / 32] & binned[bin + 2 + light / 32];
                        bool isInBin = light >= (binned[bin] & 0xFFFF) && light <= binned[bin] >> 16;
                        if (!isInBin || ((bits >> (light % 32)) & 1) == 0) continue;
                        sum += directional + light + 1;
                        count++;
                    }
                    Assert.AreEqual(count, lit[i].w, $"lights of point {i}");
                    Assert.AreEqual(sum, lit[i].x, $"light of point {i}");
                    most = Math.Max(most, count);
                }
                Assert.Greater(most, directional + 8, "lights of some point");
            }
        }

        private void Directional(int index, float colour)
        {
            positions[index] = Vector3.up;
            colours[index] = new Vector4(colour, colour, colour, 0f);
            attenuations[index] = new Vector4(0f, 1f, 0f, 1f);
            directions[index] = Vector3.forward;
        }

        private Vector4 Listed(Vector3 point, params int[] lights)
        {
            var indices = new float[8];
            for (int i = 0; i < lights.Length; i++) indices[i] = lights[i];
            shader.DisableKeyword("_CLUSTER_LIGHT_LOOP");
            shader.EnableKeyword("_ADDITIONAL_LIGHTS");
            shader.SetVector("_AdditionalLightsCount", new Vector4(8f, 0f, 0f, 0f));
            shader.SetVector("unity_LightData", new Vector4(0f, lights.Length, 1f, 0f));
            shader.SetVectorArray("unity_LightIndices", new[]
            {
                new Vector4(indices[0], indices[1], indices[2], indices[3]), new Vector4(indices[4], indices[5], indices[6], indices[7]),
            });
            return Sum(new Vector4[] { point, Vector2.one * 0.5f })[0];
        }

        private Vector4[] Sum(Vector4[] places)
        {
            shader.SetVectorArray("_AdditionalLightsPosition", positions);
            shader.SetVectorArray("_AdditionalLightsColor", colours);
            shader.SetVectorArray("_AdditionalLightsAttenuation", attenuations);
            shader.SetVectorArray("_AdditionalLightsSpotDir", directions);
            using (var from = new GraphicsBuffer(GraphicsBuffer.Target.Structured, places.Length, 16))
            using (var to = new GraphicsBuffer(GraphicsBuffer.Target.Structured, places.Length / 2, 16))
            {
                from.SetData(places);
                int kernel = shader.FindKernel("SumLamps");
                shader.SetBuffer(kernel, "_Places", from);
                shader.SetBuffer(kernel, "_Lit", to);
                shader.Dispatch(kernel, places.Length / 2, 1, 1);
                var lit = new Vector4[places.Length / 2];
                to.GetData(lit);
                return lit;
            }
        }

        private static uint[] Words(Random random, int count)
        {
            var words = new uint[count];
            for (int i = 0; i < count; i++) words[i] = (uint)random.Next() ^ ((uint)random.Next() << 8);
            return words;
        }

        private static GraphicsBuffer Constants(uint[] words, int vectors)
        {
            var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Constant, vectors, 16);
            var whole = new uint[4 * vectors];
            words.CopyTo(whole, 0);
            buffer.SetData(whole);
            return buffer;
        }
    }
}
