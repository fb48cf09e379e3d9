using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class DetailRuleTests
    {
        private static readonly List<FluidDetailLevel> Levels = new List<FluidDetailLevel>
        {
            new FluidDetailLevel { Distance = 10f }, new FluidDetailLevel { Distance = 20f }, new FluidDetailLevel { Distance = 40f },
        };

        [TestCase(0f, 0, 0)]
        [TestCase(9.99f, 0, 0)]
        [TestCase(10f, 0, 1)]
        [TestCase(25f, 0, 2)]
        [TestCase(1000f, 0, 3)]
        [TestCase(9.01f, 1, 1, TestName = "a tenth nearer the level stays")]
        [TestCase(8.99f, 1, 0)]
        [TestCase(18.01f, 2, 2)]
        [TestCase(17.99f, 2, 1)]
        [TestCase(9.5f, 3, 1, TestName = "two levels end, the third stays")]
        [TestCase(0f, 3, 0)]
        [TestCase(37f, 7, 3, TestName = "levels were taken away")]
        [TestCase(float.NaN, 0, 0)]
        public void ALevelBeginsAtItsDistanceAndEndsATenthNearer(float distance, int before, int expected) =>
            Assert.That(DetailRule.LevelFor(Levels, distance, before), Is.EqualTo(expected));

        [Test]
        public void WithoutLevelsThereIsAllDetail() =>
            Assert.That(DetailRule.LevelFor(new List<FluidDetailLevel>(), 1000f, 2), Is.Zero);

        [Test]
        public void ACameraThatMagnifiesIsNearer()
        {
            var holder = new GameObject("Camera");
            try
            {
                var camera = holder.AddComponent<Camera>();
                camera.fieldOfView = 60f;
                Assert.That(DetailRule.SeenFrom(camera, 12f), Is.EqualTo(12f).Within(1e-4f));
                camera.fieldOfView = 5f;
                Assert.That(DetailRule.SeenFrom(camera, 130f), Is.EqualTo(9.83f).Within(0.01f), "130 tan 2.5°/tan 30°");
                camera.orthographic = true;
                camera.orthographicSize = 5f;
                Assert.That(DetailRule.SeenFrom(camera, 130f), Is.EqualTo(8.66f).Within(0.01f), "5/tan 30°, however far");
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(holder);
            }
        }

        [TestCase(0.5f, 0f, 0f, 0f)]
        [TestCase(4f, 0f, 0f, 3f)]
        [TestCase(4f, 6f, 0f, 5f, TestName = "from an edge")]
        public void DistancesCountToTheBox(float x, float y, float z, float expected)
        {
            var place = new Vector3(100f, -3f, 7f);
            Quaternion turn = Quaternion.Euler(10f, 70f, 20f);
            Vector3 world = place + turn * new Vector3(x, y, z);
            Assert.That(DetailRule.ToBox(DomainSpace.FromWorld(place, turn), new Vector3(2f, 4f, 6f), world),
                Is.EqualTo(expected).Within(1e-4f));
        }

        [Test]
        public void NumbersThatCannotBeUsedAreNamedWithACure()
        {
            Assert.That(DetailRule.Problem(Levels, 1f, Vector3.zero), Is.Null);
            foreach ((string named, FluidDetailLevel second, float importance, Vector3 box) in new[]
            {
                ("Importance", Level(), 0f, Vector3.zero), ("Importance", Level(), float.NaN, Vector3.zero),
                ("Importance", Level(), float.PositiveInfinity, Vector3.zero),
                ("Size", Level(), 1f, new Vector3(1f, -1f, 1f)), ("Size", Level(), 1f, new Vector3(1f, float.NaN, 1f)),
                ("level 2", Level(distance: 10f), 1f, Vector3.zero), ("level 2", Level(distance: float.NaN), 1f, Vector3.zero),
                ("level 2", Level(distance: float.PositiveInfinity), 1f, Vector3.zero), ("Level 2", null, 1f, Vector3.zero),
                ("Step Factor", Level(step: 0f), 1f, Vector3.zero), ("Step Factor", Level(step: float.NaN), 1f, Vector3.zero),
                ("Cell Factor", Level(cell: 0.5f), 1f, Vector3.zero),
                ("Cell Factor", Level(cell: float.PositiveInfinity), 1f, Vector3.zero),
            })
            {
                var levels = new List<FluidDetailLevel> { Level(distance: 10f), second };
                (string text, string cure)? found = DetailRule.Problem(levels, importance, box);
                Assert.That(found, Is.Not.Null, named);
                Assert.That(found.Value.text + found.Value.cure, Does.Contain(named));
            }
            Assert.That(DetailRule.Problem(new List<FluidDetailLevel> { Level(distance: 0f) }, 1f, Vector3.zero), Is.Not.Null);
        }

        [Test]
        public void TheFactorGlidesBothWaysAndNoFrameIsTooLong()
        {
            var detail = new StepDetail();
            Assert.That(detail.Update(1.0, 0.1), Is.False);
            Assert.That(detail.Update(2.0, 0.02), Is.True);
            Assert.That(detail.Factor, Is.EqualTo(Math.Exp(0.01)).Within(1e-9));
            detail.Update(2.0, 100.0);
            Assert.That(detail.Factor, Is.EqualTo(Math.Exp(0.06)).Within(1e-9), "as of 0.1 s");
            for (int i = 0; i < 20; i++) detail.Update(2.0, 0.1);
            Assert.That(detail.Factor, Is.EqualTo(2.0));
            detail.Update(1.0, 0.1);
            Assert.That(detail.Factor, Is.EqualTo(2.0 * Math.Exp(-0.05)).Within(1e-9));
        }

        // Ratio 5 and 4 %: 2 times until 2.5 and 16 %. A profile at the bounds has nothing to give.
        [TestCase(5f, 0.04f, 1.5, 1.5)]
        [TestCase(5f, 0.04f, 3.0, 2.0)]
        [TestCase(5f, 0.01f, 3.0, 2.0)]
        [TestCase(20f, 0.04f, 3.0, 2.0)]
        [TestCase(3f, 0.12f, 2.0, 1.1547)]
        [TestCase(3f, 0.2f, 2.0, 1.0)]
        public void StandardIsSoftenedAsFarAsItsBounds(float ratio, float compression, double asked, double expected)
        {
            FluidRuleInput input = Input(FluidMethodKind.Standard);
            (input.SoundSpeedRatio, input.MaxCompression) = (ratio, compression);
            FluidMethod method = FluidMethods.Get(FluidMethodKind.Standard);
            double factor = method.CoarsestFactor(input, asked);
            Assert.That(factor, Is.EqualTo(expected).Within(1e-4));
            FluidSolverSettings before = FluidRules.Derive(input), after = FluidRules.Derive(method.Coarsen(input, factor));
            Assert.That(after.SoundSpeed * factor, Is.EqualTo(before.SoundSpeed).Within(1e-4 * before.SoundSpeed));
            Assert.That(after.ParticleMass, Is.EqualTo(before.ParticleMass));
        }

        [TestCase(4, 0.1f, 2.0, 2)]
        [TestCase(4, 0.1f, 1.9, 3)]
        [TestCase(4, 0.1f, 100.0, 2)]
        [TestCase(1, 0.1f, 2.0, 1)]
        [TestCase(8, 2.2f, 1.15, 7)]
        [TestCase(8, 2.2f, 2.0, 7, TestName = "with 6 substeps it would be pressed too much where it hits")]
        [TestCase(8, 30f, 2.0, 8, TestName = "weight asks for more iterations than fewer substeps save")]
        public void RobustTakesFewerSubstepsWhereThatPays(int substeps, float depth, double asked, int expected)
        {
            FluidRuleInput input = Input(FluidMethodKind.Robust);
            (input.Substeps, input.LiquidDepth, input.LiquidHeight) = (substeps, depth, depth);
            FluidMethod method = FluidMethods.Get(FluidMethodKind.Robust);
            double factor = method.CoarsestFactor(input, asked);
            Assert.That(method.Coarsen(input, factor).Substeps, Is.EqualTo(expected));
            Assert.That(method.Coarsen(input, Math.Sqrt(factor)).Substeps, Is.InRange(expected, substeps), "on the way");
            bool asAsked = expected == (int)Math.Ceiling(substeps / asked);
            Assert.That(method.CoarsestReason(input, asked, factor), asAsked ? Is.Null : Does.Contain($" {expected} are the fewest"));
        }

        [Test]
        public void OtherMethodsTakeStepsAsTheyAre()
        {
            foreach (FluidMethod method in FluidMethods.All.Where(m => !m.MayBePicked))
            {
                FluidRuleInput input = Input(method.Kind);
                Assert.That(method.CoarsestFactor(input, 2.0), Is.EqualTo(1.0));
                Assert.That(method.CoarsestReason(input, 2.0, 1.0), Does.Contain(method.Kind.ToString()));
            }
        }

        private static FluidRuleInput Input(FluidMethodKind method)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            (input.Method, input.DomainSize, input.Spacing) = (method, 4f * Vector3.one, 0.02f);
            (input.LiquidHeight, input.LiquidDepth) = (0.5f, 0.4f);
            return input;
        }

        private static FluidDetailLevel Level(float distance = 20f, float step = 1f, float cell = 1f) =>
            new FluidDetailLevel { Distance = distance, StepFactor = step, CellFactor = cell };
    }
}
