using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// A measurement of many jobs. Jobs that the folder holds are not done again: an interrupted session continues by the same command. When
    /// its slice of time is up it ends between two jobs, and draws what there is.
    /// </summary>
    public abstract class JobSession : MeasuringSession
    {
        // A job that takes longer than expected is never quite done.
        const double MostOfAJob = 0.95;

        readonly string noun, device;
        readonly TimeSpan? slice;
        readonly SessionRate rate;
        readonly Stopwatch jobClock = new Stopwatch();
        SessionJob current;
        double left, all;

        /// <param name="arguments">What to measure.</param>
        /// <param name="noun">What the jobs are, for instance "runs".</param>
        /// <param name="device">The graphics device.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <param name="rate">How fast jobs go.</param>
        internal JobSession(MeasuringArguments arguments, string noun, string device, SessionProgress progress, SessionRate rate)
            : base(arguments, progress)
        {
            this.noun = noun;
            this.device = device;
            this.rate = rate;
            slice = arguments.Slice;
        }

        /// <inheritdoc/>
        public override bool Step()
        {
            bool more = base.Step();
            if (more && current != null)
                ShowProgress();
            return more;
        }

        /// <summary>Jobs of the whole measurement, and those that are done.</summary>
        private protected int Count { get; private set; }

        private protected int Done { get; private set; }

        /// <summary>Whether the same command continues an interrupted session; else it starts anew.</summary>
        private protected virtual bool Resumes => true;

        private protected override string Unfinished =>
            $"'{Folder}' holds every finished run{(Resumes ? "; the same command goes on from there" : "")}.";

        /// <summary>The jobs in their order.</summary>
        private protected abstract IEnumerable<SessionJob> Jobs();

        /// <summary>Writes what follows from the results.</summary>
        private protected virtual void Draw()
        {
        }

        /// <summary>Time left, for instance ", about 2:05 left"; empty while it is not known.</summary>
        private protected string TimeLeft(string before)
        {
            TimeSpan? time = rate.TimeFor(left);
            return time.HasValue && left > 0.0 ? before + SessionProgress.Duration(time.Value) + " left" : "";
        }

        private protected override IEnumerator Run()
        {
            List<SessionJob> jobs = Jobs().ToList();
            List<SessionJob> pending = jobs.Where(j => !j.IsDone()).ToList();
            all = jobs.Sum(j => j.Cost);
            left = pending.Sum(j => j.Cost);
            (Count, Done) = (jobs.Count, jobs.Count - pending.Count);
            Progress.Say($"{Count} {noun} on {device}{(Done > 0 ? $", {Done} of them are there already" : "")}{TimeLeft(", about ")}.");
            var clock = Stopwatch.StartNew();
            foreach (SessionJob job in pending)
            {
                if (job != pending[0] && slice.HasValue && clock.Elapsed + (rate.TimeFor(job.Cost) ?? TimeSpan.Zero) > slice.Value)
                    break;
                current = job;
                jobClock.Restart();
                ShowProgress();
                yield return job.Work();
                current = null;
                rate.Add(job.Cost, jobClock.Elapsed);
                left -= job.Cost;
                Done++;
                job.Report?.Invoke();
            }
            Draw();
            Progress.Say(Done == Count
                ? $"All {Count} {noun} are done; this session took {SessionProgress.Duration(clock.Elapsed)}."
                : $"Time is up with {Done} of {Count} {noun} done{TimeLeft(", about ")}. The same command goes on from there.");
        }

        // Within a job by the time that has gone by of the time that it is expected to take; nothing is known of the first one's.
        void ShowProgress()
        {
            TimeSpan? expected = rate.TimeFor(current.Cost);
            double part = expected.HasValue && expected.Value > TimeSpan.Zero
                ? current.Cost * Math.Min(MostOfAJob, jobClock.Elapsed.TotalSeconds / expected.Value.TotalSeconds) : 0.0;
            Progress.Show(1.0 - (left - part) / all, rate.TimeFor(left - part), current.Name);
        }
    }
}
