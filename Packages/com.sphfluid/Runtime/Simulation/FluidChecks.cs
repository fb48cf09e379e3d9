using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// What a simulation has to fulfil, by its spec. The checks look and change nothing; one set serves the inspector, the console and
    /// tests.
    /// </summary>
    internal static class FluidChecks
    {
        private const float ScaleTolerance = 1e-4f, MostGravity = 1e5f;

        /// <summary>Checks a simulation with its liquid and its colliders, of a prefab asset only the settings.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="volumes">Its liquid volumes, in hierarchy order.</param>
        /// <param name="constants">Those that the simulation would start with; null when there is an error.</param>
        /// <returns>What is wrong or worth knowing, errors first.</returns>
        public static List<FluidMessage> Preview(in FluidSpec spec, IReadOnlyList<VolumeSpec> volumes, out FluidSolverSettings? constants)
        {
            using (var collision = new CollisionScene())
            {
                List<FluidMessage> messages = Check(spec, volumes, collision, FluidSpawner.Measure, out FluidStart start);
                constants = start?.Constants;
                return messages;
            }
        }

        /// <summary>Checks a simulation and, when nothing speaks against it, gives its start.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="volumes">Its liquid volumes, in hierarchy order.</param>
        /// <param name="collision">Receives the colliders.</param>
        /// <param name="spawn">Makes or counts the first particles.</param>
        /// <param name="start">How it starts; null when there is an error.</param>
        /// <param name="measures">Whether steps are timed on the GPU where Automatic is to choose and their cost is not known.</param>
        /// <returns>The messages, errors first.</returns>
        public static List<FluidMessage> Check(in FluidSpec spec, IReadOnlyList<VolumeSpec> volumes, CollisionScene collision,
            Func<SpawnRequest, SpawnResult> spawn, out FluidStart start, bool measures = false) =>
                Check(spec, collision, (now, messages) => Begin(now, volumes, collision, spawn, messages, out _), out start, measures);

        /// <summary>Checks a simulation that begins as it is said.</summary>
        internal static List<FluidMessage> Check(in FluidSpec given, CollisionScene collision,
            Func<FluidSpec, List<FluidMessage>, FluidStart> begin, out FluidStart start,
            bool measures = false)
        {
            FluidSpec spec = given;
            start = null;
            var messages = new List<FluidMessage>();
            if (!FluidMethods.Has(spec.Method))
            {
                messages.Add(Error(spec.Owner, FluidIssue.MethodUnknown, $"There is no method {spec.Method}.", "Choose another Method."));
                return messages;
            }

            CheckDevice(spec, messages);
            CheckReferences(spec, messages);
            CheckTransform(spec, messages);
            bool measurable = CheckNumbers(spec, messages);
            if (measurable)
            {
                if (SceneObjects.IsPrefabAsset(spec.Owner)) messages.Add(Unplaced(spec));
                else
                {
                    CheckColliders(spec, collision, messages);
                    start = begin(spec, messages);
                    if (start != null && spec.Automatic.IsOn && !HasErrors(messages))
                    {
                        spec = Choose(spec, start, collision, measures, messages);
                    }
                }
                BoundaryChecks.Check(spec, messages);
                EmitterChecks.Check(spec, messages);
                EmitterChecks.CheckPlaces(spec, collision, messages);
                FluidZones.Check(spec, messages);
                CellChecks.Check(spec, messages);
            }
            if (HasErrors(messages) || !TryDerive(spec, start, messages)) start = null;
            if (start != null)
            {
                TimeStepChecks.Check(spec, start.Constants, messages);
                SleepChecks.Check(spec, start, messages);
                DetailChecks.Check(spec, start, messages);
            }
            return messages.OrderByDescending(m => m.Severity).ToList();
        }

        /// <summary>Checks a simulation whose liquid goes on from a save.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="collision">Receives the colliders.</param>
        /// <param name="saved">How its liquid started once; receives the constants.</param>
        /// <returns>The messages, errors first; with an error it cannot go on.</returns>
        public static List<FluidMessage> CheckAgain(in FluidSpec spec, CollisionScene collision, FluidStart saved) =>
            Check(spec, collision, (now, messages) => saved, out _);

        /// <summary>Whether any message says that the simulation cannot run.</summary>
        /// <param name="messages">The messages.</param>
        /// <returns>True when one is an error.</returns>
        public static bool HasErrors(IReadOnlyList<FluidMessage> messages)
        {
            foreach (FluidMessage message in messages)
                if (message.Severity == FluidSeverity.Error) return true;
            return false;
        }

        private static void CheckDevice(in FluidSpec spec, List<FluidMessage> messages)
        {
            foreach (FluidMessage message in FluidSupport.Query().ErrorsOf(spec.Method))
            {
                messages.Add(new FluidMessage(message.Severity, message.Issue, spec.Owner, message.Text, message.Cure));
            }
        }

        private static void CheckReferences(in FluidSpec spec, List<FluidMessage> messages)
        {
            if (!spec.HasProfile)
                messages.Add(Error(spec.Owner, FluidIssue.ProfileMissing,
                    spec.Liquid != null ? $"The liquid '{spec.Liquid.name}' has no profile." : "No liquid is assigned.",
                    "Assign a Fluid Liquid, for instance Water from the package's Runtime/Assets/Liquids, or a Fluid Profile, as " +
                    "WaterProfile from Runtime/Assets."));
            else if (spec.Profile.Shaders == null)
                messages.Add(Error(spec.Profile.Asset, FluidIssue.ShadersMissing, "The profile has no shader set.",
                    "Assign the package's DefaultFluidShaderSet from Runtime/Assets to the profile's Shaders."));
            else if (spec.Profile.Shaders.Missing(FluidMethods.Get(spec.Method).Shaders.AllShaders) is { Count: > 0 } missing)
                messages.Add(Error(spec.Profile.Shaders, FluidIssue.ShadersMissing, $"The shader set has no {string.Join(", ", missing)}.",
                    "Add the shaders of these names from the package's Shaders folder, or use the package's DefaultFluidShaderSet."));
        }

        private static void CheckTransform(in FluidSpec spec, List<FluidMessage> messages)
        {
            Vector3 scale = spec.Scale;
            bool unit = Mathf.Abs(scale.x - 1f) <= ScaleTolerance && Mathf.Abs(scale.y - 1f) <= ScaleTolerance &&
                Mathf.Abs(scale.z - 1f) <= ScaleTolerance;
            if (!unit)
            {
                messages.Add(Error(spec.Owner, FluidIssue.TransformScaled,
                    $"The transform's scale is {FluidMessage.Lengths(scale)}, but the liquid is computed in metres and needs scale 1.",
                    "Set the scale of this object and its parents to 1 and give the size in Domain Size."));
            }
        }

        private static bool CheckNumbers(in FluidSpec spec, List<FluidMessage> messages)
        {
            Vector3 size = spec.DomainSize;
            float spacing = spec.Spacing;
            bool sized = AffineMath.IsFinite(size) && size.x > 0f && size.y > 0f && size.z > 0f;
            bool spaced = AffineMath.IsFinite(spacing) && spacing > 0f;
            if (!sized)
            {
                messages.Add(Error(spec.Owner, FluidIssue.DomainSizeInvalid,
                    spec.IsOpen ? $"The farthest distance is {FluidMessage.Lengths(0.5f * size)} m."
                        : $"The domain size is {FluidMessage.Lengths(size)} m.",
                    $"Give {spec.SizeField} three numbers greater than zero."));
            }
            if (!spaced)
                messages.Add(Error(spec.Owner, FluidIssue.SpacingInvalid, $"The particle spacing is {spacing} m.",
                    "Give Particle Spacing a number greater than zero."));
            else if (sized && Mathf.Min(size.x, Mathf.Min(size.y, size.z)) < 2f * spacing)
                messages.Add(Error(spec.Owner, FluidIssue.SpacingInvalid,
                    $"The domain of {FluidMessage.Lengths(size)} m is less than two particles of {spacing} m wide.",
                    $"Use a smaller Particle Spacing or a larger {spec.SizeField}."));
            if (!(spec.Gravity.magnitude <= MostGravity))
            {
                messages
                    .Add(Error(spec.Owner, FluidIssue.GravityInvalid, "Gravity is not a finite number of up to 100,000 m/s².",
                        "Give Gravity three finite numbers."));
            }
            CheckBudget(spec, messages);
            float step = spec.FixedTimeStep;
            if (spec.TimeStepMode == FluidTimeStepMode.Fixed && !(AffineMath.IsFinite(step) && step > 0f))
            {
                messages.Add(Error(spec.Owner, FluidIssue.TimeStepInvalid, $"The fixed time step is {step} s.",
                    "Give Fixed Time Step a number greater than zero, or set Time Step Mode to Automatic."));
            }
            return sized && spaced && AffineMath.IsFinite(spec.Position);
        }

        private static void CheckBudget(in FluidSpec spec, List<FluidMessage> messages)
        {
            if (!spec.Automatic.IsOn) return;
            if (!(spec.Automatic.Budget > 0.0) || double.IsInfinity(spec.Automatic.Budget))
            {
                messages
                    .Add(Error(spec.Owner, FluidIssue.MethodChoice,
                        FormattableString.Invariant($"The frame budget is {spec.Automatic.Budget} ms, so no method can be chosen by it."),
                    "Give Frame Budget the milliseconds that this liquid's steps may take of a frame, or choose a Method."));
            }
            if (!(spec.Automatic.FrameRate > 0.0) || double.IsInfinity(spec.Automatic.FrameRate))
            {
                messages
                    .Add(Error(spec.Owner, FluidIssue.MethodChoice,
                        FormattableString.Invariant($"The budget frame rate is {spec.Automatic.FrameRate} frames a second."),
                    "Give Budget Frame Rate a number greater than zero, or zero for the application's own."));
            }
        }

        // A start that goes on from a save has its choice.
        private static FluidSpec Choose(in FluidSpec spec, FluidStart start, CollisionScene collision, bool measures,
            List<FluidMessage> messages)
        {
            try
            {
                FluidShaderSet shaders = spec.Profile.Shaders;
                StepMeter meter = null;
                if (measures)
                {
                    meter = (in FluidSolverSettings settings) => StepCalibration.Measure(settings, shaders, start.Particles, collision);
                }
                start.Choice ??= MethodChooser.Choose(spec, start, collision.Solids.Count > 0, meter);
                if (start.Choice == null)
                {
                    messages.Add(MethodChoiceText.NoneMessage(spec, MethodObstacles.OfAll(spec, start)));
                    return spec;
                }
                messages.Add(MethodChoiceText.Message(start.Choice, spec.Owner));
                return start.Resolve(spec);
            }
            catch (ArgumentException)
            {
                return spec; // the derivation reports it
            }
        }

        private static void CheckColliders(in FluidSpec spec, CollisionScene collision, List<FluidMessage> messages)
        {
            CollisionQuery query = spec.Query();
            collision.Gather(query);
            messages.AddRange(collision.Messages);
            MeshColliderChecks.Check(query, messages);
        }

        /// <summary>Where a simulation's liquid begins, and what is to be said about its volumes.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="volumes">Its liquid volumes, in hierarchy order.</param>
        /// <param name="collision">The colliders, gathered.</param>
        /// <param name="spawn">Makes or counts the first particles.</param>
        /// <param name="messages">Receives what is wrong.</param>
        /// <param name="shapes">The shapes of the volumes that can be filled.</param>
        /// <returns>Null when it cannot begin.</returns>
        internal static FluidStart Begin(in FluidSpec spec, IReadOnlyList<VolumeSpec> volumes, CollisionScene collision,
            Func<SpawnRequest, SpawnResult> spawn, List<FluidMessage> messages, out IReadOnlyList<LiquidShape> shapes)
        {
            shapes = Array.Empty<LiquidShape>();
            if (spec.Playback != null) return PlayedLiquid.Begin(spec, messages);
            List<(VolumeSpec, LiquidShape shape)> found = LiquidChecks.Shapes(spec, volumes, collision, messages);
            shapes = found.ConvertAll(f => f.shape);
            if (found.Count == 0 && (volumes.Count > 0 || LiquidChecks.IsDry(spec))) return null;
            SpawnResult result = spawn(SpawnRequests.For(spec, shapes, collision));
            if (!LiquidChecks.CheckCount(spec, result, messages)) return null; // far more than that are not gone through
            LiquidChecks.Check(spec, found, result, collision, messages);
            return new FluidStart(result.Particles, result.Needed, LiquidExtent.Create(shapes, spec.DomainSize),
                result.Fastest)
            { Gravity = spec.LocalGravity };
        }

        private static FluidMessage Unplaced(in FluidSpec spec) => new FluidMessage(
            FluidSeverity.Info, FluidIssue.PrefabAsset, spec.Owner,
            "This is a prefab asset: its liquid and colliders are checked once it is in a scene.",
            "Place it in a scene or open the prefab to check all of it.");

        private static bool TryDerive(in FluidSpec spec, FluidStart start, List<FluidMessage> messages)
        {
            try
            {
                if (start != null) start.Constants = FluidConstants.Derive(spec, start, start.Gravity);
                return true;
            }
            catch (ArgumentException exception)
            {
                messages.Add(Error(spec.Owner, FluidIssue.StartFailed, exception.Message, ""));
                return false;
            }
        }

        private static FluidMessage Error(UnityEngine.Object context, FluidIssue issue, string text, string cure) =>
            new FluidMessage(FluidSeverity.Error, issue, context, text, cure);
    }
}
