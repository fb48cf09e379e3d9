using System.Collections;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Measures every variant on every state; the table is written after each.</summary>
    public sealed class SurfaceSession : JobSession
    {
        private const double StepOverhead = 1500.0;

        private readonly SurfaceArguments arguments;
        private readonly FluidShaderSet shaders;
        private readonly ResultTable<SurfaceQuality> table;
        private List<(string Name, SurfaceVariant Variant)> variants;

        /// <summary>Prepares a session; nothing is measured yet.</summary>
        /// <param name="arguments">What to measure.</param>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="FluidDeviceException">There are no shaders.</exception>
        /// <exception cref="CommandLineException">The output folder cannot be written, or holds another file of the table's
        /// name.</exception>
        public SurfaceSession(SurfaceArguments arguments, FluidShaderSet shaders, SessionProgress progress)
            : base(arguments, "surfaces", SystemInfo.graphicsDeviceName, progress, new SessionRate(null))
        {
            this.arguments = arguments;
            this.shaders = SessionAssets.Require(shaders, "The surfaces have");
            table = new ResultTable<SurfaceQuality>(SurfaceQuality.Format, Folder, SystemInfo.graphicsDeviceName);
            Claim(new[] { SurfaceQuality.Format.File });
        }

        private protected override bool Resumes => false;

        private protected override IEnumerator Run()
        {
            variants = arguments.Variants.Select(v => (v.Name, v.Create(shaders))).ToList();
            try
            {
                yield return base.Run();
            }
            finally
            {
                foreach ((string _, SurfaceVariant variant) in variants) variant.Dispose();
            }
        }

        private protected override IEnumerable<SessionJob> Jobs()
        {
            var scale = new SurfaceScale(arguments.Quick);
            foreach (SurfaceState state in arguments.States.Select(s => s.Build(scale)))
            {
                bool prepared = false;
                foreach ((string name, SurfaceVariant variant) in variants.Where(v => v.Variant.Takes(state)))
                {
                    // The first surface of a state waits for the state.
                    double wait = prepared ? 0.0 : state.Planned.Steps * CostOfStep(state.ParticleCount);
                    prepared = true;
                    yield return new SessionJob($"{state.Name}, {name}", wait + SurfaceRun.CostOf(state, variant), () => false,
                        () => Measure(state, name, variant), kind: wait > 0.0 ? "" : name,
                        key: ShardedTable.RunKey(SurfaceQuality.Format, $"{state.Name}|{name}"), group: state.Name);
                }
            }
        }

        private protected override IEnumerator Begin() => Calibrate(shaders, CostOfStep);

        // Particle-steps, and what a step costs anyway.
        private static double CostOfStep(int particles) => particles + StepOverhead;

        private IEnumerator Measure(SurfaceState state, string name, SurfaceVariant variant)
        {
            if (state.Prepare != null && state.Frames.Count == 0) yield return state.Prepare(shaders);
            using (var run = new SurfaceRun(state, variant, shaders))
            {
                yield return run.Run();
                run.Result.State = state.Name;
                run.Result.Variant = name;
                table.Add(run.Result);
                Progress.Say(run.Result.ToString());
            }
        }
    }
}
