using NUnit.Framework;
using Headless.Vulkan;

namespace Headless.Tests.Vulkan;

/// <summary>What is submitted at once is bounded, so that no driver takes it for a hang.</summary>
public sealed class SubmissionTests : DeviceFixture
{
    // 65,535 groups of 64 threads, of which 64 in all have something to do: 24 such dispatches are a submission's 100 million threads.
    [TestCase(23, 1)]
    [TestCase(24, 2)]
    [TestCase(48, 3)]
    public void ASubmissionEndsWithTheDispatchThatMakesItsWorkTooMuch(int dispatches, int submissions)
    {
        using GpuBuffer buffer = StorageBuffer(256);
        Assert.That(Submissions(() =>
        {
            for (int i = 0; i < dispatches; i++)
            {
                Recorder.Dispatch(Device.GetComputePipeline(Kernels.Fill), Kernels.Bind(64, 1, buffer), 65535, 1, 1);
            }

            Recorder.FillBuffer(buffer, 0, 4, 0);
        }), Is.EqualTo(submissions));
    }

    [TestCase(4000, 1)]
    [TestCase(4001, 2)]
    public void ASubmissionHasSoManyCommandsAndNoMore(int commands, int submissions)
    {
        using GpuBuffer buffer = StorageBuffer(256);
        Assert.That(Submissions(() =>
        {
            for (int i = 0; i < commands; i++)
            {
                Recorder.FillBuffer(buffer, 0, 4, 0);
            }
        }), Is.EqualTo(submissions));
    }

    private int Submissions(Action record)
    {
        Device.WaitIdle();
        ulong before = Recorder.Submit();
        record();
        return (int)(Recorder.Submit() - before);
    }
}
