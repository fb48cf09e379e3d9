using System.Reflection;
using Headless.Engine;
using Headless.Importers;
using Headless.Shaders;
using NUnit.Framework;
using UnityEngine.SceneManagement;

namespace Headless.Tests.Importers;

/// <summary>A project of a test's own whose one scene is played; its scripts are this assembly's.</summary>
[NonParallelizable]
public abstract class SceneFixture
{
    protected const string Start = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";

    protected List<string> Reports { get; } = [];

    internal TemporaryProject Project { get; private set; } = null!;

    [SetUp]
    public void MakeProject()
    {
        EngineState.Reset();
        Reports.Clear();
        Project = new TemporaryProject();
    }

    [TearDown]
    public void EndPlay()
    {
        PlaySession.End();
        EngineState.Reset();
        Project.Dispose();
    }

    protected static Assembly? FindAssembly(string name) => name switch
    {
        "Assembly-CSharp" => Assembly.GetExecutingAssembly(),
        _ when name.StartsWith("Unity.RenderPipelines.", StringComparison.Ordinal) => Assembly.Load(name),
        _ => null,
    };

    protected Scene PlayScene(string documents)
    {
        Project.Add("Assets/Main.unity", Start + documents);
        UnityProject.Open(Project.Root, FindAssembly, new IncludeResolver(Project.Root), Reports.Add);
        PlaySession.Begin("Assets/Main.unity");
        return SceneManager.GetActiveScene();
    }
}
