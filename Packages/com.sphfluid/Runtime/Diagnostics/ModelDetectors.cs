using System;
using UnityEngine;
using static System.FormattableString;

namespace SphFluid
{
    /// <summary>Detectors of what the method's equations do wrong with the constants that it was given.</summary>
    internal static class ModelDetectors
    {
        // α of ThesisRules: the least viscosity over c R that keeps a method with two kernels calm.
        private const double CalmViscosity = 0.01;
        private const double Rounding = 1e-3;
        private const double BoilingLimit = 0.05;

        // A splash reaches 0.65 for a moment; liquid that boils is at 1 and stays there.
        private const double BoilingDisorder = 0.75;
        private const double DeficientDensity = 0.9;
        private const double DepthLimit = 0.1;

        public static FluidFinding? TooLittleViscosity(FluidEvidence e)
        {
            double needed = CalmViscosity * e.Settings.SoundSpeed * e.Settings.SupportRadius;
            if (!e.Has(FluidMethodFeatures.TwoKernels) || e.KinematicViscosity >= needed * (1.0 - Rounding)) return null;
            return new FluidFinding(FluidFailure.KernelMismatch, e.KinematicViscosity, needed,
                Invariant($"The kinematic viscosity of {e.KinematicViscosity:G3} m²/s is less than the {needed:G3} m²/s that take out ") +
                "what different kernels for density and force feed in: liquid at rest will boil.",
                "Raise the profile's Viscosity Ratio to 0.01 or more.");
        }

        // Noise is what neighbours do not share: a wave has velocity, but its particles move alike.
        public static FluidFinding? Boiling(FluidEvidence e)
        {
            if (!e.Has(FluidMethodFeatures.TwoKernels) || e.Now.Step == 0 || e.TimeStep > e.Advice.Acoustic ||
                !(e.Now.Checkerboard > BoilingDisorder))
            {
                return null;
            }
            double noise = Math.Sqrt(e.Now.Checkerboard) * e.Now.RmsSpeed(e.Settings.ParticleMass);
            double limit = BoilingLimit * e.WaveSpeed;
            if (!(noise > limit)) return null;
            return new FluidFinding(FluidFailure.KernelMismatch, noise, limit,
                Invariant($"The liquid boils: its particles move at {noise:G3} m/s (root mean square) against their neighbours, which ") +
                "different kernels for density and force feed.",
                "Raise the profile's Viscosity Ratio, or lower its Support Ratio to 2.");
        }

        public static FluidFinding? NumericalViscosity(FluidEvidence e)
        {
            if (!(e.KinematicViscosity > e.RealViscosity * (1.0 + Rounding))) return null;
            return new FluidFinding(FluidFailure.NumericalViscosity, e.KinematicViscosity, e.RealViscosity,
                Invariant($"The kinematic viscosity that acts, {e.KinematicViscosity:G3} m²/s, is the method's; the liquid's own is ") +
                Invariant($"{e.RealViscosity:G3} m²/s."),
                "Use a smaller Particle Spacing, or lower the profile's Sound Speed Ratio or, for a noisier liquid, its Viscosity Ratio.");
        }

        public static FluidFinding? SelfTermMissing(FluidEvidence e)
        {
            if (e.OmitsOwnDensity)
            {
                double self = MullerKernels.Poly6Factor(e.Settings.SupportRadius) * Math.Pow(e.Settings.SupportRadius, 6.0) *
                    e.Settings.ParticleMass / e.Settings.RestDensity;
                return new FluidFinding(FluidFailure.SelfTermMissing, 1.0 - self, 1.0,
                    Invariant($"A particle does not count itself: the lattice at rest has {1.0 - self:0.00} of the rest density, and ") +
                    "the liquid contracts.",
                    "Set Thesis Switches > Self Density in the profile; the Method Thesis instead of Thesis Printed.");
            }
            double bulk = e.Now.MaxDensityRatio;
            if (!e.HasStatistics || e.Now.Step != 0 || !(bulk < DeficientDensity) ||
                e.Now.MaxNeighbours < LatticeNeighbours(e.SupportRatio))
            {
                return null;
            }
            return new FluidFinding(FluidFailure.SelfTermMissing, bulk, DeficientDensity,
                Invariant($"The liquid starts at {bulk:0.00} of the rest density inside: particles do not count themselves, or their ") +
                "mass is too small for their spacing.",
                "Derive the particle mass by rule: FluidRules.Derive.");
        }

        public static FluidFinding? DensityDeficiency(FluidEvidence e)
        {
            if (e.Settings.PressureClamp || e.OmitsOwnDensity || !(e.Now.MinDensityRatio < DeficientDensity)) return null;
            return new FluidFinding(FluidFailure.DensityDeficiency, e.Now.MinDensityRatio, DeficientDensity,
                Invariant($"Particles at surfaces or walls find {e.Now.MinDensityRatio:0.00} of the rest density, and suction acts on ") +
                "them.",
                "Set Thesis Switches > Pressure Clamp in the profile.");
        }

        public static FluidFinding? DeepTankLoss(FluidEvidence e)
        {
            float gravity = e.Settings.Gravity.magnitude;
            if (!(gravity > 0f) || e.IsDriven) return null;
            double sound = FluidMethods.Get(e.Settings.Method).EffectiveSoundSpeed(e.Settings, e.TimeStep, e.Now.MaxSpeed);
            double expected = gravity * Depth(e) / (sound * sound);
            double compression = Math.Max(expected, 2.0 * e.Now.MeanCompression);
            if (!(compression > DepthLimit)) return null;
            double height = Math.Log(1.0 + compression) / compression;
            return new FluidFinding(FluidFailure.DeepTankLoss, compression, DepthLimit,
                Invariant($"The liquid's own weight compresses it by {100.0 * compression:0} % at the bottom: it stands at ") +
                Invariant($"{100.0 * height:0} % of its height."),
                e.Has(FluidMethodFeatures.StepsByFrame) ? "Raise the profile's Substeps, or use a larger Particle Spacing."
                    : "Lower the profile's Max Compression, or raise its Sound Speed Ratio.");
        }

        // Liquid volume over the domain's cross-section across gravity; more where colliders fill a part of it.
        private static double Depth(FluidEvidence e)
        {
            Vector3 size = e.Settings.DomainSize, up = e.Settings.Gravity.normalized;
            double height = Mathf.Abs(up.x) * size.x + Mathf.Abs(up.y) * size.y + Mathf.Abs(up.z) * size.z;
            double liquid = e.Now.ParticleCount * Math.Pow(e.Settings.Spacing, 3.0);
            return liquid / ((double)size.x * size.y * size.z) * height;
        }

        // Others within R on the cubic lattice: 26 for κ = 2.
        private static int LatticeNeighbours(double ratio)
        {
            int reach = (int)Math.Floor(ratio), count = -1;
            for (int z = -reach; z <= reach; z++)
                for (int y = -reach; y <= reach; y++)
                    for (int x = -reach; x <= reach; x++) count += x * x + y * y + z * z < ratio * ratio ? 1 : 0;
            return count;
        }
    }
}
