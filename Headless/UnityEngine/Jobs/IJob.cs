namespace Unity.Jobs;

public interface IJob
{
    void Execute();
}
