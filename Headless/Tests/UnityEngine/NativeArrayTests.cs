using System;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace Headless.Tests.UnityEngineApi;

public class NativeArrayTests
{
    [Test]
    public void IsClearedIndexedAndChecked()
    {
        var array = new NativeArray<int>(4, Allocator.Persistent);
        Assert.That(array.ToArray(), Is.EqualTo(new int[4]));
        array[2] = 5;
        Assert.That(array.AsReadOnlySpan()[2], Is.EqualTo(5));
        Assert.Throws<IndexOutOfRangeException>(() => _ = array[4]);
        NativeArray<int> copy = array;
        array.Dispose();
        Assert.That(array.IsCreated, Is.False);
        Assert.That(copy.IsCreated, Is.False);
        Assert.Throws<ObjectDisposedException>(() => copy[0] = 1);
    }

    [Test]
    public void ReinterpretsSlicesAndCopies()
    {
        using var array = new NativeArray<float>(new[] { 1f, 2f, 3f, 4f }, Allocator.Temp);
        NativeArray<UnityEngine.Vector2> pairs = array.Reinterpret<UnityEngine.Vector2>(sizeof(float));
        Assert.That(pairs[1], Is.EqualTo(new UnityEngine.Vector2(3f, 4f)));
        Assert.That(array.GetSubArray(1, 2).ToArray(), Is.EqualTo(new[] { 2f, 3f }));
        Assert.That(new NativeSlice<float>(array, 2).ToArray(), Is.EqualTo(new[] { 3f, 4f }));
        Assert.Throws<ArgumentException>(() => array.CopyTo(new float[3]));
        Assert.That(UnsafeUtility.SizeOf<UnityEngine.Vector3>(), Is.EqualTo(12));
    }
}
