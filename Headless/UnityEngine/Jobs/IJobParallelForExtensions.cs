namespace Unity.Jobs;

public static class IJobParallelForExtensions
{
    public static JobHandle Schedule<T>(this T jobData, int arrayLength, int innerloopBatchCount, JobHandle dependsOn = default) where T : struct, IJobParallelFor =>
        JobRunner.StartParallel(jobData.Execute, arrayLength, innerloopBatchCount, dependsOn);

    public static void Run<T>(this T jobData, int arrayLength) where T : struct, IJobParallelFor
    {
        for (int i = 0; i < arrayLength; i++) jobData.Execute(i);
    }
}
