using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The rules that a simulation's settings have to meet. One set serves the inspector, the console and tests.</summary>
    public static class FluidValidation
    {
        const float ScaleTolerance = 1e-4f;

        /// <summary>Checks a simulation with its liquid and its colliders, of a prefab asset only the settings; changes nothing.</summary>
        /// <param name="simulation">The simulation.</param>
        /// <returns>What is wrong or worth knowing, errors first.</returns>
        public static List<FluidMessage> Validate(FluidSimulation simulation)
        {
            using (var collision = new CollisionScene())
                return Prepare(simulation, collision, false, out _);
        }

        /// <summary>Checks like <see cref="Validate"/> and tells the constants that the simulation would start with.</summary>
        /// <param name="simulation">The simulation.</param>
        /// <param name="constants">Null when there is an error.</param>
        /// <returns>The messages, errors first.</returns>
        internal static List<FluidMessage> Preview(FluidSimulation simulation, out FluidSolverSettings? constants)
        {
            using (var collision = new CollisionScene())
            {
                List<FluidMessage> messages = Prepare(simulation, collision, false, out FluidStart start);
                constants = start?.Constants;
                return messages;
            }
        }

        /// <summary>Checks the simulation and, when nothing speaks against it, tells its start.</summary>
        /// <param name="simulation">The simulation.</param>
        /// <param name="collision">Receives the colliders.</param>
        /// <param name="fill">Whether to make the first particles, not only count them.</param>
        /// <param name="start">How it starts; null when there is an error.</param>
        /// <returns>The messages, errors first.</returns>
        internal static List<FluidMessage> Prepare(FluidSimulation simulation, CollisionScene collision, bool fill, out FluidStart start)
        {
            start = null;
            var messages = new List<FluidMessage>();
            CheckDevice(simulation, messages);
            CheckReferences(simulation, messages);
            CheckTransform(simulation, messages);
            bool measurable = CheckNumbers(simulation, messages);
            if (measurable)
            {
                if (SceneObjects.IsPrefabAsset(simulation)) messages.Add(Unplaced(simulation));
                else start = CheckScene(simulation, collision, fill, messages);
                BoundaryRules.Check(simulation, messages);
                CellRules.Check(simulation, messages);
            }
            if (HasErrors(messages) || !TryDerive(simulation, start, messages)) start = null;
            if (start != null) TimeStepRules.Check(simulation, start.Constants, messages);
            return messages.OrderByDescending(m => m.Severity).ToList();
        }

        /// <summary>Whether any message says that the simulation cannot run.</summary>
        /// <param name="messages">The messages.</param>
        /// <returns>True when one is an error.</returns>
        public static bool HasErrors(IReadOnlyList<FluidMessage> messages)
        {
            foreach (FluidMessage message in messages)
                if (message.Severity == FluidSeverity.Error) return true;
            return false;
        }

        static void CheckDevice(FluidSimulation simulation, List<FluidMessage> messages)
        {
            foreach (FluidMessage message in FluidSupport.Query().ErrorsOf(simulation.Method))
                messages.Add(new FluidMessage(message.Severity, message.Issue, simulation, message.Text, message.Cure));
        }

        static void CheckReferences(FluidSimulation simulation, List<FluidMessage> messages)
        {
            FluidProfile profile = simulation.Profile;
            if (profile == null)
                messages.Add(Error(simulation, FluidIssue.ProfileMissing, "No profile is assigned.",
                    "Assign a Fluid Profile, for instance WaterProfile from the package's Runtime/Assets, or make one with Assets > Create > SPH Fluid > Fluid Profile."));
            else if (profile.Shaders == null)
                messages.Add(Error(profile, FluidIssue.ShadersMissing, "The profile has no shader set.",
                    "Assign the package's DefaultFluidShaderSet from Runtime/Assets to the profile's Shaders."));
            else if (profile.Shaders.MissingFor(simulation.Method) is { Count: > 0 } missing)
                messages.Add(Error(profile.Shaders, FluidIssue.ShadersMissing, $"The shader set lacks {string.Join(", ", missing)}.",
                    "Assign the shaders of the same names from the package's Shaders folder, or use the package's DefaultFluidShaderSet."));
        }

        static void CheckTransform(FluidSimulation simulation, List<FluidMessage> messages)
        {
            Vector3 scale = simulation.transform.lossyScale;
            bool unit = Mathf.Abs(scale.x - 1f) <= ScaleTolerance && Mathf.Abs(scale.y - 1f) <= ScaleTolerance &&
                Mathf.Abs(scale.z - 1f) <= ScaleTolerance;
            if (!unit)
                messages.Add(Error(simulation, FluidIssue.TransformScaled,
                    $"The transform's scale is {Text(scale)}, but the liquid is computed in metres and needs scale 1.",
                    "Set the scale of this object and its parents to 1 and give the size in Domain Size."));
        }

        static bool CheckNumbers(FluidSimulation simulation, List<FluidMessage> messages)
        {
            Vector3 size = simulation.DomainSize;
            float spacing = simulation.Spacing;
            bool sized = AffineMath.IsFinite(size) && size.x > 0f && size.y > 0f && size.z > 0f;
            bool spaced = AffineMath.IsFinite(spacing) && spacing > 0f;
            if (!sized)
                messages.Add(Error(simulation, FluidIssue.DomainSizeInvalid, $"The domain size is {Text(size)} m.",
                    "Give Domain Size three numbers greater than zero."));
            if (!spaced)
                messages.Add(Error(simulation, FluidIssue.SpacingInvalid, $"The particle spacing is {spacing} m.",
                    "Give Particle Spacing a number greater than zero."));
            else if (sized && Mathf.Min(size.x, Mathf.Min(size.y, size.z)) < 2f * spacing)
                messages.Add(Error(simulation, FluidIssue.SpacingInvalid,
                    $"The domain of {Text(size)} m is less than two particles of {spacing} m wide.",
                    "Use a smaller Particle Spacing or a larger Domain Size."));
            if (!AffineMath.IsFinite(simulation.EffectiveGravity))
                messages.Add(Error(simulation, FluidIssue.GravityInvalid, "Gravity is not a finite number.", "Give Gravity three finite numbers."));
            float step = simulation.FixedTimeStep;
            if (simulation.TimeStepMode == FluidTimeStepMode.Fixed && !(AffineMath.IsFinite(step) && step > 0f))
                messages.Add(Error(simulation, FluidIssue.TimeStepInvalid, $"The fixed time step is {step} s.",
                    "Give Fixed Time Step a number greater than zero, or set Time Step Mode to Automatic."));
            return sized && spaced && AffineMath.IsFinite(simulation.transform.position);
        }

        static FluidStart CheckScene(
            FluidSimulation simulation, CollisionScene collision, bool fill, List<FluidMessage> messages)
        {
            CollisionQuery query = FluidScene.Query(simulation);
            collision.Gather(query);
            messages.AddRange(collision.Messages);
            MeshColliderRules.Check(query, messages);
            return LiquidRules.Check(simulation, collision, fill, messages);
        }

        static FluidMessage Unplaced(FluidSimulation simulation) => new FluidMessage(
            FluidSeverity.Info, FluidIssue.PrefabAsset, simulation,
            "This is a prefab asset: its liquid and colliders are checked once it is in a scene.",
            "Place it in a scene or open the prefab to check all of it.");

        static bool TryDerive(FluidSimulation simulation, FluidStart start, List<FluidMessage> messages)
        {
            try
            {
                if (start != null) start.Constants = FluidConstants.Derive(simulation, start, simulation.LocalGravity);
                return true;
            }
            catch (System.ArgumentException exception)
            {
                messages.Add(Error(simulation, FluidIssue.StartFailed, exception.Message, ""));
                return false;
            }
        }

        internal static string Text(Vector3 v) => System.FormattableString.Invariant($"{v.x:0.####} × {v.y:0.####} × {v.z:0.####}");

        static FluidMessage Error(Object context, FluidIssue issue, string text, string cure) =>
            new FluidMessage(FluidSeverity.Error, issue, context, text, cure);
    }
}
