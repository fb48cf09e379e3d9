using System.Globalization;
using System.Text;
using Headless.Shaders;

namespace Headless.Vulkan;

/// <summary>A text that is equal for descriptions of equal content.</summary>
internal static class RenderPipelineKey
{
    public static string Of(RenderPipelineDescription d)
    {
        StringBuilder key = new(256);
        foreach (ShaderBinary stage in d.Stages)
        {
            key.Append(stage.Stage).Append(' ').Append(stage.Hash).Append(' ').Append(stage.EntryPoint).Append('|');
        }

        key.Append(CultureInfo.InvariantCulture, $"{d.Topology} {d.DepthFormat} {d.Samples} {d.Cull} {d.FrontClockwise} {d.DepthCompare} {d.DepthWrite} ");
        key.Append(CultureInfo.InvariantCulture, $"{d.DepthClip} {d.DepthBiasSlope:R} {d.DepthBiasUnits:R} {d.AlphaToCoverage} {d.Wireframe}");
        key.Append("|colors ").AppendJoin(',', d.ColorFormats);
        key.Append("|streams ").AppendJoin(',', d.Streams.Select(s => $"{s.Slot}:{s.Stride}:{s.PerInstance}"));
        key.Append("|attributes ").AppendJoin(',', d.Attributes.Select(a => $"{a.Location}:{a.Format}:{a.Offset}:{a.Slot}"));
        foreach (BlendState b in d.Blend)
        {
            key.Append('|').Append(b.SourceColor).Append(b.TargetColor).Append(b.ColorOperation);
            key.Append(b.SourceAlpha).Append(b.TargetAlpha).Append(b.AlphaOperation).Append((int)b.WriteMask);
        }

        return key.ToString();
    }

    public static string NameOf(RenderPipelineDescription d) =>
        d.Name.Length > 0 ? d.Name : string.Join('+', d.Stages.Select(stage => stage.EntryPoint));
}
