namespace Unity.Jobs;

public static class IJobExtensions
{
    public static JobHandle Schedule<T>(this T jobData, JobHandle dependsOn = default) where T : struct, IJob => JobRunner.Start(jobData.Execute, dependsOn);
    public static void Run<T>(this T jobData) where T : struct, IJob => jobData.Execute();
}
