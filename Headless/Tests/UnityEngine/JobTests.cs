using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

/// <summary>Jobs run each index once, after what they depend on, on a copy of the scheduled struct.</summary>
public sealed class JobTests
{
    private struct Fill : IJobParallelFor
    {
        public NativeArray<int> Values;
        public int Offset;
        public void Execute(int index) => Values[index] += index + Offset;
    }

    private struct Sum : IJob
    {
        public NativeArray<int> Values;
        public NativeArray<long> Total;

        public void Execute()
        {
            long total = 0;
            foreach (int value in Values) total += value;
            Total[0] = total;
        }
    }

    private struct Throwing : IJob
    {
        public readonly void Execute() => throw new InvalidOperationException("job");
    }

    [TestCase(0, 1)]
    [TestCase(1, 64)]
    [TestCase(1009, 32)]
    public void ParallelJobServesEachIndexOnceBeforeItsDependant(int length, int batch)
    {
        using var values = new NativeArray<int>(Math.Max(1, length), Allocator.Persistent);
        using var total = new NativeArray<long>(1, Allocator.Persistent);
        var fill = new Fill { Values = values, Offset = 1 };
        JobHandle filled = fill.Schedule(length, batch);
        fill.Offset = 1000;
        JobHandle handle = new Sum { Values = values, Total = total }.Schedule(filled);
        handle.Complete();
        Assert.That(handle.IsCompleted && filled.IsCompleted);
        Assert.That(total[0], Is.EqualTo((long)length * (length + 1) / 2));
    }

    [Test]
    public void ExceptionIsNotRethrownAndDependantsRun()
    {
        using var values = new NativeArray<int>(3, Allocator.Persistent);
        bool enabled = Debug.unityLogger.logEnabled;
        Debug.unityLogger.logEnabled = false;
        try
        {
            JobHandle thrown = new Throwing().Schedule();
            Assert.That(() => new Fill { Values = values, Offset = 5 }.Schedule(3, 1, thrown).Complete(), Throws.Nothing);
        }
        finally
        {
            Debug.unityLogger.logEnabled = enabled;
        }
        Assert.That(values.ToArray(), Is.EqualTo(new[] { 5, 6, 7 }));
    }
}
