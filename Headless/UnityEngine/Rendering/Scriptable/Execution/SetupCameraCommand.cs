using UnityEngine;

namespace Headless.Engine;

/// <summary>SetupCameraProperties: a camera as it was when the command was recorded.</summary>
internal sealed class SetupCameraCommand(Camera camera) : GpuCommand
{
    private readonly CameraView view = CameraView.Of(camera);
    private readonly DrawTarget target = PipelineRunner.TargetOf(camera);
    private readonly Rect rect = camera.pixelRect;

    public override void Run(CommandContext context)
    {
        (context.Camera, context.CameraTarget) = (camera, target);
        TargetState.Set(target);
        if (rect.width != target.Width || rect.height != target.Height)
        {
            TargetState.SetViewport(rect);
        }

        CameraSettings.Apply(view);
        LightSettings.ApplyScene();
        ViewState.SetScreen(rect.width, rect.height);
    }
}
