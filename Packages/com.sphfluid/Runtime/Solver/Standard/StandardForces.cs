using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The forces of the Standard method that have passes of their own, and what they say together.</summary>
    internal static class StandardForces
    {
        /// <summary>The forces; a line each.</summary>
        public static readonly IReadOnlyList<ParticleForce> All = new ParticleForce[]
        {
            new GradientCorrectionForce(),
            new SurfaceTensionForce(),
        };

        /// <summary>Features that are forces: without one a liquid would be another.</summary>
        public static FluidMethodFeatures Features => All.Aggregate(FluidMethodFeatures.None, (sum, force) => sum | force.Feature);

        /// <summary>Their shaders.</summary>
        public static IEnumerable<string> Shaders => All.SelectMany(force => force.Shaders);

        /// <summary>The fields of a profile that they read.</summary>
        public static IEnumerable<string> ProfileFields => All.SelectMany(force => force.ProfileFields);

        /// <summary>Those that act.</summary>
        public static IEnumerable<ParticleForce> Acting(StandardSettings settings) => All.Where(force => force.Acts(settings));

        /// <summary>Whether any acts. It is asked in every frame, and leaves no garbage.</summary>
        public static bool Act(in StandardSettings settings)
        {
            for (int i = 0; i < All.Count; i++)
            {
                if (All[i].Acts(settings)) return true;
            }
            return false;
        }

        /// <summary>Records their parts in PairForces.hlsl.</summary>
        public static void SetMotion(CommandBuffer cmd, ComputeKernel kernel, StandardState state, in FluidStep step)
        {
            foreach (ParticleForce force in All) force.SetMotion(cmd, kernel, state, step);
        }

        /// <summary>Least speed of sound by which a liquid withstands them [m/s].</summary>
        public static double LeastSoundSpeed(in FluidRuleInput input, in StandardSettings settings)
        {
            double least = 0.0;
            foreach (ParticleForce force in All) least = Math.Max(least, force.LeastSoundSpeed(input, settings));
            return least;
        }

        /// <summary>The largest step that all allow [s].</summary>
        public static double LargestStep(in FluidSolverSettings settings)
        {
            double largest = double.PositiveInfinity;
            foreach (ParticleForce force in All) largest = Math.Min(largest, force.LargestStep(settings));
            return largest;
        }
    }
}
