namespace Headless.Shaders;

/// <summary>Reads render state commands of SubShaders and passes.</summary>
internal static class RenderStateParser
{
    /// <summary>The state with one command applied; null when the next word is no such command.</summary>
    /// <param name="unsupported">Set by commands that are understood but not supported.</param>
    public static RenderState? TryRead(ShaderLabReader reader, RenderState state, ref UnsupportedFeature? unsupported)
    {
        int line = reader.Peek.Line;
        switch (reader.Peek.Text.ToUpperInvariant())
        {
            case "CULL":
                return state with { Cull = Command(reader, RenderStateNames.Cull) };
            case "ZWRITE":
                return state with { ZWrite = Command(reader, RenderStateNames.OnOff) };
            case "ZTEST":
                return state with { ZTest = Command(reader, RenderStateNames.Compare) };
            case "ZCLIP":
                return state with { ZClip = Command(reader, RenderStateNames.OnOff) };
            case "ALPHATOMASK":
                return state with { AlphaToMask = Command(reader, RenderStateNames.OnOff) };
            case "OFFSET":
                reader.Next();
                RenderStateValue factor = Number(reader);
                reader.Expect(",");
                return state with { OffsetFactor = factor, OffsetUnits = Number(reader) };
            case "COLORMASK":
                reader.Next();
                return state with { ColorMask = Mask(reader) };
            case "BLEND":
                return Blend(reader, state);
            case "BLENDOP":
                reader.Next();
                RenderStateValue color = Value(reader, RenderStateNames.Operation);
                RenderStateValue alpha = reader.TryTake(",") ? Value(reader, RenderStateNames.Operation) : color;
                return state with { BlendOpColor = color, BlendOpAlpha = alpha };
            case "STENCIL":
                reader.Next();
                reader.SkipBlock();
                unsupported ??= new UnsupportedFeature(line, "Stencil is not supported by the headless player");
                return state;
            case "CONSERVATIVE":
                if (Command(reader, RenderStateNames.OnOff).Value != 0)
                {
                    unsupported ??= new UnsupportedFeature(line, "conservative rasterisation is not supported by the headless player");
                }
                return state;
            case "LIGHTING":
                Command(reader, RenderStateNames.OnOff);
                return state;
            case "FOG":
                reader.Next();
                reader.SkipBlock();
                return state;
            default:
                return null;
        }
    }

    private static RenderStateValue Command(ShaderLabReader reader, Dictionary<string, float> names)
    {
        reader.Next();
        return Value(reader, names);
    }

    // Blend Off | Blend [target] source destination [, sourceAlpha destinationAlpha]
    private static RenderState Blend(ShaderLabReader reader, RenderState state)
    {
        int line = reader.Next().Line;
        if (ShaderLabReader.TryNumber(reader.Peek, out _))
        {
            throw reader.Error(line, "Blend with a render target index is not supported; blend all targets alike");
        }
        if (reader.TryTake("Off"))
        {
            return state with { Blend = false };
        }
        RenderStateValue source = Value(reader, RenderStateNames.Factor);
        RenderStateValue destination = Value(reader, RenderStateNames.Factor);
        RenderStateValue sourceAlpha = source;
        RenderStateValue destinationAlpha = destination;
        if (reader.TryTake(","))
        {
            sourceAlpha = Value(reader, RenderStateNames.Factor);
            destinationAlpha = Value(reader, RenderStateNames.Factor);
        }
        return state with
        {
            Blend = true,
            SourceColor = source,
            DestinationColor = destination,
            SourceAlpha = sourceAlpha,
            DestinationAlpha = destinationAlpha,
        };
    }

    private static RenderStateValue Mask(ShaderLabReader reader)
    {
        if (reader.Peek.Is("["))
        {
            return Property(reader, 15);
        }
        int line = reader.Peek.Line;
        string word = reader.Word("colour channels");
        if (ShaderLabReader.TryNumber(reader.Peek, out _))
        {
            throw reader.Error(line, "ColorMask with a render target index is not supported");
        }
        if (word == "0")
        {
            return 0;
        }
        int mask = 0;
        foreach (char channel in word)
        {
            mask |= char.ToUpperInvariant(channel) switch
            {
                'R' => 8,
                'G' => 4,
                'B' => 2,
                'A' => 1,
                _ => throw reader.Error(line, $"unknown ColorMask '{word}'"),
            };
        }
        return mask;
    }

    private static RenderStateValue Number(ShaderLabReader reader) =>
        reader.Peek.Is("[") ? Property(reader, 0) : reader.Number();

    private static RenderStateValue Value(ShaderLabReader reader, Dictionary<string, float> names)
    {
        if (reader.Peek.Is("["))
        {
            return Property(reader, names.Values.First());
        }
        ShaderLabToken token = reader.Next();
        return names.TryGetValue(token.Text, out float value)
            ? value
            : throw reader.Error(token.Line, $"unknown value '{token.Text}'; expected {string.Join(", ", names.Keys)}");
    }

    private static RenderStateValue Property(ShaderLabReader reader, float fallback)
    {
        reader.Expect("[");
        string name = reader.Word("a property name");
        reader.Expect("]");
        return new RenderStateValue(fallback, name);
    }
}
