namespace Headless.Shaders;

/// <summary>Reads a .shader file from its tokens.</summary>
internal sealed class ShaderLabParser(string path, ShaderLabReader reader, IncludeResolver includes)
{
    private const long MostExpanded = 64L << 20;

    private readonly List<ShaderLabToken> _shaderIncludes = [];
    private readonly List<SubShader> _subShaders = [];
    private IReadOnlyList<ShaderProperty> _properties = [];
    private string _name = "";
    private string _fallback = "";
    private long _expanded;

    public ShaderLabSource Read()
    {
        reader.Expect("Shader");
        _name = reader.Text("the shader's name in quotes");
        reader.Expect("{");
        while (!reader.TryTake("}"))
        {
            ShaderCommand();
        }
        if (reader.Peek.Kind != ShaderLabTokenKind.End)
        {
            throw reader.Unexpected("the end of the file");
        }
        return new ShaderLabSource
        {
            Path = reader.File,
            Name = _name,
            Properties = _properties,
            SubShaders = _subShaders,
            Fallback = _fallback,
        };
    }

    private void ShaderCommand()
    {
        if (TakeIncludeBlock(_shaderIncludes))
        {
            return;
        }
        switch (reader.Peek.Text.ToUpperInvariant())
        {
            case "PROPERTIES":
                reader.Next();
                _properties = PropertyBlockParser.Read(reader);
                break;
            case "SUBSHADER":
                reader.Next();
                if (SubShader() is { } subShader)
                {
                    _subShaders.Add(subShader);
                }
                break;
            case "FALLBACK":
                reader.Next();
                if (!reader.TryTake("Off"))
                {
                    _fallback = reader.Text("the name of a shader in quotes, or Off");
                }
                break;
            case "CUSTOMEDITOR":
                reader.Next();
                reader.Text("a class name in quotes");
                break;
            case "CUSTOMEDITORFORRENDERPIPELINE":
                reader.Next();
                reader.Text("a class name in quotes");
                reader.Text("a render pipeline in quotes");
                break;
            case "DEPENDENCY":
                reader.Next();
                reader.Text("a name in quotes");
                reader.Expect("=");
                reader.Text("a shader name in quotes");
                break;
            default:
                throw reader.Unexpected("Properties, SubShader, Fallback, HLSLINCLUDE or CustomEditor");
        }
    }

    /// <summary>Null when its package requirements are not met.</summary>
    private SubShader? SubShader()
    {
        reader.Expect("{");
        List<ShaderLabToken> includeBlocks = [.. _shaderIncludes];
        Dictionary<string, string> tags = new(StringComparer.OrdinalIgnoreCase);
        List<ShaderPass> passes = [];
        RenderState state = new();
        UnsupportedFeature? unsupported = null;
        int lod = 0;
        bool met = true;
        while (!reader.TryTake("}"))
        {
            if (TakeIncludeBlock(includeBlocks))
            {
                continue;
            }
            if (reader.Peek.Kind == ShaderLabTokenKind.Program)
            {
                passes.Add(ProgramOutsidePass(state, includeBlocks));
                continue;
            }
            switch (reader.Peek.Text.ToUpperInvariant())
            {
                case "TAGS":
                    reader.Next();
                    ReadTags(tags);
                    break;
                case "LOD":
                    reader.Next();
                    lod = reader.Integer();
                    break;
                case "PACKAGEREQUIREMENTS":
                    reader.Next();
                    met &= RequirementsMet();
                    break;
                case "PASS":
                    reader.Next();
                    if (Pass(state, includeBlocks, unsupported) is { } pass)
                    {
                        passes.Add(pass);
                    }
                    break;
                case "USEPASS":
                    throw reader.Error(reader.Peek.Line, "UsePass is not supported; copy the pass into this shader");
                case "GRABPASS":
                    throw reader.Error(reader.Peek.Line, "GrabPass is not supported");
                default:
                    state = RenderStateParser.TryRead(reader, state, ref unsupported)
                        ?? throw reader.Unexpected("Pass, Tags, LOD or a render state command");
                    break;
            }
        }
        return met ? new SubShader(tags, lod, passes) : null;
    }

    // Only surface shaders stand there; using one is an error.
    private ShaderPass ProgramOutsidePass(RenderState state, List<ShaderLabToken> includeBlocks)
    {
        UnsupportedFeature? unsupported = null;
        ShaderLabToken token = reader.Next();
        ShaderProgram program = Program(token, includeBlocks, ref unsupported);
        unsupported ??= new UnsupportedFeature(token.Line, "a program outside of a pass is no surface shader");
        return new ShaderPass(_name, "", new Dictionary<string, string>(), state, program) { Unsupported = unsupported };
    }

    /// <summary>Null when its package requirements are not met.</summary>
    private ShaderPass? Pass(RenderState state, List<ShaderLabToken> outerIncludes, UnsupportedFeature? unsupported)
    {
        int line = reader.Peek.Line;
        reader.Expect("{");
        List<ShaderLabToken> includeBlocks = [.. outerIncludes];
        Dictionary<string, string> tags = new(StringComparer.OrdinalIgnoreCase);
        ShaderLabToken? program = null;
        string name = "";
        bool met = true;
        while (!reader.TryTake("}"))
        {
            if (TakeIncludeBlock(includeBlocks))
            {
                continue;
            }
            if (reader.Peek.Kind == ShaderLabTokenKind.Program)
            {
                if (program is not null)
                {
                    throw reader.Error(reader.Peek.Line, "a pass has more than one program");
                }
                program = reader.Next();
                continue;
            }
            switch (reader.Peek.Text.ToUpperInvariant())
            {
                case "NAME":
                    reader.Next();
                    name = reader.Text("the pass's name in quotes");
                    break;
                case "TAGS":
                    reader.Next();
                    ReadTags(tags);
                    break;
                case "PACKAGEREQUIREMENTS":
                    reader.Next();
                    met &= RequirementsMet();
                    break;
                case "LOD":
                    reader.Next();
                    reader.Integer();
                    break;
                default:
                    state = RenderStateParser.TryRead(reader, state, ref unsupported)
                        ?? throw reader.Unexpected("Name, Tags, a render state command or HLSLPROGRAM");
                    break;
            }
        }
        if (!met)
        {
            return null;
        }
        if (program is null)
        {
            throw reader.Error(line, "a pass without HLSLPROGRAM or CGPROGRAM (fixed function) is not supported");
        }
        ShaderProgram read = Program(program, includeBlocks, ref unsupported);
        return new ShaderPass(_name, name, tags, state, read) { Unsupported = unsupported };
    }

    private ShaderProgram Program(ShaderLabToken token, List<ShaderLabToken> includeBlocks, ref UnsupportedFeature? unsupported)
    {
        ShaderProgram program = ProgramReader.Read(path, token, includeBlocks, includes, ref unsupported);
        _expanded += program.Source.Length;
        return _expanded <= MostExpanded
            ? program
            : throw reader.Error(token.Line, $"the passes come to more than {MostExpanded >> 20} million characters with their includes; divide the shader");
    }

    private bool TakeIncludeBlock(List<ShaderLabToken> blocks)
    {
        if (reader.Peek.Kind != ShaderLabTokenKind.Program || reader.Peek.Keyword is not ("HLSLINCLUDE" or "CGINCLUDE"))
        {
            return false;
        }
        blocks.Add(reader.Next());
        return true;
    }

    private void ReadTags(Dictionary<string, string> tags)
    {
        reader.Expect("{");
        while (!reader.TryTake("}"))
        {
            string key = reader.Text("a tag in quotes");
            reader.Expect("=");
            tags[key] = reader.Text("the tag's value in quotes");
        }
    }

    // PackageRequirements { "unity": "2022.3" "com.unity.render-pipelines.universal": "[14.0,15.0)" "com.example" }
    private bool RequirementsMet()
    {
        bool met = true;
        reader.Expect("{");
        while (!reader.TryTake("}"))
        {
            string package = reader.Text("a package name in quotes");
            string version = reader.TryTake(":") ? reader.Text("a version in quotes") : "";
            met &= PackageVersions.Met(includes.Packages, package, version);
            reader.TryTake(",");
        }
        return met;
    }
}
