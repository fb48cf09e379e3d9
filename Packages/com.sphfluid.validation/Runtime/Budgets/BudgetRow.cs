using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A line of budgets.csv: a liquid that was played by one way, and how far its motion was from the reference's.</summary>
    internal sealed class BudgetRow : MeasuredRow
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<BudgetRow> Format = new TableFormat<BudgetRow>("budgets.csv")
            .Text("way", r => r.Way.Name)
            .Number("budget_ms", r => r.Way.Budget)
            .Count("particles", r => r.Particles)
            .Number("spacing_m", r => r.Spacing)
            .Count("seed", r => r.Seed)
            .Text("method", r => r.Method)
            .Number("max_compression", r => r.MaxCompression)
            .Count("substeps", r => r.Substeps)
            .Text("cost_source", r => r.CostSource)
            .Number("predicted_ms", r => r.Predicted)
            .Number("ms_a_frame", r => r.Milliseconds)
            .Number("ms_of_equal_runs", r => r.Cost)
            .Number("steps_a_frame", r => r.StepsAFrame)
            .Number("real_time_factor", r => r.RealTimeFactor)
            .Number("error_dx", r => r.Error)
            .Text("better_way", r => r.BetterWay)
            .Text("device", r => r.Device)
            .Text("date", r => r.Date);

        public BudgetWay Way;
        public long Particles;
        public double Spacing;
        public int Seed;

        /// <summary>The method in use.</summary>
        public string Method;

        /// <summary>Compression that it allows at the bottom of the liquid at rest.</summary>
        public double MaxCompression;

        /// <summary>Equal steps of a frame; 0 where steps are as long as they may be.</summary>
        public int Substeps;

        /// <summary>Where the predicted time comes from; empty where the method is given.</summary>
        public string CostSource = "";

        /// <summary>Time of a frame's steps as Automatic expected it, at most [ms].</summary>
        public double Predicted = double.NaN;

        /// <summary>Time of a frame's steps on the graphics device, mean of the last frames with steps [ms].</summary>
        public double Milliseconds;

        /// <summary>
        /// Time of a frame's steps of all runs with this method and these settings, their median [ms]: what a moment of a busy device does
        /// not move.
        /// </summary>
        public double Cost;

        /// <summary>Mean steps of a frame.</summary>
        public double StepsAFrame;

        /// <summary>Time of the liquid over time of the frames.</summary>
        public double RealTimeFactor;

        /// <summary>Root mean square over the frames of the distance of its centre of mass from the reference's, over dx.</summary>
        public double Error = double.NaN;

        /// <summary>A given way that took no longer and whose error is less beyond the scatter of the runs; empty: there is none.</summary>
        public string BetterWay = "";

        /// <summary>Centre of mass after each frame [m].</summary>
        public Vector3[] Path;
    }
}
