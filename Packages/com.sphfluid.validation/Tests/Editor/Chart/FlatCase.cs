using System;
using System.Collections.Generic;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A case that is never run: its set-up only has a size. A unit cube of Resolution³ particles for one second.</summary>
    internal sealed class FlatCase : ValidationCase
    {
        private readonly string name;
        private readonly int resolution;

        public FlatCase(string name, int resolution = 12)
        {
            this.name = name;
            this.resolution = resolution;
        }

        public override string Name => name;

        public override string Title => "A cube's rest";

        public override string Source => "made up";

        public override string ErrorName => MainError;

        public override double Floor => 0.04;

        public override string FloorSource => "two made-up rests lie so far apart";

        public override IReadOnlyList<(string Name, double Right)> AlsoHeld => Held;

        public override bool IsGate => Gate;

        public override string Caution => Warning;

        public override string CompanionErrorName => Companion;

        public override (string X, string Y) AxisTitles => ("t [s]", "h/H");

        public bool Gate { get; set; }

        /// <summary>Results are made up for "drift" too, a tenth of the height's error.</summary>
        public (string Name, double Right)[] Held { get; set; } = Array.Empty<(string, double)>();

        public string Warning { get; set; } = "";

        public string Companion { get; set; }

        /// <summary>Results are made up for "height".</summary>
        public string MainError { get; set; } = "height";

        /// <summary>κ from which the case cannot be set up.</summary>
        public double SupportLimit { get; set; } = 10.0;

        public override CaseParameters Base(CaseMethod method) => new CaseParameters
        {
            Method = method,
            Resolution = resolution,
            SupportRatio = 2.0,
            TimeStepFraction = 0.5,
            SoundSpeedRatio = 5.0,
        };

        // dt = fraction · dx / c.
        public override CaseSetup Build(in CaseParameters parameters)
        {
            if (parameters.SupportRatio >= SupportLimit) throw new ArgumentException("the cube is too small for κ");
            float spacing = 1f / parameters.Resolution;
            FluidSolverSettings settings = default;
            settings.Spacing = spacing;
            settings.TimeStep = (float)(parameters.TimeStepFraction * spacing / parameters.SoundSpeedRatio);
            return new CaseSetup
            {
                Settings = settings.WithOwn(new StandardSettings { SoundSpeed = (float)parameters.SoundSpeedRatio }),
                Particles = new FluidParticle[parameters.Resolution * parameters.Resolution * parameters.Resolution],
                Duration = 1.0,
                SampleInterval = 0.1,
            };
        }

        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) => throw new NotSupportedException();

        /// <summary>A result without a run.</summary>
        public static CaseResult Result(double gpu, double error, string failure = null, double driftOver = -0.1)
        {
            var curve = new CaseSeries("height");
            var reference = new CaseSeries("rest", true);
            for (int i = 0; i < 50; i++)
            {
                curve.Add(0.02 * i, 1.0 - error * i / 50.0);
                reference.Add(0.02 * i, 1.0);
            }
            return new CaseResult
            {
                Errors = failure != null ? Array.Empty<CaseError>()
                    : new[] { new CaseError("height", error), new CaseError("drift", driftOver * error) },
                Series = new List<CaseSeries> { curve, reference },
                Failure = failure,
                Particles = 1728,
                Steps = 120,
                SimulatedSeconds = 1.0,
                GpuMsPerSecond = gpu,
                CpuMsPerSecond = 0.5 * gpu,
            };
        }
    }
}
