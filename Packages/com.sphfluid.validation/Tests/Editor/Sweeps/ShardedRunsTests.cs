using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Two real runs of a chart, and made-up maps: in shards and in one go they give the same.</summary>
    public sealed class ShardedRunsTests
    {
        private readonly List<string> said = new List<string>();
        private string root;

        [SetUp]
        public void SetUp() => root = TestFolder.Fresh();

        [TearDown]
        public void TearDown() => TestFolder.Delete(root);

        [Test]
        public void EveryErrorOfRealRunsIsThatOfTheWhole()
        {
            FluidShaderSet shaders = TestShaders.CreateSet();
            try
            {
                Finish(Chart(shaders, "whole"));
                Finish(Chart(shaders, "1", "--shard", "1/2"));
                Finish(Chart(shaders, "2", "--shard", "2/2"));
                Merge("1", "2");
                List<ChartRow> whole = Rows("whole"), merged = Rows("merged");

                Assert.That(whole.Select(r => r.Key).Distinct().Count(), Is.EqualTo(2));
                Assert.That(Rows("1").Select(r => r.Method).Distinct().Single(),
                    Is.Not.EqualTo(Rows("2").Select(r => r.Method).Distinct().Single()));
                Assert.That(merged.Select(r => (r.Key, r.ErrorName, r.Error, r.Failed, r.Reason, r.Steps, r.Particles)),
                    Is.EqualTo(whole.Select(r => (r.Key, r.ErrorName, r.Error, r.Failed, r.Reason, r.Steps, r.Particles))));
                Assert.That(whole.Select(r => r.Error), Has.None.NaN);
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(shaders);
            }
        }

        [Test]
        public void MapsInShardsAreTheWholeMaps()
        {
            Finish(Maps("whole"));
            Finish(Maps("1", "--shard", "1/3"));
            Finish(Maps("2", "--shard", "2/3"));
            Finish(Maps("3", "--shard", "3/3"));
            Merge("1", "2", "3");

            foreach (string file in new[] { "stability.csv", "stability-m5.gp" })
            {
                Assert.That(File.ReadAllLines(At("merged", file)), Is.EqualTo(File.ReadAllLines(At("whole", file))), file);
            }
        }

        private ChartSession Chart(FluidShaderSet shaders, string name, params string[] words)
        {
            ChartArguments arguments =
                ChartArguments.Parse(new[] { "--", "--quick", "--case", "ellipsoid", "--method", "standard", "thesis", "--out",
                    At(name, "") }.Concat(words).ToArray());
            // The cheapest run of each method is all that fits.
            ChartPlan plan = ChartPlan.Quick(arguments.Cases, arguments.Methods, 1.0);
            return new ChartSession(arguments, plan, (run, done) => Untimed(run, shaders, done), Progress, SystemInfo.graphicsDeviceName,
                new SessionRate(null));
        }

        private StabilitySession Maps(string name, params string[] words)
        {
            StabilityArguments arguments =
                StabilityArguments.Parse(new[] { "--", "--quick", "--map", "M5", "--method", "standard", "--out",
                    At(name, "") }.Concat(words).ToArray());
            return new StabilitySession(arguments, StabilityPlan.Of(arguments, true), MadeUp, Progress, "a device");
        }

        private void Merge(params string[] names) =>
            Finish(
                new MergeSession(
                    MergeArguments.Parse(new[] { "--" }.Concat(names.Select(n => At(n, ""))).Append("--out=" + At("merged", "")).ToArray()),
                    Progress));

        private SessionProgress Progress => new SessionProgress(said.Add, null);

        private string At(string name, string file) => Path.Combine(root, name, file);

        private List<ChartRow> Rows(string name) => ChartRow.Format.ReadAll(At(name, "accuracy.csv"), () => new ChartRow());

        // GPU times need frames of the engine, which a test in edit mode does not have.
        private static IEnumerator Untimed(ChartRun run, FluidShaderSet shaders, Action<CaseResult> done)
        {
            CaseParameters parameters = run.Config.Parameters(run.Seed);
            CaseSetup setup = run.Config.Case.Build(parameters);
            using (var real = new CaseRun(setup, run.Config.Case.CreateMetric(parameters, setup), shaders))
            {
                yield return real.Run();
                done(real.Result);
            }
        }

        private static IEnumerator MadeUp(CaseSetup setup, CaseMetric metric, Action<CaseResult> done)
        {
            yield return null;
            done(new CaseResult
            {
                Particles = setup.Particles.Length, Steps = 3,
                Failure = setup.Settings.TimeStep > 0.05f ? "made up" : null
            });
        }

        private static void Finish(IValidationSession session)
        {
            using (session)
            {
                while (session.Step())
                {
                }
            }
        }
    }
}
