using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>InvertMoments against means over all pairs and Jacobi's rotations in double precision.</summary>
    public sealed class InvertMomentsTests
    {
        private const float Spacing = 0.05f;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.5f, 0.35f);

        // Of the largest sum of half floats, and where a rounding of the least eigenvalue moves the weight.
        private const double Rounding = 1.2e-3;

        [Test]
        public void CorrectionsInvertTheMeansOverAllPairs([Values(1, 63, 64, 65, 257)] int count,
            [Values(FluidAxes.None, FluidAxes.All)] FluidAxes periodic, [Values] bool listed)
        {
            FluidSolverSettings settings = CorrectionReference.Corrected(StandardStateRig.Water(Domain, Spacing, periodic));
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, 0.95f * Domain, 0f, 4));
                rig.FillList(particles, listed);
                double[][] moments = Moments(count, count);
                double[][] found = Invert(rig, moments);
                for (int i = 0; i < count; i++)
                {
                    double[] mean = CorrectionReference.Mean(settings, particles, moments, i);
                    AssertClose(found[i], CorrectionReference.Correction(OverMoment(settings, mean)), i);
                }
            }
        }

        // Alone, so that a particle's mean is its own moment.
        [Test]
        public void EveryMatrixIsInverted()
        {
            const int count = 6000;
            FluidSolverSettings settings = CorrectionReference.Corrected(StandardStateRig.Water(Domain, Spacing, FluidAxes.All));
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, Domain, 0f, 4));
                rig.State.List.Counts.SetData(new uint[count]);
                double[][] moments = Moments(count, 7);
                double[][] found = Invert(rig, moments);
                for (int i = 0; i < count; i++) AssertClose(found[i], CorrectionReference.Correction(OverMoment(settings, moments[i])), i);
            }
        }

        [Test]
        public void ALoneParticleIsNotCorrectedAndItsOffsetStays()
        {
            FluidSolverSettings settings = CorrectionReference.Corrected(StandardStateRig.Water(Domain, Spacing, FluidAxes.All));
            using (var rig = new StandardStateRig(settings, 1))
            {
                rig.FillSorted(ParticleSets.Random(1, Domain, 0f, 4));
                rig.State.List.Counts.SetData(new uint[1]);
                rig.State.RequireCarried(StandardForces.All);
                var buffers = rig.State.ForceBuffers<GradientCorrectionBuffers>();
                buffers.Corrections.SetData(new[] { 9u, 9u, 9u, 7u });
                Invert(rig, new[] { new double[6] });
                Assert.That(GpuTest.Read<uint>(buffers.Corrections, 4), Is.EqualTo(new[] { 0u, 0u, 0u, 7u }));
            }
        }

        // Of every kind: any, with eigenvalues that are equal, or nearly, near the bounds of the regularisation, and multiples of the
        // identity.
        private static double[][] Moments(int count, int seed)
        {
            var random = new System.Random(seed);
            double[] near = { 0.0, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2 };
            double[] bounds = { 0.2, 0.45, 0.77, 1.0 };
            var moments = new double[count][];
            for (int i = 0; i < count; i++)
            {
                double[] x = Enumerable.Range(0, 3).Select(_ => 1.6 * random.NextDouble()).ToArray();
                double apart = near[random.Next(near.Length)];
                int kind = i % 6;
                if (kind >= 1) x[1] = x[0] + apart;
                if (kind == 2) x[2] = x[0] - apart * random.NextDouble();
                if (kind == 3) x[0] = bounds[random.Next(4)] + apart * (random.NextDouble() - 0.5);
                if (kind == 4) x = new[] { 0.77 + apart, 0.77 - apart, 0.77 + apart * random.NextDouble() };
                if (kind == 5) x[1] = x[2] = x[0];
                Quaternion turn = i % 5 == 0 ? Quaternion.identity : ParticleSets.RandomRotation(random);
                moments[i] = new double[6];
                Vector3[] axes = { turn * Vector3.right, turn * Vector3.up, turn * Vector3.forward };
                for (int k = 0; k < 3; k++) CorrectionReference.AddProduct(moments[i], x[k], axes[k]);
                for (int k = 0; k < 6; k++) moments[i][k] = (float)moments[i][k];
            }
            return moments;
        }

        private static double[][] Invert(StandardStateRig rig, IReadOnlyList<double[]> moments)
        {
            int count = moments.Count;
            rig.State.RequireCarried(StandardForces.All);
            var buffers = rig.State.ForceBuffers<GradientCorrectionBuffers>();
            buffers.Moments.SetData(moments.SelectMany(m => m.Select(x => (float)x)).ToArray());
            var pass = new InvertMomentsPass(rig.Shaders);
            GpuTest.Run(cmd => pass.Record(cmd, rig.State));
            uint[] words = GpuTest.Read<uint>(buffers.Corrections, 4 * count);
            return Enumerable.Range(0, count).Select(i => CorrectionReference.Unpack(words, 4 * i)).ToArray();
        }

        private static double[] OverMoment(in FluidSolverSettings settings, double[] moment)
        {
            double lattice = WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing);
            return moment.Select(m => m / lattice).ToArray();
        }

        private static void AssertClose(double[] found, double[] expected, int particle)
        {
            for (int k = 0; k < 6; k++) Assert.That(found[k], Is.EqualTo(expected[k]).Within(Rounding), $"{k} of {particle}");
        }
    }
}
