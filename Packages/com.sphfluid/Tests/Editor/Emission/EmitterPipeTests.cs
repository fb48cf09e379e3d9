using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The wall of a pipe: closed, with room for what is born in it.</summary>
    public sealed class EmitterPipeTests
    {
        private const float Spacing = 0.02f, Reach = 0.045f;

        private static EmitterSpec Emitter(FluidEmitterShape shape, float x, float y) =>
            new EmitterSpec { State = new EmitterState(), Shape = shape, Size = new Vector2(x, y), Amount = 1f, UnderWater = true };

        [TestCase(FluidEmitterShape.Rectangle, 0.08f, 0.08f)]
        [TestCase(FluidEmitterShape.Rectangle, 0.09f, 0.03f)]
        [TestCase(FluidEmitterShape.Rectangle, 0.001f, 0.001f)]
        [TestCase(FluidEmitterShape.Disc, 0.1f, 0.1f)]
        [TestCase(FluidEmitterShape.Disc, 0.2f, 0.07f)]
        [TestCase(FluidEmitterShape.Line, 0.15f, 1f)]
        public void IsClosedAndHoldsALayerAwayFromItsWall(FluidEmitterShape shape, float x, float y)
        {
            EmitterSpec emitter = Emitter(shape, x, y);
            EmitterPipe pipe = EmitterPipe.Create(emitter, Spacing, Reach);
            Assert.That(pipe.Mesh.IsClosed);
            Assert.That(pipe.Length, Is.EqualTo(Reach + 0.25f * Spacing).Within(1e-6f));
            foreach (Vector2 place in EmitterSites.For(emitter, Spacing).Places)
                for (float z = 0f; z <= pipe.Length; z += 0.25f * Spacing)
                {
                    Assert.That(pipe.Mesh.Covers(new Vector3(place.x, place.y, z), 0.49f * Spacing), Is.False, $"{place} at {z}");
                }
            float wide = 0.5f * Mathf.Max(pipe.Mesh.Bounds.size.x, pipe.Mesh.Bounds.size.y);
            Assert.That(pipe.Mesh.Covers(new Vector3(0f, 0f, -Spacing), 0f), "behind the nozzle is wall");
            Assert.That(pipe.Mesh.Covers(new Vector3(pipe.Mesh.Bounds.max.x - 0.5f * Spacing, 0f, 0.5f * Reach), 0f), "and beside it");
            Assert.That(pipe.Mesh.Covers(new Vector3(wide + 0.1f * Spacing, wide + 0.1f * Spacing, 0f), 0f), Is.False);
        }

        [Test]
        public void IsMadeOnceForASize()
        {
            EmitterSpec emitter = Emitter(FluidEmitterShape.Disc, 0.1f, 0.1f);
            EmitterPipe pipe = EmitterPipe.Create(emitter, Spacing, Reach);
            Assert.That(EmitterPipe.Create(emitter, Spacing, Reach), Is.SameAs(pipe));
            emitter.Size = new Vector2(0.1f, 0.12f);
            Assert.That(EmitterPipe.Create(emitter, Spacing, Reach), Is.Not.SameAs(pipe));
        }
    }
}
