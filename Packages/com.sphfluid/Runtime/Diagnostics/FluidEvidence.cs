using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// What the detectors look at: a liquid's constants, its statistics at the start, before and now, and the guards' counts.
    /// </summary>
    internal sealed class FluidEvidence
    {
        // Energy that a liquid may gain before it counts: a twentieth of what it had, and motion at a fiftieth of the speed of sound.
        private const double EnergyShare = 0.05;
        private const double QuietMach = 0.02;

        private FluidSolverSettings settings;
        private double lowestPotential;
        private FluidCounters countersBefore;
        private FluidCounters counters;
        private bool hasFirst;

        public FluidEvidence(in FluidSolverSettings settings, double realViscosity)
        {
            RealViscosity = realViscosity;
            SetConstants(settings);
        }

        public double RealViscosity { get; }
        public ref readonly FluidSolverSettings Settings => ref settings;
        public TimeStepAdvice Advice { get; private set; }
        public bool HasStatistics { get; private set; }
        public FluidStatistics First { get; private set; }
        public FluidStatistics Now { get; private set; }

        /// <summary>Length of the steps in use [s].</summary>
        public double TimeStep { get; private set; }

        public long NewClampHits => counters.AccelerationLimitHits - countersBefore.AccelerationLimitHits;
        public long NewDomainClamps => counters.DomainClamps - countersBefore.DomainClamps;
        public long NewNonFinite => counters.NonFinite - countersBefore.NonFinite;

        /// <summary>κ = R/dx.</summary>
        public double SupportRatio => settings.SupportRadius / (double)settings.Spacing;

        /// <summary>ν [m²/s].</summary>
        public double KinematicViscosity => settings.Viscosity / (double)settings.RestDensity;

        /// <summary>√(gH) of the fall that the constants are made for [m/s].</summary>
        public double WaveSpeed => settings.MaxSpeed / Math.Sqrt(2.0);

        /// <summary>Whether the density leaves out the particle's own share.</summary>
        public bool OmitsOwnDensity => FluidMethods.Get(settings.Method).OmitsOwnDensity(settings);

        /// <summary>Whether the liquid's method has a feature.</summary>
        public bool Has(FluidMethodFeatures feature) => FluidMethods.Has(settings.Method, feature);

        /// <summary>What makes the steps shorter, the beginning of a cure.</summary>
        public string ShorterSteps => FluidMethods.Get(settings.Method).ShorterSteps;

        /// <summary>
        /// What makes the liquid stiffer, a cure without its end; for methods whose steps follow the frame that is the number of substeps.
        /// </summary>
        public string StifferLiquid => Has(FluidMethodFeatures.StepsByFrame) ? "raise the profile's Substeps"
            : "raise Expected Speed, or the profile's Sound Speed Ratio";

        public double ClumpedShare => Share(Now.Clumped);

        /// <summary>Whether something outside gives the liquid energy: a moving wall, or gravity around a periodic axis.</summary>
        public bool IsDriven { get; private set; }

        /// <summary>Energy over that of all liquid at rest in the lowest corner of the domain [J].</summary>
        public double AvailableEnergy(in FluidStatistics statistics) => statistics.Energy - Mass(statistics) * lowestPotential;

        /// <summary>Largest energy that is no growth [J].</summary>
        public double EnergyLimit
        {
            get
            {
                double quiet = QuietMach * settings.SoundSpeed;
                return (1.0 + EnergyShare) * AvailableEnergy(First) + 0.5 * Mass(First) * quiet * quiet;
            }
        }

        public bool EnergyGrows => HasStatistics && !IsDriven && AvailableEnergy(Now) > EnergyLimit;

        public double Share(double particles) => particles / Math.Max(1, Now.ParticleCount);

        /// <summary>Takes note of the constants.</summary>
        /// <returns>Whether they changed.</returns>
        public bool SetConstants(in FluidSolverSettings now)
        {
            if (Advice.SoundSpeed > 0.0 && Same(now, settings)) return false;
            bool energyStays = now.Gravity == settings.Gravity && now.BodyForce.Equals(settings.BodyForce) &&
                now.ParticleMass == settings.ParticleMass && now.SoundSpeed <= settings.SoundSpeed &&
                now.RestDensity == settings.RestDensity;
            if (!energyStays) Rebase();
            settings = now;
            TimeStep = now.TimeStep;
            Advice = FluidRules.Advise(now, 0.0);
            IsDriven = HasMovingWall(now.Boundaries) || Vector3.Scale(now.Gravity, now.PeriodLength) != Vector3.zero;
            lowestPotential = LowestPotential(now);
            return true;
        }

        public void AddStatistics(in FluidStatistics statistics, in FluidCounters counts)
        {
            if (HasStatistics && statistics.Step > Now.Step) TimeStep = (statistics.Time - Now.Time) / (statistics.Step - Now.Step);
            else if (!HasStatistics && statistics.Step > 0) TimeStep = statistics.Time / statistics.Step;
            if (!hasFirst) First = statistics;
            hasFirst = true;
            HasStatistics = true;
            Now = statistics;
            countersBefore = counters;
            counters = counts;
        }

        public void Rebase() => hasFirst = false;

        private double Mass(in FluidStatistics statistics) =>
            settings.ParticleMass * (double)(statistics.ParticleCount - statistics.NonFinite);

        private static bool HasMovingWall(in FluidBoundaries faces) =>
            faces.LowX != Vector3.zero || faces.LowY != Vector3.zero || faces.LowZ != Vector3.zero ||
            faces.HighX != Vector3.zero || faces.HighY != Vector3.zero || faces.HighZ != Vector3.zero;

        // Per mass: gravity's in its lowest corner; a body force's that pushes away, in its farthest.
        private static double LowestPotential(in FluidSolverSettings settings)
        {
            double lowest = 0.0;
            for (int axis = 0; axis < 3; axis++)
            {
                if (settings.PeriodLength[axis] > 0f) continue;
                double half = 0.5 * settings.DomainSize[axis], far = half + Math.Abs(settings.BodyForce.Centre[axis]);
                lowest -= Math.Abs(settings.Gravity[axis]) * half;
                lowest += 0.5 * Math.Min(0.0, settings.BodyForce.RateSquared[axis]) * far * far;
            }
            return lowest;
        }

        // Field by field: ValueType.Equals would box on every measurement.
        private static bool Same(in FluidSolverSettings a, in FluidSolverSettings b) =>
            a.DomainSize == b.DomainSize && a.Spacing == b.Spacing && a.SupportRadius == b.SupportRadius &&
                a.RestDensity == b.RestDensity &&
            a.ParticleMass == b.ParticleMass && a.Viscosity == b.Viscosity && a.TimeStep == b.TimeStep && a.Gravity == b.Gravity &&
            a.MaxSpeed == b.MaxSpeed && a.PressureClamp == b.PressureClamp && a.Boundaries.Equals(b.Boundaries) &&
            a.BodyForce.Equals(b.BodyForce) && a.HasOwnOf(b);
    }
}
