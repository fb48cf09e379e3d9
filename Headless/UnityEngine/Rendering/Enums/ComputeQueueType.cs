namespace UnityEngine.Rendering;

public enum ComputeQueueType
{
    Default = 0,
    Background = 1,
    Urgent = 2,
}
