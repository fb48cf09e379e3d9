using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// The iso value at which the surface of a perfect lattice pool lies half a spacing above its last layer, on
    /// average over sub-cell positions of the grid: volumes then come out right. Lengths are in particle spacings.
    /// Values are computed once and kept.
    /// </summary>
    internal static class SurfaceIsoCalibration
    {
        /// <summary>Least edge of a cell over dx.</summary>
        internal const double LeastCell = 0.02;

        // Positions of the pool against the grid: along z they divide a cell evenly; across, any incommensurate ones
        // serve.
        private const int Phases = 6;
        private const double PhaseX = 0.137 * 1.3, PhaseY = 0.731;

        // Columns of samples whose heights are averaged: a square of 8 spacings, but no more columns than is quick.
        private const double ColumnsFrom = 6.0, ColumnsTo = 14.0;
        private const int MostColumns = 24;

        // Layers of the pool, deep enough that the lowest do not matter, and halvings of the interval from 0 to 1.
        private const int Layers = 10;
        private const int Halvings = 26;

        // Depth below the last layer down to which the surface is searched.
        private const double DeepestTop = 1.5;

        // Keys are rounded so that sizes that differ in the last bits share a value.
        private const double KeySteps = 4096.0;

        [OutlivesPlay("values follow from their keys")]
        private static readonly Dictionary<(long, long, long, int, long, bool), float> Known =
            new Dictionary<(long, long, long, int, long, bool), float>();

        /// <summary>The iso value of a smooth field.</summary>
        /// <param name="supportRatio">R/dx of the field's kernel, 1 to 64.</param>
        /// <param name="cellRatio">Edge of a cell over dx, 0.02 to 64.</param>
        /// <param name="smoothing">λ, 0 to 1.</param>
        /// <param name="filterPasses">Passes of the filter, 0 to 16.</param>
        /// <param name="unionOffset">δ, −1 to 1.</param>
        /// <param name="anisotropic">Whether kernels are stretched along the surface.</param>
        /// <returns>The value.</returns>
        /// <exception cref="ArgumentException">A number is out of range.</exception>
        public static float IsoValue(double supportRatio, double cellRatio, double smoothing, int filterPasses,
            double unionOffset, bool anisotropic = false)
        {
            Require.Within(supportRatio, 1.0, 64.0, nameof(supportRatio));
            Require.Within(cellRatio, LeastCell, 64.0, nameof(cellRatio));
            Require.Within(smoothing, 0.0, 1.0, nameof(smoothing));
            Require.Within(filterPasses, 0.0, 16.0, nameof(filterPasses));
            Require.Within(unionOffset, -1.0, 1.0, nameof(unionOffset));
            var key = (Round(supportRatio), Round(cellRatio), Round(smoothing), filterPasses, Round(unionOffset),
                anisotropic);
            lock (Known)
            {
                if (!Known.TryGetValue(key, out float iso))
                {
                    var pool = new LatticePool(supportRatio, smoothing, Layers, anisotropic);
                    iso = (float)Compute(pool, cellRatio, filterPasses, unionOffset);
                    Known.Add(key, iso);
                }
                return iso;
            }
        }

        private static long Round(double value) => (long)Math.Round(value * KeySteps);

        private static double Compute(LatticePool pool, double cell, int filterPasses, double unionOffset)
        {
            var columns = new List<double[]>();
            var bottoms = new List<double>();
            for (int phase = 0; phase < Phases; phase++)
            {
                double x = 0.5 + PhaseX * phase * cell, y = 0.5 + PhaseY * phase * cell;
                double z = 0.5 + cell * (phase + 0.5) / Phases;
                AddColumns(pool, cell, filterPasses, unionOffset, x, y, z, columns, bottoms);
            }

            double low = 0.0, high = 1.0;
            for (int i = 0; i < Halvings; i++)
            {
                double middle = 0.5 * (low + high);
                if (MeanHeight(columns, bottoms, cell, middle) > 0.5) low = middle;
                else high = middle;
            }

            return 0.5 * (low + high);
        }

        // Field values of columns of samples from below the surface upwards; bottoms: height of each column's first
        // sample above the last layer.
        private static void AddColumns(LatticePool pool, double cell, int passes, double unionOffset, double shiftX,
            double shiftY, double shiftZ, List<double[]> columns, List<double> bottoms)
        {
            int firstX = (int)Math.Ceiling(ColumnsFrom / cell), firstY = firstX;
            int count = Math.Min((int)Math.Floor(ColumnsTo / cell) - firstX + 1, MostColumns);
            int firstZ = (int)Math.Ceiling((shiftZ - DeepestTop) / cell) - passes;
            int nx = count + 2 * passes, ny = nx;
            int nz = (int)Math.Ceiling((shiftZ + pool.Radius) / cell) + 1 + passes - firstZ;
            var raw = new double[nx, ny, nz];
            for (int x = 0; x < nx; x++)
            {
                for (int y = 0; y < ny; y++)
                {
                    for (int z = 0; z < nz; z++)
                    {
                        raw[x, y, z] = pool.At((firstX - passes + x) * cell - shiftX,
                            (firstY - passes + y) * cell - shiftY, (firstZ + z) * cell - shiftZ);
                    }
                }
            }

            double[,,] filtered = raw;
            for (int pass = 0; pass < passes; pass++) filtered = Filter(filtered);
            for (int x = passes; x < nx - passes; x++)
            {
                for (int y = passes; y < ny - passes; y++)
                {
                    var column = new double[nz];
                    for (int z = 0; z < nz; z++) column[z] = Math.Max(filtered[x, y, z], passes > 0 ? raw[x, y, z] - unionOffset : 0.0);
                    columns.Add(column);
                    bottoms.Add(firstZ * cell - shiftZ);
                }
            }
        }

        // 1 2 1 along each axis; the outermost values stay and are not used.
        private static double[,,] Filter(double[,,] source)
        {
            double[,,] result = (double[,,])source.Clone();
            for (int axis = 0; axis < 3; axis++)
            {
                double[,,] from = (double[,,])result.Clone();
                int dx = axis == 0 ? 1 : 0, dy = axis == 1 ? 1 : 0, dz = axis == 2 ? 1 : 0;
                for (int x = dx; x < from.GetLength(0) - dx; x++)
                {
                    for (int y = dy; y < from.GetLength(1) - dy; y++)
                    {
                        for (int z = dz; z < from.GetLength(2) - dz; z++)
                        {
                            double before = from[x - dx, y - dy, z - dz], after = from[x + dx, y + dy, z + dz];
                            result[x, y, z] = 0.25 * (before + 2.0 * from[x, y, z] + after);
                        }
                    }
                }
            }

            return result;
        }

        private static double MeanHeight(List<double[]> columns, List<double> bottoms, double cell, double iso)
        {
            double sum = 0.0;
            for (int i = 0; i < columns.Count; i++)
            {
                double[] column = columns[i];
                int z = column.Length - 2;
                while (z > 0 && column[z] <= iso) z--;
                sum += bottoms[i] + cell * (z + (column[z] - iso) / (column[z] - column[z + 1]));
            }

            return sum / columns.Count;
        }
    }

    /// <summary>
    /// The raw field of a pool of lattice layers at z = 0, −1, −2 …, endless across, its particles weighted, moved and
    /// stretched as Shaders/Surface/Sparse/PrepareSurfaceParticles.compute has it. Lengths in spacings.
    /// </summary>
    internal sealed class LatticePool
    {
        // SHAPE_RATIO in Shaders/Surface/Sparse/KernelShapes.hlsl.
        private const double ShapeRatio = 4.0;

        private readonly Layer[] layers;

        public LatticePool(double radius, double smoothing, int layerCount, bool anisotropic)
        {
            Radius = radius;
            layers = new Layer[layerCount];
            for (int i = 0; i < layerCount; i++) layers[i] = new Layer(radius, i, smoothing, anisotropic);
        }

        /// <summary>R of the kernel.</summary>
        public double Radius { get; }

        /// <summary>The field's value.</summary>
        public double At(double x, double y, double z)
        {
            double sum = 0.0;
            foreach (Layer layer in layers) sum += layer.At(x, y, z);
            return sum;
        }

        private readonly struct Layer
        {
            private readonly double weight, height, across, along; // across the surface, along it: radii of the kernel

            public Layer(double radius, int depth, double smoothing, bool anisotropic)
            {
                int reach = (int)Math.Ceiling(radius);
                double kernels = 0.0, sum = 0.0, moment = 0.0, squareX = 0.0, squareZ = 0.0;
                for (int z = -reach; z <= Math.Min(reach, depth); z++) // the layers above the last are missing
                {
                    for (int y = -reach; y <= reach; y++)
                    {
                        for (int x = -reach; x <= reach; x++)
                        {
                            double q2 = (x * x + y * y + z * z) / (radius * radius);
                            if (q2 >= 1.0) continue;
                            double w = 1.0 - q2 * Math.Sqrt(q2);
                            kernels += Math.Pow(1.0 - q2, 3.0);
                            sum += w;
                            moment += w * z;
                            squareX += w * x * x;
                            squareZ += w * z * z;
                        }
                    }
                }

                double mean = moment / sum;
                height = -depth + smoothing * Math.Max(-1.0, Math.Min(1.0, mean));
                weight = anisotropic ? WeightAtRest(radius) : 1.0 / kernels;
                across = along = radius;
                if (!anisotropic) return;
                double varianceX = squareX / sum, varianceZ = squareZ / sum - mean * mean;
                double least = Math.Max(varianceX, varianceZ) / ShapeRatio;
                varianceX = Math.Max(varianceX, least);
                varianceZ = Math.Max(varianceZ, least);
                double scale = radius * Math.Pow(varianceX * varianceX * varianceZ, -1.0 / 3.0);
                along = scale * varianceX;
                across = scale * varianceZ;
            }

            public double At(double x, double y, double z)
            {
                double dz = (z - height) / across, left = 1.0 - dz * dz, sum = 0.0;
                if (left <= 0.0) return 0.0;
                for (int j = (int)Math.Ceiling(y - along); j <= y + along; j++)
                {
                    for (int i = (int)Math.Ceiling(x - along); i <= x + along; i++)
                    {
                        double t = left - ((x - i) * (x - i) + (y - j) * (y - j)) / (along * along);
                        if (t > 0.0) sum += t * t * t;
                    }
                }

                return weight * sum;
            }

            // W(0) dx³ of poly6.
            private static double WeightAtRest(double radius) => 315.0 / (64.0 * Math.PI * radius * radius * radius);
        }
    }
}
