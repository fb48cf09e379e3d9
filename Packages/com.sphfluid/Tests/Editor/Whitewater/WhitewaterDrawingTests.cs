using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Foam as it is drawn: one film that flakes show parts of and that goes along with the water.</summary>
    public sealed class WhitewaterDrawingTests
    {
        private const int Side = 96;
        private const float Spacing = 0.05f;
        private const double Period = 0.5;

        // Pixels a spacing: for many flakes, each 0.8 dx across, and for what they are made of.
        private const int Coarse = 12, Fine = 30;
        private const int FlakePixels = 10;

        [Test]
        public void NoFlakeIsRecognised()
        {
            double[] foam = Draw(Flakes(1, 500, Vector3.zero), 0.1, Coarse);
            TestContext.WriteLine($"autocorrelation at a flake's size {AtDistance(foam, FlakePixels):F3}");
            for (int distance = FlakePixels; distance <= 3 * FlakePixels; distance++)
            {
                Assert.That(AtDistance(foam, distance), Is.EqualTo(0.0).Within(0.1), $"at {distance} pixels");
            }
        }

        [Test]
        public void CellsBelongToThePlaceAndNotToTheFlake()
        {
            double[] first = Draw(Flakes(1, 3000, Vector3.zero), 0.1, Fine), second = Draw(Flakes(2, 3000, Vector3.zero), 0.1, Fine);
            Assert.That(Correlation(first, second, 0, 0), Is.GreaterThan(0.6));
        }

        [Test]
        public void CellsGoAlongWithTheWater()
        {
            const int moved = 16;
            var velocity = new Vector3(moved * Spacing / Fine / 0.1f, 0f, 0f);
            double[] before = Draw(Flakes(1, 3000, velocity), 0.2 * Period, Fine);
            double[] after = Draw(Flakes(2, 3000, velocity), 0.2 * Period + 0.1, Fine);
            TestContext.WriteLine($"moved {Correlation(before, after, moved, 0):F2}, in place {Correlation(before, after, 0, 0):F2}");
            Assert.That(Correlation(before, after, moved, 0), Is.GreaterThan(0.5));
            Assert.That(Correlation(before, after, 0, 0), Is.LessThan(0.3));
        }

        private static WhitewaterPiece[] Flakes(int seed, int count, Vector3 velocity)
        {
            var random = new System.Random(seed);
            return Enumerable.Range(0, count).Select(_ => new WhitewaterPiece
            {
                Position = 11f * Spacing * Vector3.Scale(ParticleSets.RandomVector(random), new Vector3(1f, 1f, 0f)),
                Velocity = velocity,
                Normal = Vector3.back,
                Life = 5f,
                Age = 1f,
                Seed = (uint)random.Next(1 << 20) << 2 | WhitewaterPiece.Foam,
            }).ToArray();
        }

        // What foam covers of each pixel, less the mean.
        private static double[] Draw(WhitewaterPiece[] pieces, double time, int pixelsPerSpacing)
        {
            GpuTest.Require();
            using (var buffers = new WhitewaterBuffers(pieces.Length))
            using (var drawing = new WhitewaterDrawing(TestShaders.PackageSet))
            {
                buffers.Present.SetData(pieces);
                buffers.DrawArguments.SetData(new[] { (uint)(pieces.Length * WhitewaterBuffers.VerticesPerPiece), 1u, 0u, 0u });
                drawing.Fill(buffers, Spacing, 1f, Color.white, new DrawPlacement(Matrix4x4.identity, Vector3.one, 0f, 0, false), time);
                float half = 0.5f * Spacing * Side / pixelsPerSpacing;
                Color[] picture = SurfaceTestScene.Render(Side, SurfaceTestScene.LookAtOrigin(2f * Vector3.back),
                    Matrix4x4.Ortho(-half, half, -half, half, 0.1f, 10f), cmd =>
                    {
                        cmd.SetGlobalVector("_WorldSpaceCameraPos", 1000f * Vector3.back); // the same view everywhere
                        drawing.Record(cmd);
                    });
                double mean = picture.Average(pixel => pixel.a);
                Assert.That(mean, Is.InRange(0.02, 0.98));
                return picture.Select(pixel => pixel.a - mean).ToArray();
            }
        }

        // Mean over eight directions.
        private static double AtDistance(double[] foam, int distance) => Enumerable.Range(0, 8).Average(k => Correlation(foam, foam,
            (int)Math.Round(distance * Math.Cos(k * Math.PI / 8)), (int)Math.Round(distance * Math.Sin(k * Math.PI / 8))));

        // Of the first picture with the second, which is moved to the right and upwards.
        private static double Correlation(double[] first, double[] second, int right, int up)
        {
            double product = 0.0, one = 0.0, other = 0.0;
            for (int y = Math.Max(0, -up); y < Math.Min(Side, Side - up); y++)
            {
                for (int x = Math.Max(0, -right); x < Math.Min(Side, Side - right); x++)
                {
                    double a = first[y * Side + x], b = second[(y + up) * Side + x + right];
                    product += a * b;
                    one += a * a;
                    other += b * b;
                }
            }
            return product / Math.Sqrt(one * other);
        }
    }
}
