using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Editor;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>The inspector's error class is what the committed chart says.</summary>
    public sealed class ErrorClassTests
    {
        [TestCase(FluidMethodKind.Standard, "standard")]
        [TestCase(FluidMethodKind.Robust, "robust")]
        public void TheTableIsThatOfItsChart(FluidMethodKind kind, string method)
        {
            string folder = Path.Combine(Path.GetDirectoryName(UnityEngine.Application.dataPath), ErrorClass.Chart);
            if (!Directory.Exists(folder)) Assert.Ignore($"{ErrorClass.Chart} is in the repository alone.");
            IReadOnlyList<DepthClasses> measured = DepthClasses.Of(ChartData.Read(folder), CaseMethod.Find(method), ErrorClass.Limits);
            string[] expected = measured.Select(m => Line(m.SupportRatio, m.Coarsest, m.Finest, m.Depths)).ToArray();

            Assert.That(ErrorClass.Table.Where(r => r.Method == kind).Select(r => Line(r.SupportRatio, r.Coarsest, r.Finest, r.Depths)),
                Is.EqualTo(expected));
        }

        private static string Line(double ratio, int coarsest, int finest, IEnumerable<int> depths) =>
            System.FormattableString.Invariant($"{ratio}: {coarsest} to {finest}; {string.Join(", ", depths)}");
    }
}
