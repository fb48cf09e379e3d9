using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A small liquid with one failure of the thesis method, and the same liquid cured. Documentation~/failure-modes.md.</summary>
    public sealed class FailureExperiment
    {
        private readonly Func<FailureResult, double> measure;

        /// <summary>An experiment.</summary>
        /// <param name="name">Name, for instance "self-term".</param>
        /// <param name="failure">The failure that it shows.</param>
        /// <param name="failing">The run that fails.</param>
        /// <param name="cured">The run that does not.</param>
        /// <param name="figure">What is measured, with its unit.</param>
        /// <param name="measure">Measures it.</param>
        public FailureExperiment(string name, FluidFailure failure, FailureRun failing, FailureRun cured, string figure,
            Func<FailureResult, double> measure)
        {
            Name = name;
            Failure = failure;
            Failing = failing;
            Cured = cured;
            Figure = figure;
            this.measure = measure;
        }

        /// <summary>Name, for instance "self-term".</summary>
        public string Name { get; }

        /// <summary>The failure that the failing run shows and its detector names.</summary>
        public FluidFailure Failure { get; }

        /// <summary>The run that fails.</summary>
        public FailureRun Failing { get; }

        /// <summary>The run that does not.</summary>
        public FailureRun Cured { get; }

        /// <summary>What is measured, with its unit.</summary>
        public string Figure { get; }

        /// <summary>The failure cannot happen by construction: the failing run is the stress, which is survived and counted.</summary>
        public bool Survived { get; internal set; }

        /// <summary>Runs one side and waits for it.</summary>
        /// <param name="cured">The cured side, else the failing one.</param>
        /// <param name="shaders">The compute shaders.</param>
        /// <param name="audit">NeighbourAudit.compute; null: neighbours are not audited.</param>
        /// <returns>What became of it.</returns>
        public FailureResult Run(bool cured, FluidShaderSet shaders, ComputeShader audit = null)
        {
            using (var runner = new FailureRunner(cured ? Cured : Failing, shaders, audit))
            {
                FailureResult result = runner.Run();
                result.Figure = measure(result);
                return result;
            }
        }
    }
}
