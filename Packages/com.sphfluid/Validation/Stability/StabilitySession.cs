using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Runs the cells of the maps, bisects the borders and draws. The tables are written after every run, and what they hold already is
    /// not done again: an interrupted session goes on by the same command.
    /// </summary>
    public sealed class StabilitySession : IValidationSession
    {
        /// <summary>Makes the work of a run, which hands over its result.</summary>
        internal delegate IEnumerator Runner(CaseSetup setup, CaseMetric metric, Action<CaseResult> done);

        // Work a second of llvmpipe on two cores, before a run has shown it.
        const double SoftwareRate = 1e6;

        readonly StabilityArguments arguments;
        readonly Runner runner;
        readonly SessionProgress progress;
        readonly StabilityFiles files;
        readonly List<Job> jobs;
        readonly ChartRate rate;
        readonly SessionWork work;
        bool disposed;
        long steps;

        /// <summary>Prepares a session; nothing is run yet.</summary>
        /// <param name="arguments">What to measure.</param>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="CommandLineException">The folder has tables that cannot be gone on with.</exception>
        /// <exception cref="FluidDeviceException">There are no shaders.</exception>
        public StabilitySession(StabilityArguments arguments, FluidShaderSet shaders, SessionProgress progress)
            : this(arguments, StabilityPlan.Of(arguments, SurfaceGridSizes.IsSoftwareDevice), RunnerOf(shaders), progress, SystemInfo.graphicsDeviceName)
        {
        }

        internal StabilitySession(StabilityArguments arguments, StabilityPlan plan, Runner runner, SessionProgress progress, string device)
        {
            this.arguments = arguments;
            this.runner = runner;
            this.progress = progress;
            files = new StabilityFiles(arguments.OutputFolder, device);
            rate = new ChartRate(SurfaceGridSizes.IsSoftwareDevice ? SoftwareRate : (double?)null);
            jobs = plan.Runs.Select(Cell).Concat(plan.Limits.Select(l => Border(l.Limit, l.Method))).Concat(plan.Clamped.Select(Cell)).ToList();
            Directory.CreateDirectory(arguments.OutputFolder);
            work = new SessionWork(Run());
        }

        /// <inheritdoc/>
        public bool Step() => work.Step();

        /// <summary>Says how to go on when it is not done; the files are whole at any time.</summary>
        public void Dispose()
        {
            if (disposed)
                return;
            disposed = true;
            if (!work.IsDone)
                progress.Say($"Stopped early. '{arguments.OutputFolder}' holds every finished run; the same command goes on from there.");
            work.Clear();
        }

        static Runner RunnerOf(FluidShaderSet shaders)
        {
            if (shaders == null)
                throw new FluidDeviceException("The stability maps have no shader set. Install the package under its name, com.sphfluid.");
            return (setup, metric, done) => RunOnGpu(setup, metric, shaders, done);
        }

        static IEnumerator RunOnGpu(CaseSetup setup, CaseMetric metric, FluidShaderSet shaders, Action<CaseResult> done)
        {
            using (var run = new CaseRun(setup, metric, shaders))
            {
                yield return run.Run();
                done(run.Result);
            }
        }

        IEnumerator Run()
        {
            List<Job> pending = jobs.Where(j => !j.IsDone()).ToList();
            var clock = Stopwatch.StartNew();
            double left = pending.Sum(j => j.Cost), all = left;
            progress.Say($"{jobs.Count} runs and borders on {files.Device}{(pending.Count < jobs.Count ? $", {jobs.Count - pending.Count} of them are there already" : "")}.");
            for (int i = 0; i < pending.Count; i++)
            {
                Job job = pending[i];
                if (i > 0 && arguments.Slice.HasValue && clock.Elapsed + (rate.TimeFor(job.Cost) ?? TimeSpan.Zero) > arguments.Slice.Value)
                {
                    Draw();
                    progress.Say($"The slice ends with {jobs.Count - pending.Count + i} of {jobs.Count} runs and borders done. The same command goes on from there.");
                    yield break;
                }
                progress.Show(1.0 - left / all, rate.TimeFor(left), job.Name);
                var jobClock = Stopwatch.StartNew();
                yield return job.Work();
                rate.Add(job.Cost, jobClock.Elapsed);
                left -= job.Cost;
            }
            Draw();
            progress.Say(string.Format(CultureInfo.InvariantCulture, "All {0} runs and borders are done; {1} steps in this session took {2}.",
                jobs.Count, steps, SessionProgress.Duration(clock.Elapsed)));
        }

        Job Cell(StabilityRun run) => new Job(run.ToString(), run.Cost, () => files.Contains(run), () => RunCell(run));

        Job Border(StabilityLimit limit, CaseMethod method)
        {
            const double trials = 10.0;
            CaseSetup setup = limit.Build(limit.TheoryLow, method);
            double cost = trials * setup.Duration / setup.Settings.TimeStep * (setup.Particles.Length + 1500.0);
            return new Job($"border {limit}, {method.Name}", cost, () => files.Contains(limit, method), () => Bisect(limit, method));
        }

        IEnumerator RunCell(StabilityRun run)
        {
            StabilityScenario scene = run.Build();
            var judge = new StabilityJudge(scene.Criteria);
            CaseResult result = null;
            yield return runner(scene.Setup, judge, r => result = r);
            steps += result.Steps;
            string cut = scene.IsCut
                ? FormattableString.Invariant($"{StabilityScenario.CutText} of {result.Steps} steps at {scene.Setup.Duration / scene.WantedDuration:P0} of {scene.WantedDuration:G3} s") : "";
            StabilityOutcome outcome = judge.Conclude(result, cut);
            files.Add(StabilityRow.Of(run, outcome, files.Device, Today));
            if (run.X.Equals(run.Map.X.High))
                progress.Say(Line(run));
        }

        IEnumerator Bisect(StabilityLimit limit, CaseMethod method)
        {
            Bisection search = limit.Search();
            while (!search.IsDone)
            {
                CaseResult result = null;
                CaseSetup setup = limit.Build(search.Next, method);
                yield return runner(setup, new GrowthMetric(limit.Growth, setup.Settings.PeriodLength), r => result = r);
                steps += result.Steps;
                search.Add(!result.Failed);
            }
            LimitRow row = LimitRow.Of(limit, method, search, files.Device, Today);
            files.Add(row);
            progress.Say(string.Format(CultureInfo.InvariantCulture, "border {0}, {1}: {2:G4} to {3:G4}, theory {4:G4} to {5:G4}{6}", limit, method.Name,
                row.MeasuredLow, row.MeasuredHigh, row.TheoryLow, row.TheoryHigh, row.IsWithin ? "" : ", OUTSIDE 5 %"));
        }

        // A finished line of a map: "M1, thesis, c/√(gH) 10: ······EEV".
        string Line(StabilityRun run)
        {
            IEnumerable<string> letters = files.Rows
                .Where(r => r.Map == run.Map.Name && r.Method == run.Method.Name && r.Clamps == run.Clamps && r.Seed == run.Seed && CsvText.Text(r.Y) == CsvText.Text(run.Y))
                .OrderBy(r => r.X).Select(r => r.Outcome.Cause == StabilityCause.None ? "·" : StabilityCauses.Letter(r.Outcome.Cause));
            return string.Format(CultureInfo.InvariantCulture, "{0}, {1}, {2} {3,5:G3}: {4}{5}", run.Map.Name, run.Method.Name, run.Map.Y.Title, run.Y,
                string.Concat(letters), run.Clamps ? "  (with clamps)" : "");
        }

        void Draw() => new StabilityDrawing(arguments.OutputFolder, files, progress).Write();

        static string Today => DateTime.UtcNow.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture);

        sealed class Job
        {
            public Job(string name, double cost, Func<bool> isDone, Func<IEnumerator> work)
            {
                Name = name;
                Cost = cost;
                IsDone = isDone;
                Work = work;
            }

            public string Name { get; }

            public double Cost { get; }

            public Func<bool> IsDone { get; }

            public Func<IEnumerator> Work { get; }
        }
    }
}
