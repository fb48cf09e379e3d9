using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Particles that move into larger buffers between a step and its sort.</summary>
    public sealed class GrowParticlesTests
    {
        [Test]
        public void WhatTheSortNeedsIsInTheNewBuffers([Values(1, 63, 64, 65, 257)] int count)
        {
            using (var rig = new StandardStateRig(StandardStateRig.Water(Vector3.one, 0.05f), count))
            {
                var random = new System.Random(count);
                Vector4[] Vectors() =>
                    Enumerable.Range(0, count).Select(_ => StandardStateRig.WithW(ParticleSets.RandomVector(random), random.Next()))
                        .ToArray();
                uint[] Numbers() => Enumerable.Range(0, count).Select(_ => (uint)random.Next()).ToArray();
                Vector4[] positions = Vectors(), velocities = Vectors();
                uint[] ranks = Numbers(), neighbours = Numbers();
                CellBuffers buffers = rig.State.Buffers;
                buffers.NewPositions.SetData(positions);
                buffers.NewVelocities.SetData(velocities);
                var table = Enumerable.Range(0, buffers.Rank.Begin).Select(i => 3u * (uint)i).ToArray();
                buffers.CellTable.SetData(table);
                buffers.Rank.SetData(ranks);
                rig.State.List.Counts.SetData(neighbours);
                var old = new CellRemains(rig.State);
                GpuTest.Run(cmd =>
                {
                    rig.State.Resize(3 * count);
                    new GrowParticlesPass(rig.Shaders).Record(cmd, rig.State, old, count);
                });

                Assert.That((rig.State.Capacity, rig.State.ParticleCount), Is.EqualTo((3 * count, count)));
                Assert.That((buffers.NewPositions.Count, buffers.Positions.Count), Is.EqualTo((3 * count + 3, 3 * count + 3)));
                Assert.That(GpuTest.Read<Vector4>(buffers.NewPositions, count), Is.EqualTo(positions));
                Assert.That(GpuTest.Read<Vector4>(buffers.NewVelocities, count), Is.EqualTo(velocities));
                Assert.That(GpuTest.Read<uint>(buffers.CellTable, table.Length), Is.EqualTo(table));
                Assert.That(buffers.Rank.Read<uint>(count), Is.EqualTo(ranks));
                Assert.That(rig.State.List.Counts.Read<uint>(count), Is.EqualTo(neighbours));
                long bytes = rig.State.Bytes;
                rig.State.Retired.Release(0);
                Assert.That(rig.State.Bytes, Is.EqualTo(bytes), "the old buffers are no part of the state");
            }
        }
    }
}
