using UnityEngine;

namespace SphFluid
{
    /// <summary>The solver's constants from a component, its profile and where its liquid starts.</summary>
    internal static class FluidConstants
    {
        /// <summary>Constants by rule.</summary>
        /// <param name="simulation">Settings, with a profile.</param>
        /// <param name="start">Where the liquid starts.</param>
        /// <param name="startGravity">Gravity at the start in simulation space [m/s²]: a domain that turns keeps the fall height it started with.</param>
        /// <exception cref="System.ArgumentException">A constant is out of range.</exception>
        public static FluidSolverSettings Derive(FluidSimulation simulation, FluidStart start, Vector3 startGravity)
        {
            FluidProfile profile = simulation.Profile;
            Vector3 gravity = simulation.LocalGravity;
            Vector3 fall = startGravity.sqrMagnitude > 0f ? startGravity : gravity;
            float height = start.Extent.FallHeight(fall);
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = simulation.Method;
            input.DomainSize = simulation.DomainSize;
            input.Spacing = simulation.Spacing;
            input.Gravity = gravity;
            input.LiquidHeight = height;
            input.LiquidDepth = Mathf.Min(height, DepthAtRest(simulation, start, fall));
            input.InitialSpeed = Hypotenuse(start.InitialSpeed, start.Extent.SpeedBy(simulation.BodyForce));
            input.RestDensity = profile.RestDensity;
            input.KinematicViscosity = profile.KinematicViscosity;
            input.SupportRatio = profile.SupportRatio;
            input.SoundSpeedRatio = profile.SoundSpeedRatio;
            input.MaxCompression = profile.MaxCompression;
            input.ViscosityRatio = profile.ViscosityRatio;
            input.TimeStepFraction = profile.TimeStepFraction;
            input.WallDistanceRatio = profile.WallDistanceRatio;
            input.WallStiffnessRatio = profile.WallStiffnessRatio;
            input.WallDampingRatio = profile.WallDampingRatio;
            input.MinSpeed = Mathf.Max(input.MinSpeed, Mathf.Max(simulation.ExpectedSpeed, FastestWall(simulation.Boundaries)));
            FluidSolverSettings settings = FluidSolverSettings.FromRules(input);
            settings.Boundaries = simulation.Boundaries;
            settings.BodyForce = simulation.BodyForce;
            // The thesis's acceleration limit is a distance a step: its switches, which set it, come after the step's length.
            if (simulation.TimeStepMode == FluidTimeStepMode.Fixed) settings.TimeStep = simulation.FixedTimeStep;
            return simulation.Method == FluidMethodKind.Standard ? settings : settings.With(profile.ThesisSwitches);
        }

        static float FastestWall(in FluidBoundaries faces)
        {
            float low = Mathf.Max(faces.LowX.magnitude, Mathf.Max(faces.LowY.magnitude, faces.LowZ.magnitude));
            return Mathf.Max(low, Mathf.Max(faces.HighX.magnitude, Mathf.Max(faces.HighY.magnitude, faces.HighZ.magnitude)));
        }

        static float Hypotenuse(float a, float b) => b > 0f ? (float)System.Math.Sqrt((double)a * a + (double)b * b) : a;

        // Liquid volume over the domain's cross-section across gravity, domain volume / domain height.
        static float DepthAtRest(FluidSimulation simulation, FluidStart start, Vector3 gravity)
        {
            Vector3 size = simulation.DomainSize;
            Vector3 up = gravity.normalized;
            float height = Mathf.Abs(up.x) * size.x + Mathf.Abs(up.y) * size.y + Mathf.Abs(up.z) * size.z;
            double liquid = start.Count * System.Math.Pow(simulation.Spacing, 3);
            return (float)(liquid / ((double)size.x * size.y * size.z) * height);
        }
    }
}
