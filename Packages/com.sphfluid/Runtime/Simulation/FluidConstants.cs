using UnityEngine;

namespace SphFluid
{
    /// <summary>The solver's constants from a simulation's spec and where its liquid starts.</summary>
    internal static class FluidConstants
    {
        /// <summary>Constants by rule.</summary>
        /// <param name="spec">What is to start, with a profile.</param>
        /// <param name="start">Where the liquid starts.</param>
        /// <param name="startGravity">Gravity at the start in simulation space [m/s²]: a domain that turns keeps the fall height it started
        /// with.</param>
        /// <param name="speed">Speed that the liquid has or will have at the domain's lowest place [m/s]; NaN: that of the start, without
        /// colliders.</param>
        /// <param name="load">Of what presses the liquid besides gravity [m/s], <see cref="FluidRuleInput.LoadSpeed"/>.</param>
        /// <exception cref="System.ArgumentException">A constant is out of range.</exception>
        public static FluidSolverSettings Derive(in FluidSpec spec, FluidStart start, Vector3 startGravity, double speed = double.NaN,
            double load = 0.0)
        {
            FluidRuleInput input = Input(spec, start, startGravity);
            input.LoadSpeed = (float)load;
            if (!double.IsNaN(speed))
            {
                input.InitialSpeed = (float)speed;
                input.LiquidHeight = 0f;
            }
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.Boundaries = spec.Boundaries;
            settings.BodyForce = spec.BodyForce;
            return settings;
        }

        /// <summary>What the rules start from.</summary>
        /// <param name="spec">What is to start, with a profile.</param>
        /// <param name="start">Where the liquid starts.</param>
        /// <param name="startGravity">Gravity at the start in simulation space [m/s²].</param>
        public static FluidRuleInput Input(in FluidSpec spec, FluidStart start, Vector3 startGravity)
        {
            Vector3 gravity = spec.LocalGravity;
            Vector3 fall = startGravity.sqrMagnitude > 0f ? startGravity : gravity;
            float height = LiquidExtent.FallHeight(spec, start.Extent, fall);
            FluidRuleInput input = spec.Profile.Rules;
            input.Method = spec.Method;
            input.DomainSize = spec.DomainSize;
            input.Spacing = spec.Spacing;
            input.Gravity = gravity;
            input.LiquidHeight = height;
            input.LiquidDepth = Mathf.Min(height, DepthAtRest(spec, start, fall));
            input.InitialSpeed = Hypotenuse(FastestSource(spec, start.InitialSpeed), start.Extent.SpeedBy(spec.BodyForce));
            input.MinSpeed = Mathf.Max(input.MinSpeed, Mathf.Max(spec.ExpectedSpeed, FastestWall(spec.Boundaries)));
            input.FixedTimeStep = spec.TimeStepMode == FluidTimeStepMode.Fixed
                ? (float)Require.Positive(spec.FixedTimeStep, nameof(spec.FixedTimeStep)) : 0f;
            return input;
        }

        /// <summary>
        /// The cure of a liquid that is driven faster than its constants are made for; with a fixed step the stiffer liquid may need a
        /// shorter one.
        /// </summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="start">Where its liquid starts.</param>
        /// <param name="speed">Its speed then [m/s].</param>
        public static string ExpectedSpeedCure(FluidSpec spec, FluidStart start, double speed)
        {
            double digit = System.Math.Pow(10.0, System.Math.Floor(System.Math.Log10(speed)) - 1.0); // two digits: 2.61 to 2.7
            spec.ExpectedSpeed =
                (float)System.Math.Min(FluidSpec.MostSpeed, System.Math.Round(System.Math.Ceiling(speed / digit - 0.01) * digit, 3));
            string cure = System.FormattableString.Invariant($"Set the simulation's Expected Speed to {spec.ExpectedSpeed} m/s");
            if (spec.TimeStepMode != FluidTimeStepMode.Fixed) return cure;
            FluidSolverSettings settings = Derive(spec, start, start.Gravity);
            double step = FluidRules.Advise(settings, settings.MaxSpeed).Step(spec.Profile.Rules.TimeStepFraction);
            double shorter = System.Math.Min(TimeStepChecks.RoundedDown(step), spec.FixedTimeStep);
            return cure + System.FormattableString.Invariant($" and Fixed Time Step to {shorter} s");
        }

        /// <summary>Speed of the fastest emitter, and at least that of the start [m/s].</summary>
        public static float FastestSource(in FluidSpec spec, float start)
        {
            double speed = start;
            for (int i = 0; i < (spec.Emitters?.Count ?? 0); i++) speed = System.Math.Max(speed, spec.Emitters[i].Speed(spec.Spacing));
            return (float)speed;
        }

        private static float FastestWall(in FluidBoundaries faces)
        {
            float low = Mathf.Max(faces.LowX.magnitude, Mathf.Max(faces.LowY.magnitude, faces.LowZ.magnitude));
            return Mathf.Max(low, Mathf.Max(faces.HighX.magnitude, Mathf.Max(faces.HighY.magnitude, faces.HighZ.magnitude)));
        }

        private static float Hypotenuse(float a, float b) => b > 0f ? (float)System.Math.Sqrt((double)a * a + (double)b * b) : a;

        /// <summary><see cref="LiquidPotential.DepthAtRest"/> of the liquid of the start [m].</summary>
        public static float DepthAtRest(in FluidSpec spec, FluidStart start, Vector3 gravity) =>
            (float)LiquidPotential.DepthAtRest(spec.DomainSize, spec.Spacing, gravity, start.Count);
    }
}
