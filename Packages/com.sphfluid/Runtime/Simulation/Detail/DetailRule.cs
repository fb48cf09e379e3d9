using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Which level of detail a distance asks for.</summary>
    internal static class DetailRule
    {
        /// <summary>Part of a level's distance that a camera comes nearer by before the level ends.</summary>
        public const float Hysteresis = 0.1f;

        // Degrees: the field of view that distances are for, that of a new camera.
        private const double UsualView = 60.0;

        /// <summary>
        /// Distance at which a camera of 60° sees things as large as a camera does; as LODGroup has it. Worked example: at 5° a liquid
        /// 130 m away looks as at 10 m.
        /// </summary>
        /// <param name="camera">The camera.</param>
        /// <param name="distance">Its distance [m].</param>
        public static float SeenFrom(Camera camera, float distance)
        {
            double unit = HalfWidth(UsualView);
            return (float)(camera.orthographic ? Math.Abs(camera.orthographicSize) / unit
                : distance * HalfWidth(camera.fieldOfView) / unit);
        }

        /// <summary>Distance of a point from a box [m]; 0 inside.</summary>
        /// <param name="pose">World space to the box's.</param>
        /// <param name="size">Its edge lengths about the origin [m].</param>
        /// <param name="world">The point.</param>
        public static float ToBox(DomainPose pose, Vector3 size, Vector3 world) =>
            Mathf.Sqrt(new Bounds(Vector3.zero, size).SqrDistance(pose.MultiplyPoint3x4(world)));

        /// <summary>The number of the level for a distance: 0 for none.</summary>
        /// <param name="levels">The levels, with ascending distances.</param>
        /// <param name="distance">The distance, over what importance and LOD Bias multiply distances by [m].</param>
        /// <param name="before">The level until now.</param>
        public static int LevelFor(IReadOnlyList<FluidDetailLevel> levels, float distance, int before)
        {
            int level = 0;
            while (level < levels.Count && distance >= levels[level].Distance) level++;
            int kept = Math.Min(before, levels.Count);
            while (kept > level && distance < (1f - Hysteresis) * levels[kept - 1].Distance) kept--;
            return Math.Max(level, kept);
        }

        /// <summary>What is wrong with levels, as sentences, and the cure; null: nothing.</summary>
        /// <param name="levels">The levels.</param>
        /// <param name="importance">What multiplies their distances.</param>
        /// <param name="box">Size of the box that distances count from [m]; zero: the domain's.</param>
        public static (string text, string cure)? Problem(IReadOnlyList<FluidDetailLevel> levels, float importance, Vector3 box)
        {
            if (!(importance > 0f) || float.IsInfinity(importance))
            {
                return ($"Importance is {importance}", "Give Importance a number greater than zero; 1 leaves distances as they are.");
            }
            if (!AffineMath.IsFinite(box) || box.x < 0f || box.y < 0f || box.z < 0f)
            {
                return ($"The size of the liquid's box is {FluidMessage.Lengths(box)} m",
                    "Give Size three numbers of zero or more; zeros: the domain's.");
            }
            float before = 0f;
            for (int i = 0; i < levels.Count; i++)
            {
                FluidDetailLevel level = levels[i];
                if (level == null) return ($"Level {i + 1} is missing", "Give Levels no empty element.");
                if (!(level.Distance > before) || float.IsInfinity(level.Distance))
                {
                    return (FormattableString.Invariant($"The distance of level {i + 1} is {level.Distance} m, not beyond {before} m"),
                        "Give each level a greater Distance than the one before it, and the first one more than zero.");
                }
                if (!IsFactor(level.StepFactor) || !IsFactor(level.CellFactor))
                {
                    (string name, float factor) = IsFactor(level.StepFactor) ? ("Cell Factor", level.CellFactor)
                        : ("Step Factor", level.StepFactor);
                    return (FormattableString.Invariant($"{name} of level {i + 1} is {factor}"),
                        $"Give {name} a number of one or more; 1 is as set up.");
                }
                before = level.Distance;
            }
            return null;
        }

        private static bool IsFactor(float factor) => factor >= 1f && !float.IsInfinity(factor);

        private static double HalfWidth(double degrees) => Math.Tan(degrees * Math.PI / 360.0);
    }
}
