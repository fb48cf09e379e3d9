using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Pressure of a plane jet along the wall that it hits at right angles, by free streamlines. Where the liquid has the part q of the
    /// jet's speed along the wall, y = (b/π) (2 arctan q + ln (1 + q)/(1 − q)) from the middle (Milne-Thomson, Theoretical Hydrodynamics,
    /// ch. XI), and by Bernoulli p = ½ρU² (1 − q²); from the middle to there the wall bears (2/π) arctan q of ρU²b.
    /// </summary>
    internal static class JetWall
    {
        /// <summary>Strips of the wall, from −<see cref="Reach"/> to <see cref="Reach"/>.</summary>
        public const int Strips = 16;

        /// <summary>How far they go from the middle, over b.</summary>
        public const double Reach = 2.0;

        /// <summary>Middle of a strip over b.</summary>
        public static double Middle(int strip) => Reach * ((2.0 * strip + 1.0) / Strips - 1.0);

        /// <summary>Mean pressure on a strip over ½ρU².</summary>
        public static double Pressure(int strip)
        {
            double half = Reach / Strips;
            return 2.0 * (Force(Middle(strip) + half) - Force(Middle(strip) - half)) / (2.0 * half);
        }

        /// <summary>Strips of a wall that is the domain's face of least x, in the middle of whose height the jet hits it.</summary>
        /// <param name="domain">Size of the domain [m].</param>
        /// <param name="width">b [m].</param>
        public static IReadOnlyList<CasePatch> Patches(Vector3 domain, double width)
        {
            var patches = new CasePatch[Strips];
            for (int i = 0; i < Strips; i++)
            {
                patches[i] = new CasePatch(new Vector3(-0.5f * domain.x, (float)(Middle(i) * width), 0f), Vector3.right, Vector3.up,
                    new Vector2(domain.z, (float)(2.0 * Reach / Strips * width)));
            }
            return patches;
        }

        // What the wall bears from the middle to y over b, over ρU²b.
        private static double Force(double y) => Math.Sign(y) * 2.0 / Math.PI * Math.Atan(SpeedAt(Math.Abs(y)));

        // q at y over b, by halving.
        private static double SpeedAt(double y)
        {
            double low = 0.0, high = 1.0;
            for (int i = 0; i < 52; i++)
            {
                double q = 0.5 * (low + high);
                if (2.0 * Math.Atan(q) + Math.Log((1.0 + q) / (1.0 - q)) < Math.PI * y)
                    low = q;
                else
                    high = q;
            }
            return low;
        }
    }
}
