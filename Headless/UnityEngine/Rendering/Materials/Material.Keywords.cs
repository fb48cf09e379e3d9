using System.Linq;
using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public partial class Material
{
    public string[] shaderKeywords
    {
        get => [.. Keywords.Enabled];
        set => Keywords.Replace(value ?? []);
    }

    public LocalKeyword[] enabledKeywords
    {
        get
        {
            LocalKeywordSpace space = shader.keywordSpace;
            return [.. Keywords.Enabled.Where(space.Declares).Select(k => new LocalKeyword(space, k))];
        }
        set => Keywords.Replace((value ?? []).Select(k => k.name));
    }

    internal KeywordState Keywords { get; } = new();

    public void EnableKeyword(string keyword) => Keywords.Change(keyword, true);

    public void EnableKeyword(in LocalKeyword keyword) => Keywords.Change(keyword.name, true);

    public void DisableKeyword(string keyword) => Keywords.Change(keyword, false);

    public void DisableKeyword(in LocalKeyword keyword) => Keywords.Change(keyword.name, false);

    public void SetKeyword(in LocalKeyword keyword, bool value) => Keywords.Change(keyword.name, value);

    public bool IsKeywordEnabled(string keyword) => Keywords.IsEnabled(keyword);

    public bool IsKeywordEnabled(in LocalKeyword keyword) => Keywords.IsEnabled(keyword.name);
}
