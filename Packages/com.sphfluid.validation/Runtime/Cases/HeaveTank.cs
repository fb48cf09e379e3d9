using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>
    /// A box floats in the middle of a tank of water and heaves: linear potential flow in two dimensions, surface waves, their reflection
    /// and the water's inertia included. Half of the tank is computed, the other mirrors it. Laplace's equation by finite volumes about the
    /// nodes of a square grid, with φ given on the free surface and its normal derivative on the box; η and φ there and the box's
    /// motion by Runge and Kutta's method of fourth order.
    /// <para>With Φ the potential of the box's unit speed under φ = 0 at the surface, (m + ρ ∫Φ) V′ = −ρ g b ζ + ρ g Σ r η, r = ∂φ/∂n of Φ
    /// at the surface's nodes with the sign turned: what the surface's own motion does to the box is what the box's does to the
    /// surface.</para>
    /// </summary>
    internal sealed class HeaveTank
    {
        private readonly int columns, rows, boxColumns, boxRows; // of the grid, in cells
        private readonly double h, gravity;
        private readonly int[] number; // of a node among the unknowns; −1: none
        private readonly BandedCholesky laplace;
        private readonly double[] unit; // Φ at the unknowns
        private readonly double[] response; // r at the surface's nodes [m]
        private readonly double[,] flow; // velocity of the surface [m/s] at one of its nodes by φ at another

        /// <summary>A tank; lengths in cells of the grid.</summary>
        /// <param name="halfLength">Half of the tank's length.</param>
        /// <param name="depth">Depth of the water at rest.</param>
        /// <param name="halfBeam">Half of the box's width, less than half of the length.</param>
        /// <param name="draught">Depth of the box's bottom at rest, less than the water's.</param>
        /// <param name="cell">Size of a cell [m].</param>
        /// <param name="gravity">g [m/s²].</param>
        public HeaveTank(int halfLength, int depth, int halfBeam, int draught, double cell, double gravity)
        {
            (columns, rows, boxColumns, boxRows, h) = (halfLength, depth, halfBeam, depth - draught, cell);
            this.gravity = gravity;
            number = new int[(columns + 1) * (rows + 1)];
            int unknowns = 0;
            for (int i = 0; i <= columns; i++)
                for (int j = 0; j <= rows; j++) number[Node(i, j)] = IsWater(i, j) && j < rows ? unknowns++ : -1;
            laplace = new BandedCholesky(unknowns, rows + 1);
            for (int i = 0; i <= columns; i++)
                for (int j = 0; j <= rows; j++) AddNode(i, j);
            laplace.Factor();

            unit = new double[unknowns];
            for (int i = 0; i <= boxColumns; i++) unit[number[Node(i, boxRows)]] = Bottom(i);
            laplace.Solve(unit);
            int surface = columns - boxColumns + 1;
            response = new double[surface];
            flow = new double[surface, surface];
            var potential = new double[unknowns];
            for (int s = 0; s < surface; s++)
            {
                response[s] = Sum(s, (next, g) => g * unit[next]);
                Array.Clear(potential, 0, unknowns);
                Sum(s, (next, g) => potential[next] = g);
                laplace.Solve(potential);
                for (int to = 0; to < surface; to++) flow[to, s] -= Sum(to, (next, g) => g * potential[next]) / Width(to);
                AddSurface(s);
            }
        }

        /// <summary>Added mass of half of the box over ρ, φ = 0 on the surface: of fast motion [m²].</summary>
        public double AddedArea
        {
            get
            {
                double sum = 0.0;
                for (int i = 0; i <= boxColumns; i++) sum += Bottom(i) * unit[number[Node(i, boxRows)]];
                return sum;
            }
        }

        /// <summary>
        /// The box is released from a height above where it floats at rest, in water at rest whose level is flat beside it.
        /// </summary>
        /// <param name="height">ζ at the start [m].</param>
        /// <param name="duration">Time that is followed [s].</param>
        /// <param name="interval">Time between samples [s].</param>
        /// <returns>ζ [m] at equal intervals, the first at zero.</returns>
        public IReadOnlyList<double> Release(double height, double duration, double interval)
        {
            int surface = response.Length;
            var state = new double[2 * surface + 2]; // η, φ, ζ, V
            // The box has drawn its share of the water down.
            for (int s = 0; s < surface; s++) state[s] = -height * boxColumns / (columns - boxColumns);
            state[2 * surface] = height;
            // The grid's fastest wave has ω² ≤ 3 g/h.
            int parts = Math.Max(1, (int)Math.Ceiling(interval * Math.Sqrt(3.0 * gravity / h)));
            var samples = new List<double> { height };
            for (int k = 1; (k - 0.5) * interval < duration; k++)
            {
                for (int part = 0; part < parts; part++) state = Step(state, interval / parts);
                samples.Add(state[2 * surface]);
            }
            return samples;
        }

        private int Node(int i, int j) => i * (rows + 1) + j;

        // Nodes of the box's bottom and side are water, those within it are not.
        private bool IsWater(int i, int j) => j <= boxRows || i >= boxColumns;

        // Length of the box's bottom that belongs to a node [m].
        private double Bottom(int i) => i == 0 || i == boxColumns ? 0.5 * h : h;

        // Length of the surface that belongs to one of its nodes [m].
        private double Width(int s) => s == 0 || s == response.Length - 1 ? 0.5 * h : h;

        // Whether the cell right of and above a node is water.
        private bool IsCell(int i, int j) => i >= 0 && j >= 0 && i < columns && j < rows && (j < boxRows || i >= boxColumns);

        // Length of the face between a node and its neighbour to the right or above over their distance: half for each cell beside it.
        private double Right(int i, int j) => (IsCell(i, j) ? 0.5 : 0.0) + (IsCell(i, j - 1) ? 0.5 : 0.0);

        private double Above(int i, int j) => (IsCell(i, j) ? 0.5 : 0.0) + (IsCell(i - 1, j) ? 0.5 : 0.0);

        private void AddNode(int i, int j)
        {
            if (!IsWater(i, j)) return;
            int at = number[Node(i, j)];
            Couple(at, i < columns ? number[Node(i + 1, j)] : -1, Right(i, j));
            Couple(at, j < rows ? number[Node(i, j + 1)] : -1, Above(i, j));
        }

        // A surface's node, whose φ is given, is no unknown: only the other's own coefficient knows of it.
        private void Couple(int a, int b, double g)
        {
            if (g == 0.0) return;
            if (a >= 0) laplace.Add(a, a, g);
            if (b >= 0) laplace.Add(b, b, g);
            if (a >= 0 && b >= 0) laplace.Add(Math.Max(a, b), Math.Min(a, b), -g);
        }

        // Over the unknown neighbours of a surface's node.
        private double Sum(int s, Func<int, double, double> term)
        {
            int i = boxColumns + s;
            return term(number[Node(i, rows - 1)], Above(i, rows - 1));
        }

        // Flow along the surface between its own nodes, and out of each into its neighbours below.
        private void AddSurface(int s)
        {
            int i = boxColumns + s;
            flow[s, s] += Above(i, rows - 1) / Width(s);
            if (s + 1 == response.Length) return;
            double g = Right(i, rows);
            flow[s, s] += g / Width(s);
            flow[s, s + 1] -= g / Width(s);
            flow[s + 1, s + 1] += g / Width(s + 1);
            flow[s + 1, s] -= g / Width(s + 1);
        }

        private double[] Step(double[] y, double dt)
        {
            double[] a = Rate(y), b = Rate(Plus(y, a, 0.5 * dt)), c = Rate(Plus(y, b, 0.5 * dt)), d = Rate(Plus(y, c, dt));
            var result = new double[y.Length];
            for (int i = 0; i < y.Length; i++) result[i] = y[i] + dt / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
            return result;
        }

        private static double[] Plus(double[] y, double[] rate, double dt)
        {
            var result = new double[y.Length];
            for (int i = 0; i < y.Length; i++) result[i] = y[i] + dt * rate[i];
            return result;
        }

        private double[] Rate(double[] y)
        {
            int surface = response.Length;
            var rate = new double[y.Length];
            double zeta = y[2 * surface], speed = y[2 * surface + 1];
            double beam = boxColumns * h, draught = (rows - boxRows) * h;
            double force = -gravity * beam * zeta;
            for (int s = 0; s < surface; s++)
            {
                double velocity = -response[s] * speed / Width(s);
                for (int from = 0; from < surface; from++) velocity += flow[s, from] * y[surface + from];
                rate[s] = velocity;
                rate[surface + s] = -gravity * y[s];
                force += gravity * response[s] * y[s];
            }
            rate[2 * surface] = speed;
            rate[2 * surface + 1] = force / (beam * draught + AddedArea);
            return rate;
        }
    }
}
