using System;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Liquid in a long tank as columns of equal volume, for metrics of levels.</summary>
    internal static class TankStates
    {
        private const int Columns = 2000, Cuts = 4000;

        /// <summary>Particles of equal volume below a level between two walls.</summary>
        /// <param name="from">x of the one wall [m].</param>
        /// <param name="to">x of the other [m].</param>
        /// <param name="depth">Depth at a place [m].</param>
        /// <param name="velocity">Velocity at a position; null: at rest.</param>
        public static FluidSnapshot Below(double from, double to, Func<double, double> depth, Func<Vector3, Vector3> velocity = null)
        {
            var volume = new double[Cuts + 1];
            double cut = (to - from) / Cuts;
            for (int i = 1; i <= Cuts; i++) volume[i] = volume[i - 1] + cut * depth(from + (i - 0.5) * cut);
            return WallCaseStates.State(Columns, Position, velocity == null ? (Func<int, Vector3>)null : n => velocity(Position(n)));

            Vector3 Position(int n)
            {
                double part = (n + 0.5) / Columns * volume[Cuts];
                int above = Array.BinarySearch(volume, part);
                above = Math.Max(1, above < 0 ? ~above : above);
                double x = from + cut * (above - 1 + (part - volume[above - 1]) / (volume[above] - volume[above - 1]));
                return new Vector3((float)x, (float)Math.Sin(n), 0f);
            }
        }
    }
}
