using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// A measurement of many jobs. Jobs that the folder holds are not done again: an interrupted session continues by the same command.
    /// When its slice of time is up it ends between two jobs, and draws what there is.
    /// </summary>
    public abstract class JobSession : MeasuringSession
    {
        // A job that takes longer than expected is never quite done.
        private const double MostOfAJob = 0.95;

        private readonly MeasuringArguments arguments;
        private readonly string noun, device;
        private readonly TimeSpan? slice;
        private readonly SessionRate rate;
        private readonly Stopwatch jobClock = new Stopwatch(), session = new Stopwatch();
        private readonly List<SessionJob> rest = new List<SessionJob>();
        private SessionJob current;
        private ShardFolder shard; // null where all runs are done here

        /// <param name="arguments">What to measure.</param>
        /// <param name="noun">What the jobs are, for instance "runs".</param>
        /// <param name="device">The graphics device.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <param name="rate">How fast jobs go.</param>
        internal JobSession(MeasuringArguments arguments, string noun, string device, SessionProgress progress, SessionRate rate)
            : base(arguments, progress)
        {
            this.arguments = arguments;
            this.noun = noun;
            this.device = device;
            this.rate = rate;
            slice = arguments.Slice;
        }

        /// <inheritdoc/>
        public override bool Step()
        {
            bool more = base.Step();
            if (more && current != null) ShowProgress();
            return more;
        }

        /// <summary>Jobs of the whole measurement, and those that are done.</summary>
        private protected int Count { get; private set; }

        private protected int Done { get; private set; }

        /// <summary>Whether the same command continues an interrupted session; else it starts anew.</summary>
        private protected virtual bool Resumes => true;

        /// <summary>Whether it only draws what the folder has, and does no jobs.</summary>
        private protected bool OnlyDraws { get; set; }

        private protected override string Unfinished =>
            $"'{Folder}' holds every finished run{(Resumes ? "; the same command goes on from there" : "")}.";

        /// <summary>The jobs in their order.</summary>
        private protected abstract IEnumerable<SessionJob> Jobs();

        /// <summary>Writes what follows from the results.</summary>
        private protected virtual void Draw()
        {
        }

        /// <summary>Measures how fast the device is, so that the time of the whole is known before it begins.</summary>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="costOfStep">Cost, as the jobs have it, of a step of the Standard method at κ = 2 with so many particles.</param>
        private protected IEnumerator Calibrate(FluidShaderSet shaders, Func<int, double> costOfStep)
        {
            var calibration = new DeviceCalibration(shaders);
            yield return calibration.Run();
            rate.Expect(costOfStep(DeviceCalibration.Particles) / calibration.SecondsPerStep);
        }

        /// <summary>What comes before the first job that is not done; see <see cref="Calibrate"/>.</summary>
        private protected virtual IEnumerator Begin()
        {
            yield break;
        }

        /// <summary>Time left, for instance ", about 3 min left"; empty while it is not known.</summary>
        private protected string TimeLeft(string before)
        {
            TimeSpan? time = Left();
            return time.HasValue && time.Value > TimeSpan.Zero ? before + SessionProgress.About(time.Value) + " left" : "";
        }

        private protected override void Claim(IEnumerable<ResultFile> files)
        {
            List<ResultFile> all = files.ToList();
            shard = ShardFolder.Open(arguments, device, Resumes, all);
            base.Claim(shard == null ? all : all.Concat(ShardFolder.Files));
        }

        private protected override IEnumerator Run()
        {
            if (OnlyDraws)
            {
                Draw();
                yield break;
            }
            List<SessionJob> jobs = Jobs().ToList();
            if (shard != null) jobs = shard.Take(jobs);
            List<SessionJob> pending = jobs.Where(j => !j.IsDone()).ToList();
            rest.AddRange(pending);
            (Count, Done) = (jobs.Count, jobs.Count - pending.Count);
            if (pending.Count > 0) yield return Begin();
            string part = shard == null ? "" : $"Shard {shard.Shard} of the plan's {shard.PlannedRuns}: ";
            Progress.Say($"{part}{Count} {noun} on {device}{(Done > 0 ? $", {Done} of them are there already" : "")}{TimeLeft(": ")}.");
            session.Restart();
            foreach (SessionJob job in pending)
            {
                if (job != pending[0] && slice.HasValue &&
                    session.Elapsed + (rate.TimeFor(job.Cost, job.Kind) ?? TimeSpan.Zero) > slice.Value)
                {
                    break;
                }
                rest.Remove(job);
                current = job;
                jobClock.Restart();
                ShowProgress();
                yield return job.Work();
                current = null;
                shard?.Finish(job, jobClock.Elapsed);
                rate.Add(job.Cost, jobClock.Elapsed, job.Kind);
                Done++;
                job.Report?.Invoke();
            }
            // A part makes no picture: merge draws the whole.
            if (shard == null) Draw();
            Progress.Say(Done == Count
                ? $"All {Count} {noun}{(shard == null ? "" : $" of shard {shard.Shard}")} are done; this session took " +
                    $"{SessionProgress.Duration(session.Elapsed)}."
                : $"Time is up with {Done} of {Count} {noun} done{TimeLeft(", ")}. The same command goes on from there.");
        }

        private void ShowProgress()
        {
            if (current.Share != null) rate.Running(current.Cost * current.Share(), jobClock.Elapsed, current.Kind);
            TimeSpan? time = Left();
            double part = current.Share != null ? current.Share() : 0.0;
            Progress.Show(time.HasValue ? session.Elapsed.TotalSeconds / Math.Max(1e-9, (session.Elapsed + time.Value).TotalSeconds)
                : (Done + part) / Count, time, current.Name);
        }

        // Of the running job what it says of itself, else by the time that has gone by of the time that it is expected to take.
        private TimeSpan? Left()
        {
            TimeSpan sum = TimeSpan.Zero;
            foreach (SessionJob job in rest)
            {
                TimeSpan? time = rate.TimeFor(job.Cost, job.Kind);
                if (!time.HasValue) return null;
                sum += time.Value;
            }
            if (current == null) return sum;
            TimeSpan? whole = rate.TimeFor(current.Cost, current.Kind);
            if (!whole.HasValue) return null;
            double part = current.Share != null ? current.Share()
                : Math.Min(MostOfAJob, jobClock.Elapsed.TotalSeconds / Math.Max(1e-9, whole.Value.TotalSeconds));
            return sum + TimeSpan.FromSeconds((1.0 - part) * whole.Value.TotalSeconds);
        }
    }
}
