using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// A measurement of many jobs with its results in a folder. Jobs that the folder holds are not done again: an interrupted session goes
    /// on by the same command. When its slice of time is up it ends between two jobs, and draws what there is.
    /// </summary>
    public abstract class JobSession : IValidationSession
    {
        // A job that takes longer than expected is never quite done.
        const double MostOfAJob = 0.95;

        readonly string folder, noun;
        readonly TimeSpan? slice;
        readonly SessionRate rate;
        readonly SessionWork work;
        readonly Stopwatch jobClock = new Stopwatch();
        SessionJob current;
        ResultFolder results;
        double left, all;
        bool disposed;

        /// <param name="folder">Folder of the results.</param>
        /// <param name="noun">What the jobs are, for instance "runs".</param>
        /// <param name="slice">Time after which it ends; null for all in one go.</param>
        /// <param name="rate">How fast jobs go.</param>
        /// <param name="progress">Where it says how far it is.</param>
        internal JobSession(string folder, string noun, TimeSpan? slice, SessionRate rate, SessionProgress progress)
        {
            this.folder = folder;
            this.noun = noun;
            this.slice = slice;
            this.rate = rate;
            Progress = progress;
            work = new SessionWork(Run());
        }

        /// <inheritdoc/>
        public bool Step()
        {
            bool more = work.Step();
            if (more && current != null)
                ShowProgress();
            return more;
        }

        /// <summary>Says how to go on when it is not done; the files are whole at any time.</summary>
        public void Dispose()
        {
            if (disposed)
                return;
            disposed = true;
            if (!work.IsDone)
                Progress.Say($"Stopped early. '{folder}' holds every finished run; the same command goes on from there.");
            work.Clear();
            results?.Close();
        }

        /// <summary>Claims the files that the session may write; called by its constructor when it has read what is there.</summary>
        /// <exception cref="CommandLineException">The folder cannot be written, or holds other files of these names.</exception>
        private protected void Claim(IEnumerable<ResultFile> files) => results = ResultFolder.Open(folder, files);

        private protected SessionProgress Progress { get; }

        /// <summary>Jobs of the whole measurement, and those that are done.</summary>
        private protected int Count { get; private set; }

        private protected int Done { get; private set; }

        /// <summary>The jobs in their order.</summary>
        private protected abstract IEnumerable<SessionJob> Jobs();

        /// <summary>The graphics device.</summary>
        private protected abstract string Device { get; }

        /// <summary>Writes what follows from the results.</summary>
        private protected abstract void Draw();

        /// <summary>Time left, for instance ", about 2:05 left"; empty while it is not known.</summary>
        private protected string TimeLeft(string before)
        {
            TimeSpan? time = rate.TimeFor(left);
            return time.HasValue && left > 0.0 ? before + SessionProgress.Duration(time.Value) + " left" : "";
        }

        // Within a job by the time that has gone by of the time that it is expected to take; nothing is known of the first one's.
        void ShowProgress()
        {
            TimeSpan? expected = rate.TimeFor(current.Cost);
            double part = expected.HasValue && expected.Value > TimeSpan.Zero
                ? current.Cost * Math.Min(MostOfAJob, jobClock.Elapsed.TotalSeconds / expected.Value.TotalSeconds) : 0.0;
            Progress.Show(1.0 - (left - part) / all, rate.TimeFor(left - part), current.Name);
        }

        IEnumerator Run()
        {
            List<SessionJob> jobs = Jobs().ToList();
            List<SessionJob> pending = jobs.Where(j => !j.IsDone()).ToList();
            all = jobs.Sum(j => j.Cost);
            left = pending.Sum(j => j.Cost);
            (Count, Done) = (jobs.Count, jobs.Count - pending.Count);
            Progress.Say($"{Count} {noun} on {Device}{(Done > 0 ? $", {Done} of them are there already" : "")}{TimeLeft(", about ")}.");
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
    }
}
