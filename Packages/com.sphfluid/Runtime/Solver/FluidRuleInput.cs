using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What the rules derive a solver's constants from. Start from <see cref="Water"/>.</summary>
    public struct FluidRuleInput
    {
        /// <summary>Most that <see cref="Substeps"/> may be.</summary>
        public const int MostSubsteps = 32;

        /// <summary>The method that the constants are for.</summary>
        public FluidMethodKind Method;

        /// <summary>Size of the domain box [m].</summary>
        public Vector3 DomainSize;

        /// <summary>Particle spacing dx [m].</summary>
        public float Spacing;

        /// <summary>Gravity [m/s²], along the axes of the domain box.</summary>
        public Vector3 Gravity;

        /// <summary>Height H of the highest liquid over the lowest point of the domain, against gravity [m].</summary>
        public float LiquidHeight;

        /// <summary>Depth of the liquid at rest [m]; at most <see cref="LiquidHeight"/>.</summary>
        public float LiquidDepth;

        /// <summary>Largest initial speed [m/s].</summary>
        public float InitialSpeed;

        /// <summary>
        /// √(2 a L) of what presses the liquid besides gravity, a vessel of the length L that is accelerated by a [m/s]; not with the
        /// thesis method.
        /// </summary>
        public float LoadSpeed;

        /// <summary>Rest density ρ0 [kg/m³].</summary>
        public float RestDensity;

        /// <summary>Kinematic viscosity of the real liquid [m²/s].</summary>
        public float KinematicViscosity;

        /// <summary>
        /// Surface tension σ [N/m]; 0: none. Acts with the method Standard, where the spacing is at most the capillary length √(σ/(ρ g)),
        /// with the Earth's gravity or a stronger one of the liquid, or where <see cref="TensionAtAnySpacing"/> asks for it.
        /// </summary>
        public float SurfaceTension;

        /// <summary>Whether <see cref="SurfaceTension"/> acts however coarse the particles are.</summary>
        public bool TensionAtAnySpacing;

        /// <summary>Contact angle of the liquid at walls [degrees], 0 to 180; with <see cref="SurfaceTension"/>.</summary>
        public float ContactAngle;

        /// <summary>Whether the pressure's gradient is corrected for uneven arrangements of particles; method Standard.</summary>
        public bool GradientCorrection;

        /// <summary>κ = R/dx.</summary>
        public float SupportRatio;

        /// <summary>Effective speed of sound over the fastest speed; 5 allows 4 % compression.</summary>
        public float SoundSpeedRatio;

        /// <summary>Compression allowed at the bottom of the liquid at rest, gH/c².</summary>
        public float MaxCompression;

        /// <summary>
        /// Speed of sound over the speed of a fall by the liquid's depth: <see cref="SoundSpeedRatio"/>, or 1/√(2 η) of
        /// <see cref="MaxCompression"/> η where that asks for more.
        /// </summary>
        internal readonly double Stiffness => Math.Max(SoundSpeedRatio, 1.0 / Math.Sqrt(2.0 * MaxCompression));

        /// <summary>α: the thesis method's least kinematic viscosity over c R; Standard needs a tenth of it.</summary>
        public float ViscosityRatio;

        /// <summary>Time step over the method's acoustic limit, <see cref="TimeStepAdvice"/>.</summary>
        public float TimeStepFraction;

        /// <summary>Length of the steps [s] where it is not to follow from the rules; 0: by rule.</summary>
        public float FixedTimeStep;

        /// <summary>Equal steps that a frame is cut into; Robust method.</summary>
        public int Substeps;

        /// <summary>Distance at which a wall begins to push, over dx; thesis method.</summary>
        public float WallDistanceRatio;

        /// <summary>Wall stiffness over (v_max/distance)², which stops v_max within the distance; thesis method.</summary>
        public float WallStiffnessRatio;

        /// <summary>Wall damping over critical damping; 1 does not rebound; thesis method.</summary>
        public float WallDampingRatio;

        /// <summary>What of the thesis's text is corrected; thesis method.</summary>
        public ThesisSwitches Switches;

        /// <summary>Least speed the constants are made for [m/s], for liquid at rest without gravity.</summary>
        public float MinSpeed;

        /// <summary>Water by the Standard method with the ratios that the package ships; sizes and heights are to be set.</summary>
        public static FluidRuleInput Water => new FluidRuleInput
        {
            Method = FluidMethodKind.Standard,
            Gravity = new Vector3(0f, -9.81f, 0f),
            RestDensity = 1000f,
            KinematicViscosity = 1e-6f,
            ContactAngle = 90f,
            SupportRatio = 2.25f,
            SoundSpeedRatio = 5f,
            MaxCompression = 0.04f,
            ViscosityRatio = 0.01f,
            TimeStepFraction = 0.75f,
            Substeps = 4,
            WallDistanceRatio = 0.5f,
            WallStiffnessRatio = 1f,
            WallDampingRatio = 1f,
            Switches = ThesisSwitches.Corrected,
            MinSpeed = 0.1f,
        };

        /// <summary>Water by the thesis method: κ = 2 and 0.6 of the step at rest, else as <see cref="Water"/>.</summary>
        public static FluidRuleInput ThesisWater
        {
            get
            {
                FluidRuleInput water = Water;
                water.Method = FluidMethodKind.Thesis;
                water.SupportRatio = 2f;
                water.TimeStepFraction = 0.6f;
                return water;
            }
        }

        /// <summary>Checks that rules can go by every number.</summary>
        /// <exception cref="System.ArgumentException">One is out of range; the message names it.</exception>
        internal readonly void Validate()
        {
            Require.Size(DomainSize, nameof(DomainSize));
            Require.Positive(Spacing, nameof(Spacing));
            Require.Positive(SupportRatio, nameof(SupportRatio));
            Require.Positive(RestDensity, nameof(RestDensity));
            Require.Positive(SoundSpeedRatio, nameof(SoundSpeedRatio));
            Require.Positive(MaxCompression, nameof(MaxCompression));
            Require.Positive(TimeStepFraction, nameof(TimeStepFraction));
            Require.Positive(WallDistanceRatio, nameof(WallDistanceRatio));
            Require.Positive(MinSpeed, nameof(MinSpeed));
            Require.NotNegative(Gravity.magnitude, nameof(Gravity));
            Require.NotNegative(LiquidHeight, nameof(LiquidHeight));
            Require.NotNegative(LiquidDepth, nameof(LiquidDepth));
            Require.NotNegative(InitialSpeed, nameof(InitialSpeed));
            Require.NotNegative(LoadSpeed, nameof(LoadSpeed));
            Require.NotNegative(KinematicViscosity, nameof(KinematicViscosity));
            Require.NotNegative(ViscosityRatio, nameof(ViscosityRatio));
            Require.NotNegative(WallStiffnessRatio, nameof(WallStiffnessRatio));
            Require.NotNegative(WallDampingRatio, nameof(WallDampingRatio));
            Require.NotNegative(FixedTimeStep, nameof(FixedTimeStep));
            Require.NotNegative(SurfaceTension, nameof(SurfaceTension));
            Require.Within(ContactAngle, 0.0, 180.0, nameof(ContactAngle));
            Require.Within(Substeps, 1.0, MostSubsteps, nameof(Substeps));
            Switches.Validate();
        }
    }
}
