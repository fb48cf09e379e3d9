using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>What the heights of a raster of columns say; columns that missed the mesh are left out.</summary>
    public readonly struct ColumnStatistics
    {
        private ColumnStatistics(double covered, double mean, double rms, double slope)
        {
            Covered = covered;
            Mean = mean;
            Rms = rms;
            Slope = slope;
        }

        /// <summary>Share of the columns that met the mesh.</summary>
        public double Covered { get; }

        /// <summary>Mean height [m].</summary>
        public double Mean { get; }

        /// <summary>Root mean square deviation from the mean [m].</summary>
        public double Rms { get; }

        /// <summary>Root mean square slope between neighbouring columns, both directions together [degrees].</summary>
        public double Slope { get; }

        /// <summary>Of the heights of a raster.</summary>
        /// <param name="heights">As <see cref="MeshColumns.Heights"/> gives them.</param>
        /// <param name="across">Columns along x.</param>
        /// <param name="spacing">Distance of the columns [m].</param>
        public static ColumnStatistics Of(double[] heights, int across, double spacing)
        {
            double sum = 0.0;
            int count = 0;
            foreach (double height in heights)
            {
                if (double.IsNaN(height)) continue;
                sum += height;
                count++;
            }
            double mean = sum / count;
            double squares = 0.0;
            foreach (double height in heights) squares += double.IsNaN(height) ? 0.0 : (height - mean) * (height - mean);
            double alongX = SquaredSlope(heights, across, 1, spacing), alongZ = SquaredSlope(heights, across, across, spacing);
            return new ColumnStatistics((double)count / heights.Length, mean, Math.Sqrt(squares / count), Math.Sqrt(alongX + alongZ));
        }

        /// <summary>
        /// Flicker: the root mean square second difference in time of the heights, h(t+1) − 2 h(t) + h(t−1), which steady motion does not
        /// raise. Steps between frames above a limit are left out: there something else came to lie on top.
        /// </summary>
        /// <param name="frames">Heights of frames that follow each other at equal times.</param>
        /// <param name="largestStep">Limit [m].</param>
        /// <returns>Flicker [m]; not a number with fewer than three frames.</returns>
        public static double Flicker(IReadOnlyList<double[]> frames, double largestStep)
        {
            double squares = 0.0;
            long count = 0;
            for (int frame = 1; frame + 1 < frames.Count; frame++)
            {
                for (int i = 0; i < frames[frame].Length; i++)
                {
                    double before = frames[frame][i] - frames[frame - 1][i], after = frames[frame + 1][i] - frames[frame][i];
                    if (!(Math.Abs(before) < largestStep && Math.Abs(after) < largestStep)) continue;
                    squares += (after - before) * (after - before);
                    count++;
                }
            }
            return Math.Sqrt(squares / count);
        }

        private static double SquaredSlope(double[] heights, int across, int step, double spacing)
        {
            double squares = 0.0;
            int count = 0;
            for (int i = 0; i + step < heights.Length; i++)
            {
                double rise = heights[i + step] - heights[i];
                if (double.IsNaN(rise) || step == 1 && i % across == across - 1) continue;
                double degrees = Math.Atan(rise / spacing) * 180.0 / Math.PI;
                squares += degrees * degrees;
                count++;
            }
            return count > 0 ? squares / count : double.NaN;
        }
    }
}
