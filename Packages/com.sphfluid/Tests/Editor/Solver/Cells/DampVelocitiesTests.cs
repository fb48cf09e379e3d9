using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Every velocity keeps its part, every particle its id and place.</summary>
    public sealed class DampVelocitiesTests
    {
        [TestCase(1)]
        [TestCase(63)]
        [TestCase(64)]
        [TestCase(65)]
        [TestCase(1009)]
        public void EveryVelocityKeepsItsPart(int count)
        {
            FluidSolverSettings settings = BodyRig.Water(new Vector3(0.4f, 0.5f, 0.3f), 0.05f, 0.3f);
            FluidShaderSet shaders = TestShaders.CreateSet();
            using (var state = new StandardState(settings, count))
            {
                var velocities = Enumerable.Range(0, count).Select(i => new Vector4(i, -2f * i, 0.5f, 7f + i)).ToArray();
                state.Buffers.NewVelocities.SetData(velocities);
                GpuTest.Run(cmd => new DampVelocitiesPass(shaders).Record(cmd, state, 0.75f));
                Vector4[] after = GpuTest.Read<Vector4>(state.Buffers.NewVelocities, count);
                for (int i = 0; i < count; i++) Assert.That(after[i], Is.EqualTo(new Vector4(0.75f * i, -1.5f * i, 0.375f, 7f + i)));
            }
            Object.DestroyImmediate(shaders);
        }
    }
}
