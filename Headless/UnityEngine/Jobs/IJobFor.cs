namespace Unity.Jobs;

public interface IJobFor
{
    void Execute(int index);
}
