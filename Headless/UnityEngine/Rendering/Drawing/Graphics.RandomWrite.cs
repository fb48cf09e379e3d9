using Headless.Engine;

namespace UnityEngine;

public partial class Graphics
{
    public static void SetRandomWriteTarget(int index, RenderTexture uav) => RandomWriteTargets.Set(index, uav);

    public static void SetRandomWriteTarget(int index, ComputeBuffer uav) => SetRandomWriteTarget(index, uav, false);

    public static void SetRandomWriteTarget(int index, ComputeBuffer uav, bool preserveCounterValue) =>
        RandomWriteTargets.Set(index, uav.Storage, preserveCounterValue);

    public static void SetRandomWriteTarget(int index, GraphicsBuffer uav) => SetRandomWriteTarget(index, uav, false);

    public static void SetRandomWriteTarget(int index, GraphicsBuffer uav, bool preserveCounterValue) =>
        RandomWriteTargets.Set(index, uav.Storage, preserveCounterValue);

    public static void ClearRandomWriteTargets() => RandomWriteTargets.Clear();
}
