using System.Collections.Concurrent;
using UnityEngine;

namespace Unity.Jobs;

/// <summary>Runs jobs on the thread pool, parallel ones in batches on all cores. A delegate of a struct's method holds a copy of the struct, as a scheduled job does.</summary>
internal static class JobRunner
{
    private static readonly ConcurrentQueue<Exception> exceptions = new();

    public static JobHandle Start(Action body, JobHandle dependsOn)
    {
        // What depends on a job that threw runs nevertheless, as in Unity.
        Action guarded = () =>
        {
            try
            {
                body();
            }
            catch (Exception exception)
            {
                exceptions.Enqueue(exception is AggregateException { InnerException: { } inner } ? inner : exception);
            }
        };
        Task? before = dependsOn.task;
        return new JobHandle(before is null or { IsCompleted: true } ? Task.Run(guarded) : before.ContinueWith(_ => guarded(), TaskScheduler.Default));
    }

    public static JobHandle StartParallel(Action<int> execute, int length, int batch, JobHandle dependsOn)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(length);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(batch);
        return Start(() => Parallel.For(0, (length + batch - 1) / batch, b =>
        {
            int end = Math.Min(length, (b + 1) * batch);
            for (int i = b * batch; i < end; i++) execute(i);
        }), dependsOn);
    }

    /// <summary>To the console, on the thread that waited.</summary>
    public static void LogExceptions()
    {
        while (exceptions.TryDequeue(out Exception? exception)) Debug.LogException(exception);
    }
}
