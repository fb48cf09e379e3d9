namespace Unity.Jobs;

/// <summary>A scheduled job. An exception in a job is logged when the job is completed, as Unity logs it; it is not rethrown.</summary>
public struct JobHandle : IEquatable<JobHandle>
{
    internal readonly Task? task;

    internal JobHandle(Task task) => this.task = task;

    public readonly bool IsCompleted => task is null || task.IsCompleted;

    public readonly void Complete()
    {
        task?.Wait();
        JobRunner.LogExceptions();
    }

    public static JobHandle CombineDependencies(JobHandle job0, JobHandle job1) =>
        job0.task is null ? job1 : job1.task is null ? job0 : new JobHandle(Task.WhenAll(job0.task, job1.task));

    public static JobHandle CombineDependencies(JobHandle job0, JobHandle job1, JobHandle job2) =>
        CombineDependencies(CombineDependencies(job0, job1), job2);

    public static void CompleteAll(ref JobHandle job0, ref JobHandle job1)
    {
        job0.Complete();
        job1.Complete();
        job0 = job1 = default;
    }

    public static void ScheduleBatchedJobs() { }

    public readonly bool Equals(JobHandle other) => task == other.task;
    public override readonly bool Equals(object? obj) => obj is JobHandle other && Equals(other);
    public override readonly int GetHashCode() => task?.GetHashCode() ?? 0;
    public static bool operator ==(JobHandle a, JobHandle b) => a.Equals(b);
    public static bool operator !=(JobHandle a, JobHandle b) => !a.Equals(b);
}
