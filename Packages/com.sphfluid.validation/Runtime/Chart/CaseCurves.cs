using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The curves of a case that a chart's folder has: those of each method's run, and the references.</summary>
    internal sealed class CaseCurves
    {
        private readonly List<CaseSeries> references = new List<CaseSeries>(), bands = new List<CaseSeries>();
        private readonly List<Run> runs = new List<Run>();

        /// <summary>Reads them.</summary>
        /// <param name="validationCase">The case.</param>
        /// <param name="folder">The chart's folder.</param>
        public CaseCurves(ValidationCase validationCase, string folder)
        {
            for (int m = 0; m < CaseMethod.All.Count; m++)
            {
                IReadOnlyList<CaseSeries> curves =
                    CurveFile.Read(folder, validationCase.Name, CaseMethod.All[m].Name, out string constants);
                foreach (CaseSeries reference in curves.Where(c => c.IsReference)) Keep(reference.IsBand ? bands : references, reference);
                List<CaseSeries> measured = curves.Where(c => !c.IsReference).ToList();
                if (measured.Count > 0) runs.Add(new Run(m, constants, measured));
            }
        }

        /// <summary>The references, the longest of each name.</summary>
        public IReadOnlyList<CaseSeries> References => references;

        /// <summary>The band behind a reference; null for none.</summary>
        public CaseSeries BandOf(CaseSeries reference) => bands.Find(b => b.Name == reference.Name);

        /// <summary>The runs, one of each method that has curves.</summary>
        public IReadOnlyList<Run> Runs => runs;

        // A run that ends early has a reference that ends there too.
        private static void Keep(List<CaseSeries> kept, CaseSeries reference)
        {
            int known = kept.FindIndex(r => r.Name == reference.Name);
            if (known < 0)
                kept.Add(reference);
            else if (End(reference) > End(kept[known]))
                kept[known] = reference;
        }

        private static double End(CaseSeries curve) => curve.X.Count == 0 ? double.NegativeInfinity : curve.X.Max();

        /// <summary>The curves of a method's run.</summary>
        public sealed class Run
        {
            public Run(int method, string constants, IReadOnlyList<CaseSeries> curves)
            {
                Method = method;
                Constants = constants;
                Curves = curves;
            }

            /// <summary>Index in <see cref="CaseMethod.All"/>.</summary>
            public int Method { get; }

            /// <summary>The run's constants, for instance "dx 0.125 m, κ 2, dt 0.75, c 7.5".</summary>
            public string Constants { get; }

            /// <summary>Its curves.</summary>
            public IReadOnlyList<CaseSeries> Curves { get; }
        }
    }
}
