using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class JetMetricTests
    {
        private const float Width = 0.5f, Speed = 3f, Spacing = 0.025f;
        private const double Density = 980.0;

        [Test]
        public void AJetThatIsTurnedThroughARightAngleHasNoError()
        {
            JetMetric metric = Watched(0f, 1f);

            Assert.That(metric.Evaluate()[0].Name, Is.EqualTo(new JetCase().ErrorName));
            foreach (CaseError error in metric.Evaluate()) Assert.That(error.Value, Is.Zero.Within(1e-3), error.Name);
            Assert.That(metric.Series()[1].Y, Is.All.EqualTo(1.0).Within(1e-3));
        }

        [Test]
        public void LiquidThatReboundsPushesHarderAndSlowSheetsAreFound()
        {
            JetMetric metric = Watched(0.25f, 0.9f);

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(0.25).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "force over ρ U² b − 1"), Is.EqualTo(0.25).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "speed of the sheets over U − 1"), Is.EqualTo(-0.1).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "energy lost by the sheets"), Is.EqualTo(1.0 - 0.81 - 0.0625).Within(1e-3));
            Assert.That(WallCaseStates.Named(Watched(-0.5f, 1f), "force over ρ U² b − 1"), Is.EqualTo(-0.5).Within(1e-3),
                "not all is stopped");
        }

        [Test]
        public void PressureAlongTheWallIsHeldAgainstTheStreamlines()
        {
            JetMetric right = Watched(0f, 1f), high = Watched(0f, 1f);
            for (int i = 0; i <= 60; i++)
            {
                double time = 0.1 * i * Width / Speed;
                right.Read(time, Readings(i < 30 ? 9.0 : 1.0));
                high.Read(time, Readings(1.1));
            }

            Assert.That(WallCaseStates.Named(right, "pressure along the wall, RMS over ½ρU²"), Is.Zero.Within(1e-9),
                "what was before the flow is even does not count");
            Assert.That(WallCaseStates.Named(right, "force of the wall's strips over that by momentum − 1"), Is.Zero.Within(1e-3));
            Assert.That(WallCaseStates.Named(high, "force of the wall's strips over that by momentum − 1"), Is.EqualTo(0.1).Within(1e-3));
            double own = Math.Sqrt(Enumerable.Range(0, JetWall.Strips).Average(s => JetWall.Pressure(s) * JetWall.Pressure(s)));
            Assert.That(WallCaseStates.Named(high, "pressure along the wall, RMS over ½ρU²"), Is.EqualTo(0.1 * own).Within(1e-6));
        }

        private static CaseReadings Readings(double factor) => new CaseReadings(Array.Empty<Vector3>(),
            Enumerable.Range(0, JetWall.Strips).Select(s => factor * 0.5 * Density * Speed * Speed * JetWall.Pressure(s)).ToArray());

        // A bar of particles that goes on; what has come to the wall goes off to both sides, and away from it by a part of U.
        private static JetMetric Watched(float rebound, float sheet)
        {
            var metric = new JetMetric(Width, 8.0 * Width, Speed, 3.0, 6.0, Density);
            int across = Mathf.RoundToInt(Width / Spacing), along = Mathf.RoundToInt(8f * Width / Spacing);
            for (int i = 0; i <= 60; i++)
            {
                float time = 0.1f * i * Width / Speed;
                int arrived = Mathf.RoundToInt(Speed * time / Spacing * across);
                Vector3 Turned(int n) =>
                    new Vector3(0f, (n % 2 == 0 ? 1f : -1f) * Speed * (time - n / (float)across * Spacing / Speed), 0f);
                metric.Sample(time, WallCaseStates.State(across * along,
                    n => n < arrived ? Turned(n) : new Vector3(1f, 0f, 0f),
                    n => n < arrived ? new Vector3(rebound * Speed, (n % 2 == 0 ? sheet : -sheet) * Speed, 0f)
                        : new Vector3(-Speed, 0f, 0f)));
            }
            return metric;
        }
    }
}
