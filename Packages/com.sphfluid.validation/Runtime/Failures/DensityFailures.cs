using System;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Where the density is wrong: at surfaces, without the particle itself, in one place, in depth, in other liquid.</summary>
    internal static class DensityFailures
    {
        private const int Layers = 24;

        /// <summary>
        /// A bar that is periodic along z: particles in its faces and at its edges find too little, and without the clamp suction acts on
        /// them.
        /// </summary>
        public static FailureExperiment Deficiency(float ratio = 2f)
        {
            int side = 2 * Mathf.CeilToInt(ratio) + 1, length = Mathf.CeilToInt(3f * ratio);
            var counts = new Vector3Int(side, side, length);
            float dx = FailureBlocks.Spacing;
            var domain = new Vector3(2f * side * dx, 2f * side * dx, length * dx);
            var cured = new FailureRun
            {
                Settings = FailureBlocks.Settings(domain, ratio, FluidAxes.Z),
                Start = FailureBlocks.Lattice(counts, dx, -0.5f * dx * (Vector3)counts, 0.0, 0.5f * domain),
            };
            FluidSolverSettings suction = cured.Settings;
            suction.PressureClamp = false;
            return new FailureExperiment("density-deficiency", FluidFailure.DensityDeficiency, cured.With(suction), cured,
                "least pressure/ρ0c² at the start",
                r => r.States[0].Pressures.Min() / (r.Settings.RestDensity * r.Settings.SoundSpeed * (double)r.Settings.SoundSpeed));
        }

        /// <summary>ρ/ρ0 in the middle of a face of <see cref="Deficiency"/>'s bar and in its edge, at the start.</summary>
        public static void Layer(FailureResult result, out double face, out double edge)
        {
            FluidSnapshot start = result.States[0];
            int side =
                (int)Math.Round(
                    Math.Sqrt(start.Count / (double)Mathf.CeilToInt(3f * result.Settings.SupportRadius / result.Settings.Spacing)));
            edge = start.Densities[0] / (double)result.Settings.RestDensity; // ids count x first
            face = start.Densities[side / 2] / (double)result.Settings.RestDensity;
        }

        /// <summary>A lattice that fills a periodic box, m = ρ0 dx³, whose particles do not count themselves.</summary>
        public static FailureExperiment SelfTerm(float ratio = 2f)
        {
            FailureRun cured = FailureBlocks.PeriodicBox(6 * Vector3Int.one, ratio, 0.0);
            cured.Settings.ParticleMass = (float)(cured.Settings.RestDensity * Math.Pow(FailureBlocks.Spacing, 3.0));
            FluidSolverSettings without = cured.Settings.WithOwn((ref ThesisSettings own) => own.SelfDensity = false);
            return new FailureExperiment("self-term", FluidFailure.SelfTermMissing, cured.With(without), cured,
                "ρ/ρ0 of the lattice", r => r.States[0].Densities.Average() / (double)r.Settings.RestDensity);
        }

        /// <summary>One particle too many, in the very place of another; cured: a tenth of a spacing beside it.</summary>
        public static FailureExperiment Coincident()
        {
            FailureRun box = FailureBlocks.PeriodicBox(6 * Vector3Int.one, 2f, 0.0);
            box.Steps = 20;
            Vector3 place = box.Start[0].Position;
            FluidParticle[] At(Vector3 position) => FailureBlocks.Join(box.Start, new[] { new FluidParticle(position, Vector3.zero, 0) });
            return new FailureExperiment("coincident", FluidFailure.CoincidentParticles, box.From(At(place)),
                box.From(At(place + 0.1f * FailureBlocks.Spacing * new Vector3(0.36f, 0.48f, 0.8f))),
                "distance of the two after 20 steps [dx]", r =>
                {
                    Vector3[] p = r.End.LocalPositions;
                    Vector3 d = p[p.Length - 1] - p[0], box = r.Settings.DomainSize;
                    d -= new Vector3(box.x * Mathf.Round(d.x / box.x), box.y * Mathf.Round(d.y / box.y), box.z * Mathf.Round(d.z / box.z));
                    return d.magnitude / r.Settings.Spacing;
                })
            { Survived = true };
        }

        /// <summary>24 spacings of liquid that its own weight compresses: m = c²/gH = 5; cured: c² = gH/0.04.</summary>
        public static FailureExperiment DeepTank(double ratio = 5.0)
        {
            return new FailureExperiment("deep-tank", FluidFailure.DeepTankLoss, Tank(ratio), Tank(25.0),
                "height over the lattice's at the end", Height);

            FailureRun Tank(double m)
            {
                FailureRun run = FailureBlocks.Column(new Vector3Int(6, Layers, 6), 8f, m, FluidAxes.X | FluidAxes.Z);
                // Two periods of the column's slowest wave, 4H/c; the height is the mean of the second.
                run.Steps = (int)Math.Round(8.0 * Layers * FailureBlocks.Spacing / (run.Settings.SoundSpeed * run.Settings.TimeStep));
                run.Samples = 20;
                return run;
            }
        }

        /// <summary>Height of a settled column over its lattice's: h/H = m ln(1 + 1/m), p = c² (ρ − ρ0).</summary>
        public static double TheoreticalHeight(double m) => m * Math.Log(1.0 + 1.0 / m);

        /// <summary>Two blocks of which one is half in the other; cured: beside it.</summary>
        public static FailureExperiment Overlap()
        {
            float dx = FailureBlocks.Spacing;
            Vector3 domain = 20f * dx * Vector3.one;
            var counts = new Vector3Int(6, 6, 6);
            FluidParticle[] first = FailureBlocks.Lattice(counts, dx, -6f * dx * Vector3.one, 0.01 * dx, 0.5f * domain);
            FluidParticle[] At(float x) =>
                FailureBlocks.Join(first,
                    FailureBlocks.Lattice(counts, dx, dx * new Vector3(x, -5.6f, -5.5f), 0.01 * dx, 0.5f * domain, 2));
            var run = new FailureRun { Settings = FailureBlocks.Settings(domain), Steps = 10, Samples = 10 };
            return new FailureExperiment("overlapping-start", FluidFailure.OverlappingStart, run.From(At(-3.3f)), run.From(At(0f)),
                "fastest particle of the first 10 steps over c", r => r.Statistics.Max(v => v.MaxSpeed) / r.Settings.SoundSpeed);
        }

        // Highest layer over lowest, and a layer's own height.
        private static double Height(FailureResult result)
        {
            int layer = result.Run.Start.Length / Layers, first = result.States.Count / 2;
            double sum = 0.0;
            for (int s = first; s < result.States.Count; s++)
            {
                float[] heights = result.States[s].LocalPositions.Select(p => p.y).OrderBy(y => y).ToArray();
                sum += heights.Skip(heights.Length - layer).Average() - heights.Take(layer).Average() + result.Settings.Spacing;
            }
            return sum / (result.States.Count - first) / (Layers * result.Settings.Spacing);
        }
    }
}
