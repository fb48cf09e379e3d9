using System;
using System.Linq;
using UnityEngine;

namespace Headless.Engine;

/// <summary>
/// Draws into both slices of a stereo camera's target. A pass with the keyword has its instances doubled, but for those that a buffer counts;
/// another is drawn once for each eye.
/// </summary>
internal static class LayeredDraws
{
    private const string Keyword = "STEREO_INSTANCING_ON";

    public static bool AreOn => EyeViews.Camera is not null && TargetState.Current is { IsLayered: true };

    public static bool Knows(PassProgram pass) => pass.KeywordNames.Contains(Keyword);

    /// <param name="draw">Draws the pass with that many copies of each instance.</param>
    public static void Draw(PassProgram pass, Action<int> draw)
    {
        if (!Knows(pass))
        {
            EachEye(() => draw(1));
            return;
        }

        GlobalKeywords.Set(Keyword, true);
        draw(2);
        GlobalKeywords.Set(Keyword, false);
    }

    /// <summary>Draws into one slice and then into the other, with the matrices of one eye.</summary>
    public static void EachEye(Action draw)
    {
        DrawTarget whole = TargetState.Current!;
        PropertySheet sheet = GlobalProperties.Sheet;
        Vector4 place = sheet.GetVector(BuiltinNames.WorldSpaceCameraPos);
        (Matrix4x4 view, Matrix4x4 projection) = (ViewState.View, ViewState.Projection);
        for (int eye = 0; eye < 2; eye++)
        {
            TargetState.Set(whole.Layer(eye));
            CameraView seen = EyeViews.Of(eye);
            sheet.SetVector(BuiltinNames.WorldSpaceCameraPos, seen.Position);
            ViewState.Set(seen.View, seen.Projection);
            draw();
        }

        TargetState.Set(whole);
        sheet.SetVector(BuiltinNames.WorldSpaceCameraPos, place);
        ViewState.Set(view, projection);
    }
}
