namespace Unity.Jobs;

public static class IJobForExtensions
{
    public static JobHandle Schedule<T>(this T jobData, int arrayLength, JobHandle dependency) where T : struct, IJobFor =>
        JobRunner.Start(() => Run(jobData, arrayLength), dependency);

    public static JobHandle ScheduleParallel<T>(this T jobData, int arrayLength, int innerloopBatchCount, JobHandle dependency) where T : struct, IJobFor =>
        JobRunner.StartParallel(jobData.Execute, arrayLength, innerloopBatchCount, dependency);

    public static void Run<T>(this T jobData, int arrayLength) where T : struct, IJobFor
    {
        for (int i = 0; i < arrayLength; i++) jobData.Execute(i);
    }
}
