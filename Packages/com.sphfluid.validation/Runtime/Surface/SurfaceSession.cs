using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Measures every variant on every state; the table is written after each.</summary>
    public sealed class SurfaceSession : IValidationSession
    {
        readonly SurfaceArguments arguments;
        readonly FluidShaderSet shaders;
        readonly SessionProgress progress;
        readonly SurfaceQualityTable table;
        readonly SessionWork work;
        readonly ResultFolder results;

        /// <summary>Prepares a session; nothing is measured yet.</summary>
        /// <param name="arguments">What to measure.</param>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="FluidDeviceException">There are no shaders.</exception>
        /// <exception cref="CommandLineException">The output folder cannot be written, or holds another file of the table's name.</exception>
        public SurfaceSession(SurfaceArguments arguments, FluidShaderSet shaders, SessionProgress progress)
        {
            this.arguments = arguments;
            this.shaders = SessionAssets.Require(shaders, "The surfaces have");
            this.progress = progress;
            results = ResultFolder.Open(arguments.OutputFolder, new[] { ResultFile.Table(SurfaceQualityTable.FileName, SurfaceQualityTable.Columns) });
            table = new SurfaceQualityTable(arguments.OutputFolder, SystemInfo.graphicsDeviceName);
            work = new SessionWork(Run());
        }

        /// <inheritdoc/>
        public bool Step() => work.Step();

        /// <summary>Frees the GPU memory; the table holds every finished measurement.</summary>
        public void Dispose()
        {
            work.Clear();
            results.Close();
        }

        IEnumerator Run()
        {
            var scale = new SurfaceScale(arguments.Quick);
            List<(string Name, SurfaceVariant Variant)> variants = arguments.Variants.Select(v => (v.Name, v.Create(shaders))).ToList();
            try
            {
                foreach (SurfaceStates states in arguments.States)
                {
                    SurfaceState state = states.Build(scale);
                    if (state.Prepare != null)
                        yield return state.Prepare(shaders);
                    foreach ((string name, SurfaceVariant variant) in variants.Where(v => v.Variant.Takes(state)))
                    {
                        using (var run = new SurfaceRun(state, variant, shaders))
                        {
                            yield return run.Run();
                            table.Add(state.Name, name, run.Result);
                            progress.Say(SurfaceQualityTable.Line(state.Name, name, run.Result));
                        }
                    }
                }
            }
            finally
            {
                foreach ((string _, SurfaceVariant variant) in variants)
                    variant.Dispose();
            }
        }
    }
}
