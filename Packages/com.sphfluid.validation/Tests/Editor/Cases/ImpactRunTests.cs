using System.Collections.Generic;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Small runs on the GPU: what the thesis method gives, with a margin for another device's rounding.</summary>
    public sealed class ImpactRunTests
    {
        [Test]
        public void TheThesisColumnFalls()
        {
            var damBreak = new DamBreakCase();
            CaseParameters parameters = ImpactCaseTests.Parameters(damBreak, "thesis", 8, 0.01);

            CaseResult result = WallCaseRig.Run(damBreak, parameters, SurfaceTestScene.LoadShaders(), out CaseMetric metric);

            Assert.That(result.Failure, Is.Null);
            Assert.That(result.Errors[0].Value, Is.InRange(0.02, 0.06));
            Assert.That(WallCaseStates.Named(metric, damBreak.CompanionErrorName), Is.InRange(0.06, 0.13));
            Assert.That(WallCaseStates.Named(metric, "height, largest error"), Is.InRange(0.07, 0.18));
            Assert.That(WallCaseStates.Named(metric, "height beside the wall's film, largest error"), Is.InRange(0.03, 0.1));
        }

        [Test]
        public void ThePrintedColumnHardlyFalls()
        {
            var damBreak = new DamBreakCase();
            CaseParameters parameters = ImpactCaseTests.Parameters(damBreak, "thesis-printed", 6, 0.01);

            CaseResult result = WallCaseRig.Run(damBreak, parameters, SurfaceTestScene.LoadShaders(), out _);

            Assert.That(result.Failure, Does.StartWith("dam-break: the front's shift in T").And.Contain("bound 0.5"));
        }

        [Test]
        [Explicit("For longer than CaseRunTests, which holds liquid off an obstacle too.")]
        public void MarinsWaterGoesRoundTheBox()
        {
            var marin = new MarinCase();
            CaseParameters parameters = ImpactCaseTests.Parameters(marin, "thesis", 5, 0.01);
            CaseSetup setup = marin.Build(parameters);
            setup.Duration *= 0.5; // before the wave comes back; StandardCaseRunTests has the heights
            var metric = new BoxWatch(setup);

            Assert.That(WallCaseRig.Run(marin.Name, setup, metric, SurfaceTestScene.LoadShaders()).Failure, Is.Null);
            Assert.That(metric.Near, Is.GreaterThan(100));
            Assert.That(metric.Inside, Is.LessThan(0.01 * metric.Near));
        }

        // Counts particles over all samples: nearer to the box than a spacing, and in it.
        private sealed class BoxWatch : CaseMetric
        {
            private readonly Bounds box, near;

            public BoxWatch(CaseSetup setup)
            {
                box = new Bounds(setup.Obstacles[0][0], Vector3.zero);
                foreach (Vector3 corner in setup.Obstacles[0]) box.Encapsulate(corner);
                near = new Bounds(box.center, box.size + 2f * setup.Settings.Spacing * Vector3.one);
                box.Expand(-0.2f * setup.Settings.Spacing);
            }

            public int Near { get; private set; }

            public int Inside { get; private set; }

            public override void Sample(double time, FluidSnapshot state)
            {
                foreach (Vector3 position in state.LocalPositions)
                {
                    Near += near.Contains(position) ? 1 : 0;
                    Inside += box.Contains(position) ? 1 : 0;
                }
            }

            public override IReadOnlyList<CaseError> Evaluate() =>
                new[] { new CaseError("samples in the box", Inside), new CaseError("samples near it", Near) };
        }
    }
}
