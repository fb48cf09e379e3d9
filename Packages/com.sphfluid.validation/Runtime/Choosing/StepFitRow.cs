using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A line of step-fits.csv: what a step of a method costs on the device, by number of particles and κ.</summary>
    public sealed class StepFitRow
    {
        private const double Micro = 1e3; // µs of a millisecond

        /// <summary>The file.</summary>
        public static readonly TableFormat<StepFitRow> Format = new TableFormat<StepFitRow>("step-fits.csv")
            .Text("method", r => r.method.Name)
            .Number("step_ms", r => r.cost.Coefficients[0])
            .Number("step_ms_error", r => r.cost.Errors[0])
            .Number("particle_us", r => Micro * r.cost.Coefficients[1])
            .Number("particle_us_error", r => Micro * r.cost.Errors[1])
            .Number("particle_us_per_kappa3", r => Micro * r.cost.Coefficients[2])
            .Number("particle_us_per_kappa3_error", r => Micro * r.cost.Errors[2])
            .Number("exchange_us", r => Micro * r.cost.Coefficients[3])
            .Number("exchange_us_error", r => Micro * r.cost.Errors[3])
            .Number("deviation", r => r.cost.Deviation)
            .Count("least_particles", r => r.cost.LeastParticles)
            .Count("most_particles", r => r.cost.MostParticles)
            .Text("device", r => r.chart.Device)
            .Text("date", r => r.chart.Date);

        private readonly ChartData chart;
        private readonly CaseMethod method;
        private readonly StepCostModel cost;

        private StepFitRow(ChartData chart, CaseMethod method)
        {
            this.chart = chart;
            this.method = method;
            cost = chart.CostOf(method);
        }

        /// <summary>The lines of a chart.</summary>
        internal static IEnumerable<StepFitRow> Of(ChartData chart) =>
            CaseMethod.All.Where(m => !m.IsReference && chart.CostOf(m) != null).Select(m => new StepFitRow(chart, m));
    }
}
