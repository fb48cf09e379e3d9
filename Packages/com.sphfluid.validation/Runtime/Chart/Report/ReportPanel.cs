using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A panel of the report: the measured points of one error, and what else is drawn beside them.</summary>
    internal sealed class ReportPanel
    {
        private readonly HashSet<string> front;

        /// <param name="panel">The points.</param>
        public ReportPanel(ChartPanel panel)
        {
            Panel = panel;
            front = new HashSet<string>(ParetoFront.Of(panel.Points).Select(p => p.Key));
        }

        /// <summary>The points.</summary>
        public ChartPanel Panel { get; }

        /// <summary>Curves of models; empty where there are none.</summary>
        public List<ReportFit> Fits { get; } = new List<ReportFit>();

        /// <summary>Places that are no measured points; empty where there are none.</summary>
        public List<ReportMark> Marks { get; } = new List<ReportMark>();

        /// <summary>Whether no other point beats it in both time and error.</summary>
        public bool IsOnFront(ChartPoint point) => front.Contains(point.Key);
    }
}
