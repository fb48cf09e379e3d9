using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>Why a simulation cannot be computed by a method, as the end of a sentence that begins with the method's name.</summary>
    internal static class MethodObstacles
    {
        /// <summary>By the device, the shaders and the components of the simulation, before anything is known of its liquid.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="method">The method.</param>
        /// <returns>Null where there is none.</returns>
        public static string Find(in FluidSpec spec, FluidMethod method)
        {
            if (!FluidSupport.Query().Supports(method.Kind)) return "does not run on this device";
            if (spec.Profile.Shaders != null && spec.Profile.Shaders.Missing(method.Shaders.AllShaders).Count > 0)
            {
                return "has shaders that the shader set lacks";
            }
            return Lack(spec, method) is string lack ? $"has no {lack}, which the simulation uses" : null;
        }

        /// <summary>By the device, the shaders, the components and the physics of the liquid.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="input">What the rules start from.</param>
        /// <param name="method">The method.</param>
        /// <returns>Null where there is none.</returns>
        /// <exception cref="ArgumentException">An input is out of range.</exception>
        public static string Find(in FluidSpec spec, in FluidRuleInput input, FluidMethod method) =>
            Find(spec, method) ?? MissingPhysics(input, method);

        /// <summary>Those of all methods that Automatic may pick, a sentence each.</summary>
        /// <param name="given">The simulation.</param>
        /// <param name="start">Where its liquid starts.</param>
        /// <exception cref="ArgumentException">An input is out of range.</exception>
        public static string OfAll(in FluidSpec given, FluidStart start)
        {
            FluidSpec spec = given.AsSet();
            FluidRuleInput input = FluidConstants.Input(spec, start, start.Gravity);
            var sentences = new List<string>();
            foreach (FluidMethod method in FluidMethods.All)
                if (method.MayBePicked && Find(spec, input, method) is string obstacle) sentences.Add($"{method.Kind} {obstacle}.");
            return string.Join(" ", sentences);
        }

        private static string Lack(in FluidSpec spec, FluidMethod method) =>
            spec.Boundaries.Open != FluidFaces.None && !method.Has(FluidMethodFeatures.OpenFaces) ? "open faces" :
            (spec.Emitters?.Count ?? 0) + (spec.Drains?.Count ?? 0) > 0 && !method.Has(FluidMethodFeatures.ChangingCount)
            ? "emitters and drains" :
            spec.Zones?.Count > 0 && !method.Has(FluidMethodFeatures.ForceZones) ? "force zones" :
            spec.StartRelaxation != FluidStartRelaxation.None && spec.StartRelaxation != FluidStartRelaxation.Saved &&
                !method.Has(FluidMethodFeatures.RelaxedStart) ? "relaxed start" : null;

        /// <summary>
        /// What any method that Automatic may pick finds that a liquid asks for, whether or not that method can be picked.
        /// </summary>
        /// <param name="input">The liquid.</param>
        /// <exception cref="ArgumentException">An input is out of range.</exception>
        public static FluidMethodFeatures AskedBy(in FluidRuleInput input)
        {
            FluidMethodFeatures asked = FluidMethodFeatures.None;
            foreach (FluidMethod method in FluidMethods.All)
                if (method.MayBePicked) asked |= method.AskedBy(input);
            return asked;
        }

        private static string MissingPhysics(in FluidRuleInput input, FluidMethod method)
        {
            FluidMethodFeatures missing = AskedBy(input) & ~method.Features;
            foreach (FluidMethod other in FluidMethods.All)
                if (other.MayBePicked && other.Describe(missing, input) is string lack) return $"has no {lack}";
            return null;
        }
    }
}
