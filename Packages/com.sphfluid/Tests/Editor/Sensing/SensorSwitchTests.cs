using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>A crossing is told once, however the value trembles.</summary>
    public sealed class SensorSwitchTests
    {
        [Test]
        public void TheFirstValueOnlyTellsTheSide()
        {
            var above = new SensorSwitch();
            Assert.That(above.Update(0.9f, 0.5f, 0.2f), Is.Zero);
            Assert.That(above.IsAbove);
            var below = new SensorSwitch();
            Assert.That(below.Update(0.1f, 0.5f, 0.2f), Is.Zero);
            Assert.That(below.IsAbove, Is.False);
        }

        [Test]
        public void ACrossingIsToldOnceBeyondTheBand()
        {
            var state = new SensorSwitch();
            float[] values = { 0f, 0.55f, 0.59f, 0.61f, 0.7f, 0.45f, 0.41f, 0.65f, 0.39f, 0.55f, 0f, 1f };
            int[] told = { 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 1 };
            for (int i = 0; i < values.Length; i++) Assert.That(state.Update(values[i], 0.5f, 0.2f), Is.EqualTo(told[i]), $"value {i}");
        }

        [Test]
        public void WithoutHysteresisEachCrossingIsTold()
        {
            var state = new SensorSwitch();
            int told = 0;
            foreach (float value in new[] { 0f, 0.51f, 0.49f, 0.5f, 0.51f }) told += state.Update(value, 0.5f, -1f) != 0 ? 1 : 0;
            Assert.That(told, Is.EqualTo(3));
        }

        [Test]
        public void AResetForgetsTheSide()
        {
            var state = new SensorSwitch();
            state.Update(1f, 0.5f, 0f);
            state.Reset();
            Assert.That(state.IsAbove, Is.False);
            Assert.That(state.Update(0f, 0.5f, 0f), Is.Zero);
        }
    }
}
