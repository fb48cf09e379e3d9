using NUnit.Framework;
using SphFluid.Validation.Editor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The Editor's window asks as the command line does.</summary>
    public sealed class ChooseWindowTests
    {
        [Test]
        public void TheFirstQuestionIsAnsweredOrTheChartIsMissed()
        {
            var window = ScriptableObject.CreateInstance<ChooseWindow>();
            try
            {
                window.Answer();

                Assert.That(window.Lines, Is.Not.Empty);
                // A device without a chart is told how to measure one; else the case and what was measured are named.
                string all = string.Join(" ", window.Lines);
                Assert.That(all.Contains("Oscillating ellipsoid") || all.Contains("./run chart"), Is.True, all);
            }
            finally
            {
                Object.DestroyImmediate(window);
            }
        }
    }
}
