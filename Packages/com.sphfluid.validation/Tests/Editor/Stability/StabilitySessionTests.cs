using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>The order of the work, with runs that are made up; and two real ones.</summary>
    public sealed class StabilitySessionTests
    {
        private readonly List<string> said = new List<string>();
        private string folder;
        private int runs;

        [SetUp]
        public void SetUp()
        {
            said.Clear();
            runs = 0;
            folder = TestFolder.Fresh();
        }

        [TearDown]
        public void TearDown() => TestFolder.Delete(folder);

        // The borders between clamps are in the long plan alone.
        [TestCase("--map M5 M3 --method thesis standard --quick", "stability-m5.gp", "stability-m3.gp")]
        [TestCase("--map M4 --method thesis", "stability-m4.gp", "stability-m4-clamps.gp")]
        public void WritesEveryRunAndAScriptAMap(string line, params string[] files)
        {
            string[] words = line.Split(' ');
            StabilityPlan plan = Plan(words);
            Finish(plan, words);

            Assert.That(Lines("stability.csv"), Has.Length.EqualTo(1 + plan.Runs.Count + plan.Clamped.Count));
            foreach (string file in files) Assert.That(Lines(file), Has.Some.Contain("boxxyerror"), file);
            Assert.That(said.Last(), Does.StartWith($"All {plan.Runs.Count + plan.Clamped.Count} runs and borders are done"));
        }

        [Test]
        public void GoesOnWhereItWasStopped()
        {
            string[] words = { "--map", "M5", "--quick" };
            StabilityPlan plan = Plan(words);
            using (StabilitySession session = Create(plan, words))
            {
                for (int i = 0; i < 5; i++) session.Step();
            }
            Assert.That(runs, Is.GreaterThan(2).And.LessThan(plan.Runs.Count));
            Assert.That(said.Last(), Does.StartWith("Stopped early."));

            Finish(plan, words);

            Assert.That(runs, Is.EqualTo(plan.Runs.Count + 1), "none but the stopped one twice");
        }

        [Test]
        public void BisectsTheBordersOfTheWhole()
        {
            StabilityPlan plan = Plan("--quick", "--method", "thesis");
            Finish(plan, "--quick", "--method", "thesis");

            Assert.That(plan.Limits, Is.Not.Empty);
            Assert.That(Lines("limits.csv"), Has.Length.EqualTo(1 + plan.Limits.Count));
            StabilityPlan all = Plan("--quick");
            Assert.That(all.Runs.Concat(all.Clamped).Select(r => r.Build().Setup).Sum(s => Math.Ceiling(s.Duration / s.Settings.TimeStep)),
                Is.LessThan(300000.0),
                "steps of the short plan");
        }

        [Test]
        public void HasSceneOfEveryCornerForEveryMethod()
        {
            foreach (StabilityMap map in StabilityMap.All)
                foreach (CaseMethod method in CaseMethod.All)
                    foreach (bool clamps in new[] { false, true })
                        foreach (double x in new[] { map.X.Low, map.X.High })
                            foreach (double y in new[] { map.Y.Low, map.Y.High })
                            {
                                StabilityScenario scene = new StabilityRun
                                {
                                    Map = map, Method = method, X = x, Y = y, Seed = 1,
                                    Clamps = clamps, MostSteps = 500
                                }.Build();
                                scene.Setup.Settings.Validate();
                                bool isThesis = CaseMethod.IsThesis(scene.Setup.Settings);
                                if (isThesis)
                                {
                                    Assert.That(scene.Setup.Settings.Own<ThesisSettings>().AccelerationLimitEnabled, Is.EqualTo(clamps));
                                }
                                Assert.That(isThesis,
                                    Is.EqualTo(method.Kind == FluidMethodKind.Thesis || method.Kind == FluidMethodKind.ThesisPrinted));
                                if (!isThesis) Assert.That(scene.Setup.Settings.Method, Is.EqualTo(method.Kind));
                                Assert.That(scene.Setup.Duration / scene.Setup.Settings.TimeStep, Is.LessThan(500.5));
                                double sound = isThesis
                                    ? LiquidEnergy.EffectiveSound(scene.Setup.Settings) / StabilityTheory.Of(method).WaveSpeedRatio
                                    : scene.Setup.Settings.SoundSpeed, step = scene.Setup.Settings.TimeStep;
                                if (map.Name == "M1")
                                {
                                    Assert.That(step * sound / scene.Setup.Settings.SupportRadius,
                                        Is.EqualTo(x).Within(1e-4 * x), "dt·c/R");
                                }
                                if (map.Name == "M3" || map.Name == "M6")
                                {
                                    Assert.That(step * 1.0 / scene.Setup.Settings.Spacing, Is.EqualTo(x).Within(1e-4 * x), "dt·v/dx");
                                }
                            }
        }

        [Test]
        public void MapsAreDrawnAtTheSupportThatCasesHave()
        {
            foreach (CaseMethod method in CaseMethod.All)
            {
                Assert.That(StabilityTheory.Of(method).SupportRatio, Is.EqualTo(method.SupportRatio), method.Name);
            }
        }

        [Test]
        public void TheStandardMethodHasNoMapsWithTheThesissLimit()
        {
            StabilityPlan plan = Plan("--quick", "--method", "standard");

            Assert.That(plan.Runs, Is.Not.Empty);
            Assert.That(plan.Clamped, Is.Empty);
            Assert.That(plan.Limits.Select(l => l.Limit.Name).Distinct(), Is.EqualTo(new[] { "dt·c/R", "ν·dt/R²" }),
                "its walls are no springs");
        }

        // On both sides of the viscous borders, 0.125 and 0.0756.
        [TestCase("thesis", 0.08, StabilityVerdict.Stable)]
        [TestCase("thesis", 0.2, StabilityVerdict.Failed)]
        [TestCase("standard", 0.07, StabilityVerdict.Stable)]
        [TestCase("standard", 0.1, StabilityVerdict.Failed)]
        public void ClassifiesARealBox(string method, double viscosity, StabilityVerdict verdict)
        {
            GpuTest.Require();
            var run = new StabilityRun
            {
                Map = StabilityMap.All[1], Method = CaseMethod.Find(method), X = viscosity, Y = 0.3, Seed = 1,
                MostSteps = 150
            };
            StabilityScenario scene = run.Build();
            var criterion = new StabilityCriterion(scene);
            FluidShaderSet shaders = TestShaders.CreateSet();
            try
            {
                using (var real = new CaseRun(scene.Setup, criterion, shaders))
                {
                    StabilityOutcome outcome = criterion.Conclude(real.RunToEnd());

                    Assert.That(outcome.Verdict, Is.EqualTo(verdict), outcome.Reason);
                    Assert.That(double.IsNaN(outcome.TimeToFailure), Is.EqualTo(verdict == StabilityVerdict.Stable));
                }
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(shaders);
            }
        }

        private static StabilityPlan Plan(params string[] words) => StabilityPlan.Of(StabilityArguments.Parse(With(words, "unused")), true);

        private static string[] With(string[] words, string folder) =>
            new[] { "player", "--" }.Concat(words).Concat(new[] { "--out", folder }).ToArray();

        private StabilitySession Create(StabilityPlan plan, params string[] words) =>
            new StabilitySession(StabilityArguments.Parse(With(words, folder)), plan, MadeUp, new SessionProgress(said.Add, null),
                "a device");

        private void Finish(StabilityPlan plan, params string[] words)
        {
            using (StabilitySession session = Create(plan, words))
            {
                while (session.Step())
                {
                }
            }
        }

        private IEnumerator MadeUp(CaseSetup setup, CaseMetric metric, Action<CaseResult> done)
        {
            runs++;
            yield return null;
            done(new CaseResult
            {
                Particles = setup.Particles.Length, Steps = 3,
                Failure = setup.Settings.TimeStep > 0.05f ? "made up" : null
            });
        }

        private string[] Lines(string file) => File.ReadAllLines(Path.Combine(folder, file));
    }
}
