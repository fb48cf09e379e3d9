using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Kinetic energy of a liquid in a tank, what its linear waves have of it and what else moves: the velocities of modes 1, 2, … are
    /// fitted to the particles' one after the other, u = (−sin k x cosh k y, cos k x sinh k y) with y from the floor.
    /// </summary>
    internal sealed class TankMotion
    {
        private readonly TankModes tank;
        private readonly double wall, floor;

        /// <summary>A tank at rest.</summary>
        /// <param name="tank">The tank.</param>
        /// <param name="wall">x of the end wall of less x [m], simulation space.</param>
        /// <param name="floor">y of the floor [m].</param>
        public TankMotion(TankModes tank, double wall, double floor)
        {
            this.tank = tank;
            this.wall = wall;
            this.floor = floor;
        }

        /// <summary>Kinetic energy of the waves and what is left, by unit mass [m²/s²], mean over the particles.</summary>
        public (double Waves, double Else) Kinetic(FluidSnapshot state, int modes)
        {
            var left = (Vector3[])state.Velocities.Clone();
            double whole = Mean(left);
            for (int n = 1; n <= modes; n++) Remove(state, tank.WaveNumber(n), left);
            double beside = Mean(left);
            return (whole - beside, beside);
        }

        private void Remove(FluidSnapshot state, double k, Vector3[] left)
        {
            double product = 0.0, squares = 0.0;
            for (int i = 0; i < left.Length; i++)
            {
                (double x, double y) = Mode(state.LocalPositions[i], k);
                product += x * left[i].x + y * left[i].y;
                squares += x * x + y * y;
            }
            double speed = squares > 0.0 ? product / squares : 0.0;
            for (int i = 0; i < left.Length; i++)
            {
                (double x, double y) = Mode(state.LocalPositions[i], k);
                left[i] -= new Vector3((float)(speed * x), (float)(speed * y), 0f);
            }
        }

        // Over cosh kH, which leaves high modes finite.
        private (double X, double Y) Mode(Vector3 position, double k)
        {
            double angle = k * (position.x - wall), up = Math.Exp(k * (position.y - floor - tank.Depth));
            double down = Math.Exp(-k * (position.y - floor + tank.Depth));
            return (-Math.Sin(angle) * (up + down), Math.Cos(angle) * (up - down));
        }

        private static double Mean(Vector3[] velocities)
        {
            double sum = 0.0;
            foreach (Vector3 v in velocities) sum += 0.5 * v.sqrMagnitude;
            return velocities.Length > 0 ? sum / velocities.Length : 0.0;
        }
    }
}
