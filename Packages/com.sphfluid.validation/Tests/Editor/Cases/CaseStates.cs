using System.Collections.Generic;
using System.Linq;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A small liquid and a metric that keeps what it sees, for the runs of cases.</summary>
    internal static class CaseStates
    {
        public static CaseMethod Thesis => CaseMethod.Find("thesis");

        public static CaseMethod Printed => CaseMethod.Find("thesis-printed");

        /// <summary>A block of 5³ particles that falls in a box of 1 m, dx = 2 cm.</summary>
        public static CaseSetup Block(double duration, double interval)
        {
            var parameters = new CaseParameters
            {
                Method = Thesis, Resolution = 5, SupportRatio = 2.0, TimeStepFraction = 0.5,
                SoundSpeedRatio = 5.0, Seed = 3
            };
            List<Vector3> block = CaseLattice.Box(5 * Vector3Int.one, 0.02, new Vector3(-0.05f, 0.2f, -0.05f));
            CaseLattice.Jitter(block, 0.001, parameters.Seed, 0.5f * Vector3.one);
            return new CaseSetup
            {
                Settings = CaseSettings.For(parameters, Vector3.one, 0.02, 2.0, new Vector3(0f, -9.81f, 0f)),
                Particles = CaseLattice.Particles(block),
                Duration = duration,
                SampleInterval = interval,
            };
        }

        /// <summary>Corners of a closed box.</summary>
        public static Vector3[] BoxCorners(Vector3 centre, Vector3 size)
        {
            TriangleMesh box = TriangleMesh.Box(Matrix4x4.TRS(centre, Quaternion.identity, size));
            return box.Indices.Select(i => box.Vertices[i]).ToArray();
        }

        /// <summary>A state of some particles.</summary>
        public static FluidSnapshot State(IReadOnlyList<FluidParticle> particles, float density = 1000f) =>
            FluidSnapshot.FromParticles(particles.ToArray(), particles.Select(p => density).ToArray(), new float[particles.Count],
                Matrix4x4.identity);

        /// <summary>Keeps states; says that the run fails at one of them.</summary>
        public sealed class Recorder : CaseMetric
        {
            public readonly List<double> Times = new List<double>();
            public readonly List<FluidSnapshot> States = new List<FluidSnapshot>();
            public int FailAt = -1;

            public override void Sample(double time, FluidSnapshot state)
            {
                if (Times.Count == FailAt) Failure = "the cup is empty";
                Times.Add(time);
                States.Add(state);
            }

            public override IReadOnlyList<CaseError> Evaluate() => new[] { new CaseError("samples", Times.Count) };
        }
    }
}
