using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>When and where an emitter's layers leave its nozzle.</summary>
    public sealed class EmitterRunTests
    {
        private const float Spacing = 0.02f;

        private static EmitterSpec Nozzle(FluidEmitterShape shape, float width, float height, float speed) => new EmitterSpec
        {
            State = new EmitterState { IsOn = true },
            Rotation = Quaternion.identity,
            Shape = shape,
            Size = new Vector2(width, height),
            Amount = speed,
        };

        private static FluidSpec Liquid() => new FluidSpec { Spacing = Spacing, Rotation = Quaternion.identity };

        // Rate n dx³ U / layer distance = A U: nothing is rounded away.
        [TestCase(FluidEmitterShape.Disc, 0.1f, 0.1f)]
        [TestCase(FluidEmitterShape.Disc, 0.013f, 0.013f)]
        [TestCase(FluidEmitterShape.Disc, 0.3f, 0.07f)]
        [TestCase(FluidEmitterShape.Rectangle, 0.1f, 0.06f)]
        [TestCase(FluidEmitterShape.Rectangle, 0.11f, 0.009f)]
        [TestCase(FluidEmitterShape.Line, 0.25f, 9f)]
        public void PlacesAndLayersCarryTheNozzlesArea(FluidEmitterShape shape, float width, float height)
        {
            EmitterSpec nozzle = Nozzle(shape, width, height, 1f);
            EmitterSites sites = EmitterSites.For(nozzle, Spacing);
            double area = shape == FluidEmitterShape.Disc ? Mathf.PI / 4f * width * height : shape == FluidEmitterShape.Line
                ? width * Spacing : width * height;
            Assert.That(sites.LayerDistance, Is.GreaterThanOrEqualTo(0.999 * Spacing));
            Assert.That(sites.Places.Length * System.Math.Pow(Spacing, 3) / sites.LayerDistance, Is.EqualTo(area).Within(1e-4).Percent);
            for (int i = 0; i < sites.Places.Length; i++)
            {
                Vector3 place = sites.Places[i];
                Assert.That(Mathf.Abs(place.x), Is.LessThanOrEqualTo(0.5f * width + 0.5f * Spacing),
                    "no place is farther out than half a spacing");
                if (shape != FluidEmitterShape.Line) Assert.That(Mathf.Abs(place.y), Is.LessThanOrEqualTo(0.5f * height + 0.5f * Spacing));
                for (int k = 0; k < i; k++) Assert.That((place - sites.Places[k]).magnitude, Is.GreaterThan(0.999f * Spacing));
            }
            if (shape == FluidEmitterShape.Rectangle && width == 0.1f)
            {
                Assert.That(sites.Places.Max(p => Mathf.Abs(p.x)), Is.EqualTo(0.04f).Within(1e-6f),
                    "a nozzle of 5 x 3 cells holds their centres");
            }
        }

        [Test]
        public void FramesDoNotSettleWhenLayersLeave([Values(1, 2, 3)] int seed)
        {
            var random = new System.Random(seed);
            FluidSpec liquid = Liquid();
            EmitterSpec nozzle = Nozzle(FluidEmitterShape.Rectangle, 0.04f, 0.02f, 1.7f);
            var run = new EmitterRun(3);
            var births = new BirthQueue(0u);
            double time = 0.0;
            while (time < 0.5)
            {
                double next = time + 0.04 * random.NextDouble() * random.NextDouble();
                run.Emit(nozzle, liquid, time, next, births, new ParticleLifetimes());
                time = next;
            }
            double period = EmitterSites.For(nozzle, Spacing).LayerDistance / 1.7;
            Assert.That(births.Waiting, Is.EqualTo(2 * (1 + (int)(time / period))));
            // At rest in free fall of none, a layer is where its time put it.
            births.CollectDue(time, 0f, Vector3.zero);
            for (int i = 0; i < births.Due.Length && i < 2 * (int)(time / period); i++)
            {
                Assert.That(births.Due[i].Position.z, Is.EqualTo(1.7 * (time - i / 2 * period)).Within(1e-5), $"layer {i / 2}");
            }
        }

        [Test]
        public void AFasterNozzleWaitsForTheLayerBefore()
        {
            FluidSpec liquid = Liquid();
            EmitterSpec nozzle = Nozzle(FluidEmitterShape.Rectangle, 0.02f, 0.02f, 1f);
            var run = new EmitterRun(3);
            var births = new BirthQueue(0u);
            run.Emit(nozzle, liquid, 0.0, 0.011, births, new ParticleLifetimes()); // one layer; the next at 0.02
            nozzle.Amount = 10f;
            run.Emit(nozzle, liquid, 0.011, 0.0199, births, new ParticleLifetimes());
            Assert.That(births.Waiting, Is.EqualTo(1), "the last layer has not gone a spacing yet");
            run.Emit(nozzle, liquid, 0.0199, 0.0239, births, new ParticleLifetimes());
            Assert.That(births.Waiting, Is.EqualTo(3), "at 0.02 and 0.022");
        }

        [Test]
        public void LiquidGetsTheNozzlesMotion()
        {
            FluidSpec liquid = Liquid();
            liquid.Rotation = Quaternion.Euler(0f, 90f, 0f);
            EmitterSpec nozzle = Nozzle(FluidEmitterShape.Rectangle, 0.02f, 0.02f, 1f);
            var run = new EmitterRun(3);
            var births = new BirthQueue(0u);
            nozzle.State.IsOn = false;
            run.Emit(nozzle, liquid, 0.0, 0.01, births, new ParticleLifetimes());
            nozzle.State.IsOn = true;
            nozzle.Position = new Vector3(0f, 0.03f, 0f);
            run.Emit(nozzle, liquid, 0.01, 0.01, births, new ParticleLifetimes()); // a frame without steps
            run.Emit(nozzle, liquid, 0.01, 0.02, births, new ParticleLifetimes());
            births.CollectDue(0.02, 0f, Vector3.zero);
            Vector3 expected = Quaternion.Inverse(liquid.Rotation) * new Vector3(0f, 3f, 1f);
            Assert.That((births.Due[0].Velocity - expected).magnitude, Is.LessThan(1e-5f), "3 m/s upwards");
        }

        [Test]
        public void TooWideANozzleIsRefused()
        {
            EmitterSpec nozzle = Nozzle(FluidEmitterShape.Disc, 100f, 100f, 1f);
            nozzle.Owner = new GameObject("Lake").transform;
            FluidMessage? wrong = EmitterChecks.Check(nozzle, Liquid());
            Object.DestroyImmediate(nozzle.Owner.gameObject);
            Assert.That(wrong?.Text, Does.Contain("particles a layer"));
        }
    }
}
