using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Each detector fires on made-up statistics that show its failure, and on no others.</summary>
    public sealed class FluidDetectorsTests
    {
        private const int Sick = 25;

        private static readonly (FluidFailure Failure, string Name, Action<StatisticsSeries> Make)[] Cases =
        {
            (FluidFailure.NonFinite, "statistics", s => s.At(Sick, v => { v.NonFinite = 1; return v; })),
            (FluidFailure.NonFinite, "guard", s => s.Count(Sick, new FluidCounters { NonFinite = 3 })),
            (FluidFailure.EnergyGrowth, "pumped", s => s.At(Sick, v =>
            {
                v.PotentialEnergy += 1.06 * s.Available(s.Statistics[0]);
                return v;
            })),
            (FluidFailure.Escaped, "outside", s => s.At(Sick, v => { v.Escaped = 9; return v; })),
            (FluidFailure.Escaped, "put back", s => s.Count(Sick, new FluidCounters { DomainClamps = 9 })),
            (FluidFailure.TensileClumping, "suction", s => s.With(x => { x.PressureClamp = false; return x; })
                .From(0, v => { v.Clumped = 0; v.MinDensityRatio = 0.95; return v; }).At(Sick, v => { v.Clumped = 81; return v; })),
            (FluidFailure.Pairing, "wide kernel", s => s.With(x => { x.SupportRadius = 3f * x.Spacing; x.Viscosity *= 1.5f; return x; })
                .From(0, v => { v.Clumped = 0; return v; }).At(Sick, v => { v.Clumped = 81; return v; })),
            (FluidFailure.CoincidentParticles, "at the start", s => s.At(0, v => { v.Coincident = 2; return v; })),
            (FluidFailure.CoincidentParticles, "merged", s => s.At(Sick, v => { v.Coincident = 401; return v; })),
            (FluidFailure.KernelMismatch, "little viscosity", s => s.With(x => { x.Viscosity *= 0.99f; return x; })),
            (FluidFailure.KernelMismatch, "boils", s => s.At(Sick, v =>
            {
                v.Checkerboard = 1.0;
                v.KineticEnergy = 0.5 * s.Settings.ParticleMass * v.ParticleCount * 0.04;
                return v;
            })),
            (FluidFailure.DensityDeficiency, "suction at surfaces", s => s.With(x => { x.PressureClamp = false; return x; })
                .From(0, v => { v.Clumped = 0; return v; })),
            (FluidFailure.SelfTermMissing, "switched off", s => s.OfThesis((ref ThesisSettings own) => own.SelfDensity = false)),
            (FluidFailure.SelfTermMissing, "light lattice", s => s.At(0, v => { v.MaxDensityRatio = 0.81; return v; })),
            (FluidFailure.TimeStepTooLong, "settings", s => s.Step(1.4f)),
            (FluidFailure.TimeStepTooLong, "in use", s => s.From(0, v => { v.Time *= 1.9; v.MaxSpeed *= 0.5; return v; })),
            (FluidFailure.ViscosityTooStiff, "settings", s => s.Viscosity(0.12)),
            (FluidFailure.NumericalViscosity, "water", s => s.RealViscosity = 1e-6),
            (FluidFailure.DeepTankLoss, "mean compression", s => s.At(Sick, v => { v.MeanCompression = 0.051; return v; })),
            (FluidFailure.DeepTankLoss, "soft", s => s.With(x => x.WithSoundSpeed(0.3f * x.SoundSpeed))),
            (FluidFailure.Tunnelling, "fast", s => s.At(Sick, v =>
            {
                v.MaxSpeed = 0.41 * s.Settings.Spacing / s.Settings.TimeStep;
                return v;
            })),
            (FluidFailure.WallStacking, "touching", s => s.At(Sick, v => { v.AtWalls = 81; return v; })),
            (FluidFailure.WallStacking, "crowded", s => s.At(Sick, v => { v.WallCrowding = 2.3; return v; })),
            (FluidFailure.ClampActs, "guard", s => s.Count(Sick, new FluidCounters { AccelerationLimitHits = 1 })),
            (FluidFailure.Overflow, "neighbours", s => s.At(Sick, v => { v.MaxNeighbours = 101; return v; })),
            (FluidFailure.OverlappingStart, "compressed", s => s.At(0, v => { v.MaxDensityRatio = 1.11; return v; })),
            (FluidFailure.OverlappingStart, "bursts", s => s.Step(0.4f).At(1, v =>
            {
                v.Step = 10;
                v.Time /= 5;
                v.MaxSpeed = 2.01 * s.Settings.MaxSpeed;
                return v;
            })),
            (FluidFailure.StaleGrid, "misplaced", s => s.At(Sick, v => { v.Misplaced = 1; return v; })),
            (FluidFailure.StaleGrid, "listed twice", s => s.At(Sick, v => { v.Listed++; return v; })),
        };

        private static IEnumerable<TestCaseData> CaseData => Cases.Select((c, i) => new TestCaseData(i).SetName($"{c.Failure}: {c.Name}"));

        [TestCaseSource(nameof(CaseData))]
        public void FailureIsNamedAndNoOther(int index)
        {
            StatisticsSeries series = StatisticsSeries.Healthy();
            Cases[index].Make(series);
            List<FluidFinding> findings = series.Run().SelectMany(found => found).ToList();
            Assert.That(findings.Select(f => f.Failure).Distinct(), Is.EqualTo(new[] { Cases[index].Failure }));
            foreach (FluidFinding finding in findings)
            {
                Assert.That(finding.Text, Does.EndWith(".").And.Match("[0-9]"), "a sentence with a figure");
                Assert.That(finding.Cure, Does.EndWith("."));
                if (finding.Failure != FluidFailure.KernelMismatch && finding.Failure != FluidFailure.SelfTermMissing &&
                    finding.Failure != FluidFailure.DensityDeficiency)
                {
                    Assert.That(finding.Value, Is.GreaterThan(finding.Limit));
                }
            }
        }

        [Test]
        public void TheStandardMethodIsNotAskedForTheThesissSettings()
        {
            foreach ((FluidFailure failure, string name, Action<StatisticsSeries> make) in Cases)
            {
                StatisticsSeries series = StatisticsSeries.Healthy().OfStandard();
                make(series);
                foreach (FluidFinding finding in series.Run().SelectMany(found => found))
                {
                    Assert.That(failure, Is.Not.EqualTo(FluidFailure.Pairing).And.Not.EqualTo(FluidFailure.KernelMismatch),
                        "Wendland's kernel does not pair, and there is one");
                    bool ofSwitch = finding.Failure == FluidFailure.TensileClumping || finding.Failure == FluidFailure.SelfTermMissing ||
                        finding.Failure == FluidFailure.DensityDeficiency || finding.Failure == FluidFailure.ClampActs;
                    if (!ofSwitch)
                    {
                        Assert.That(finding.Cure,
                            Does.Not.Contain("Wall Stiffness").And.Not.Contain("Wall Distance").And.Not.Contain("Thesis"), name);
                    }
                }
            }
        }

        // Over 1.35 R/c; Wendland on the lattice has 0.9 R/c.
        [TestCase(0.55f, false)]
        [TestCase(0.75f, true)]
        public void TheStandardMethodHasItsOwnBorder(float factor, bool named)
        {
            IEnumerable<FluidFailure> found = StatisticsSeries.Healthy().OfStandard().Step(factor).Run().SelectMany(f => f)
                .Select(f => f.Failure);
            Assert.That(found.Contains(FluidFailure.TimeStepTooLong), Is.EqualTo(named));
        }

        [Test]
        public void HealthyLiquidHasNoFindings()
        {
            StatisticsSeries series = StatisticsSeries.Healthy();
            Assert.That(series.Detectors().Check(), Is.Empty);
            Assert.That(series.Run().SelectMany(found => found).Select(f => f.Text), Is.Empty);
        }

        // AsymmetricPairs is found by brute force only.
        [Test]
        public void EveryFailureHasACase()
        {
            var all = ((FluidFailure[])Enum.GetValues(typeof(FluidFailure))).Where(f => f != FluidFailure.AsymmetricPairs);
            Assert.That(Cases.Select(c => c.Failure).Distinct(), Is.EquivalentTo(all));
        }

        [Test]
        public void FindingsEndWithTheirCause()
        {
            StatisticsSeries series = StatisticsSeries.Healthy().Count(Sick, new FluidCounters { AccelerationLimitHits = 5 });
            List<IReadOnlyList<FluidFinding>> found = series.Run();
            Assert.That(found[Sick - 1], Is.Empty);
            Assert.That(found[Sick].Single().Value, Is.EqualTo(5.0));
            Assert.That(found[Sick + 1], Is.Empty, "no new hits");
        }

        [Test]
        public void EnergyThatComesNearTheBorderOfStabilityNamesTheStep()
        {
            StatisticsSeries series = StatisticsSeries.Healthy().Step(0.9f);
            series.At(Sick, v => { v.PotentialEnergy += 1.06 * series.Available(series.Statistics[0]); return v; });
            Assert.That(series.Run()[Sick].Select(f => f.Failure),
                Is.EquivalentTo(new[] { FluidFailure.EnergyGrowth, FluidFailure.TimeStepTooLong }));
        }

        [TestCase(1.04, false)]
        [TestCase(1.06, true)]
        public void EnergyMayGrowByATwentieth(double factor, bool named)
        {
            StatisticsSeries series = StatisticsSeries.Healthy();
            double first = series.Available(series.Statistics[0]);
            series.At(Sick, v => { v.PotentialEnergy += factor * first - series.Available(v); return v; });
            double quiet = 0.02 * series.Settings.SoundSpeed;
            series.At(Sick, v => { v.PotentialEnergy += 0.5 * series.Settings.ParticleMass * v.ParticleCount * quiet * quiet; return v; });
            Assert.That(series.Run()[Sick].Count, Is.EqualTo(named ? 1 : 0));
        }

        [Test]
        public void WorkFromOutsideIsNoGrowth()
        {
            StatisticsSeries Pumped()
            {
                StatisticsSeries series = StatisticsSeries.Healthy();
                double first = series.Available(series.Statistics[0]);
                return series.From(Sick, v => { v.PotentialEnergy += 1.1 * first; return v; });
            }
            Assert.That(Pumped().Run()[Sick].Select(f => f.Failure), Is.EqualTo(new[] { FluidFailure.EnergyGrowth }));

            StatisticsSeries belt = Pumped().With(x =>
            {
                x.Boundaries.NoSlip = true; x.Boundaries.LowY =
                new Vector3(1f, 0f, 0f); return x;
            });
            Assert.That(belt.Run().SelectMany(f => f), Is.Empty, "a moving wall does work");

            StatisticsSeries channel = Pumped().With(x =>
            {
                x.Boundaries.Periodic = FluidAxes.X; x.Gravity =
                new Vector3(1f, -9.81f, 0f); return x;
            });
            Assert.That(channel.Run().SelectMany(f => f).Where(f => f.Failure == FluidFailure.EnergyGrowth), Is.Empty,
                "gravity around a periodic axis does work");

            StatisticsSeries lifted = Pumped();
            FluidDetectors detectors = lifted.Detectors();
            for (int i = 0; i < lifted.Statistics.Count; i++)
            {
                if (i == Sick) detectors.Rebase();
                Assert.That(detectors.Update(lifted.Statistics[i], default), Is.Empty, "a moved collider did work");
            }
        }

        [Test]
        public void ChangedConstantsAreLookedAtAnew()
        {
            StatisticsSeries series = StatisticsSeries.Healthy();
            FluidDetectors detectors = series.Detectors();
            Assert.That(detectors.Update(series.Statistics[0], default), Is.Empty);
            detectors.Apply(series.Step(1.4f).Settings);
            Assert.That(detectors.Check().Select(f => f.Failure), Is.EqualTo(new[] { FluidFailure.TimeStepTooLong }));
            detectors.Apply(series.Step(1f / 1.4f).Settings);
            Assert.That(detectors.Check(), Is.Empty);
        }

        [Test]
        public void TextsAreTheSameInEveryLanguage()
        {
            System.Globalization.CultureInfo before = System.Globalization.CultureInfo.CurrentCulture;
            try
            {
                System.Globalization.CultureInfo.CurrentCulture =
                    new System.Globalization.CultureInfo("") { NumberFormat = { NumberDecimalSeparator = "@" } };
                foreach (var entry in Cases)
                {
                    StatisticsSeries series = StatisticsSeries.Healthy();
                    entry.Make(series);
                    Assert.That(series.Run().SelectMany(f => f).Where(f => f.Text.Contains('@') || f.Cure.Contains('@')), Is.Empty);
                }
            }
            finally
            {
                System.Globalization.CultureInfo.CurrentCulture = before;
            }
        }
    }

    /// <summary>Words of the cases.</summary>
    internal static class StatisticsSeriesWords
    {
        /// <summary>Energy over that of liquid in the lowest layer of the domain of 1 m [J].</summary>
        public static double Available(this StatisticsSeries series, FluidStatistics statistics) =>
            statistics.Energy + series.Settings.ParticleMass * (double)statistics.ParticleCount * 9.81 * 0.5;

        /// <summary>A change to the thesis method's own constants; of another method none.</summary>
        public static StatisticsSeries OfThesis(this StatisticsSeries series, MethodSettingsChange<ThesisSettings> change) =>
            series.Settings.Method == FluidMethodKind.Standard ? series : series.With(x => x.WithOwn(change));

        // √k: the thesis's stiffness is twice c², Standard's is c².
        private static float RootOfStiffness(in FluidSolverSettings settings) =>
            settings.Method == FluidMethodKind.Standard ? settings.SoundSpeed : Mathf.Sqrt(settings.Own<ThesisSettings>().Stiffness);

        /// <summary>The time step as a part of 1.35 R/√k.</summary>
        public static StatisticsSeries Step(this StatisticsSeries series, float part)
        {
            float before = series.Settings.TimeStep;
            series.Settings.TimeStep = part * 1.35f * series.Settings.SupportRadius / RootOfStiffness(series.Settings);
            double ratio = series.Settings.TimeStep / (double)before;
            return series.From(0, v => { v.Time *= ratio; v.MaxSpeed /= ratio; return v; });
        }

        /// <summary>ν dt/R².</summary>
        public static StatisticsSeries Viscosity(this StatisticsSeries series, double ratio)
        {
            FluidSolverSettings s = series.Settings;
            series.Settings.Viscosity = (float)(ratio * s.SupportRadius * s.SupportRadius / s.TimeStep * s.RestDensity);
            return series;
        }
    }
}
