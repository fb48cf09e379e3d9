using Headless.Checks.Documents;
using Headless.Checks.Form;
using NUnit.Framework;

namespace Headless.Tests.Checks;

/// <summary>Faults that only a real Editor or a player build would show.</summary>
public sealed class EditorFormTests
{
    private const string ShaderGuid = "0123456789abcdef0123456789abcdef";
    private const string OnLoad = "static class A { [UnityEngine.RuntimeInitializeOnLoadMethod] static void Register() { } }";

    private TemporaryPackage package = null!;

    [SetUp]
    public void MakePackage() => package = new TemporaryPackage();

    [TearDown]
    public void RemovePackage() => package.Dispose();

    [Test]
    public void AnAssemblyReachedByAttributeAloneIsFound()
    {
        package.Write("Runtime/A.cs", OnLoad);

        Assert.That(Stripping(), Has.One.Contains("A is reached by [RuntimeInitializeOnLoadMethod] alone"));
    }

    [TestCase("using UnityEngine.Scripting;\n[assembly: AlwaysLinkAssembly]")]
    [TestCase("[assembly: UnityEngine.Scripting.AlwaysLinkAssemblyAttribute]")]
    [TestCase("class InScenes : MonoBehaviour { }")]
    public void AnAssemblyThatIsLinkedOrInScenesPasses(string other)
    {
        package.Write("Runtime/A.cs", OnLoad).Write("Runtime/B.cs", other);

        Assert.That(Stripping(), Is.Empty);
    }

    [Test]
    public void AnInspectorForOneObjectIsFound()
    {
        package.Write("Runtime/A.cs", "[CustomEditor(typeof(X))] class One : Editor { } [CustomEditor(typeof(X)), CanEditMultipleObjects] class Many : Editor { }");

        Assert.That(new InspectorCheck(package.Packages).Run().Findings, Is.EqualTo(new[] { "A.cs: One has no [CanEditMultipleObjects]" }));
    }

    [TestCase("get { if (target == null) TryGetComponent(out target); return target; }", TestName = "a getter that hands the field over as out")]
    [TestCase("get => target ??= Find();", TestName = "a getter that assigns where null")]
    [TestCase("get { this.target = null; return null; }", TestName = "a getter that assigns by this")]
    [TestCase("get { target.Count++; return target; }", TestName = "a getter that changes a part")]
    public void AGetterThatAssignsASerialisedFieldIsFound(string getter)
    {
        package.Write("Runtime/A.cs", $"class A : MonoBehaviour {{ [SerializeField] T target; public T Target {{ {getter} }} }}");

        Assert.That(new GetterCheck(package.Packages).Run().Findings, Is.EqualTo(new[] { "A.cs: the getter of A.Target assigns the serialised field 'target'" }));
    }

    [Test]
    public void AGetterThatKeepsItsFindApartPasses()
    {
        package.Write("Runtime/A.cs", """
            class A : MonoBehaviour
            {
                [SerializeField] T target;
                T found;
                public T Target { get { if (target != null) return target; TryGetComponent(out found); return found; } set => target = value; }
                public T Same => target;
                public A New => new A { target = found };
                public static A Made { get { var made = new A(); made.target = null; return made; } }
            }
            """);

        Assert.That(new GetterCheck(package.Packages).Run().Findings, Is.Empty);
    }

    [TestCase("static int count;", "count")]
    [TestCase("static int count; [Hook] static void Reset() { if (count > 0) other = 1; } static int other;", "count")]
    [TestCase("static int count; static void Reset() => count = 0;", "count")]
    [TestCase("static readonly List<int> all = new List<int>();", "all")]
    [TestCase("static readonly List<int> all = new List<int>(); [Hook] static void Reset() => Debug.Log(all);", "all")]
    [TestCase("static System.Collections.Generic.Queue<int> Waiting { get; } = new System.Collections.Generic.Queue<int>();", "Waiting")]
    [TestCase("public static int Count { get; private set; }", "Count")]
    [TestCase("static event System.Action changed;", "changed")]
    [TestCase("#if UNITY_EDITOR\nstatic int count;\n#endif", "count")]
    public void AStaticThatChangesAndIsNotResetIsFound(string members, string name)
    {
        Assert.That(Statics(members), Is.EqualTo(new[]
        {
            $"A.cs: the static A.{name} changes and is not reset when play begins without a domain reload: reset it at SubsystemRegistration, or say by [OutlivesPlay] why it may stay",
        }));
    }

    [TestCase("static int count; [Hook] static void Reset() => count = 0;")]
    [TestCase("static int a, b; [Hook] static void Reset() => (a, b) = (0, 0);")]
    [TestCase("static readonly List<int> all = new List<int>(); [Hook] static void Reset() => Forget(); static void Forget() { all.Clear(); }")]
    [TestCase("static Camera[] found = new Camera[4]; [Hook] static void Reset() => System.Array.Clear(found, 0, found.Length);")]
    [TestCase("public static int Count { get; set; } } static class B { [Hook] static void Reset() => A.Count = 0;")]
    [TestCase("[Hook] static void Reset() => Parts<int>.Clear(); } static class Parts<T> { static readonly List<T> all = new List<T>(); public static void Clear() => all.Clear();")]
    [TestCase("[OutlivesPlay(\"it is only compared\")] static int count;")]
    [TestCase("const int Most = 4; static readonly int[] table = { 1 }; static readonly string name = \"\"; static readonly Rule rule = new Rule();")]
    [TestCase("int count; public static int Most => 4; static readonly IReadOnlyList<int> all = new List<int>();")]
    public void AStaticThatIsResetOrNeverChangesPasses(string members) => Assert.That(Statics(members), Is.Empty);

    [Test]
    public void AStaticThatIsResetIsNotSaidToStay() =>
        Assert.That(Statics("[OutlivesPlay(\"\")] static int count; [Hook] static void Reset() => count = 0;"), Has.One.Contains("A.count is reset when play begins, so [OutlivesPlay] is wrong"));

    private List<string> Statics(string members)
    {
        package.Write("Runtime/A.cs", $"static class A {{\n{members.Replace("[Hook]", "[RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]")}\n}}");
        return new StaticStateCheck(package.Packages).Run().Findings;
    }

    [TestCase("*GameObject > Fluid > Simulation*", "there is no menu 'GameObject > Fluid > Simulation'")]
    [TestCase("*Window > SPH Fluid > Bench*", "there is no menu 'Window > SPH Fluid > Bench'")]
    [TestCase("Choose *Add Component > SPH Fluid > Nothing*.", "there is no menu 'Add Component > SPH Fluid > Nothing'")]
    public void AMenuThatIsNotThereIsFound(string text, string expected)
    {
        WriteMenus();
        package.Write("README.md", text);

        Assert.That(Menus(), Has.One.Contains(expected));
    }

    [TestCase("*GameObject > Fluid > Fluid Simulation (Particles)*, then *GameObject > Fluid > Fluid Volume*.")]
    [TestCase("*Window > SPH Fluid*; `Window > SPH Fluid > Benchmark`; Assets > Create > SPH Fluid > Fluid Profile.")]
    [TestCase("*Add Component > SPH Fluid > Fluid Volume*")]
    public void MenusThatAreTherePass(string text)
    {
        WriteMenus();
        package.Write("README.md", text);

        Assert.That(Menus(), Is.Empty);
    }

    [TestCase("fileID: 46, guid: 0000000000000000f000000000000000, type: 0", "its shader is not one of the packages'")]
    [TestCase("fileID: 4800000, guid: " + ShaderGuid + ", type: 3", "its shader has no SubShader for HDRenderPipeline")]
    public void AMaterialOfOnePipelineIsFound(string shader, string expected)
    {
        WriteShader("Tags { \"RenderPipeline\" = \"UniversalPipeline\" }", "");
        package.Write("Samples~/S/M.mat", $"  m_Shader: {{{shader}}}\n");

        Assert.That(Materials(), Has.One.Contains(expected));
    }

    [Test]
    public void AMaterialOfAllPipelinesPasses()
    {
        WriteShader("Tags { \"RenderPipeline\" = \"UniversalPipeline\" }", "Tags { \"RenderPipeline\" = \"HDRenderPipeline\" }", "");
        package.Write("Samples~/S/M.mat", $"  m_Shader: {{fileID: 4800000, guid: {ShaderGuid}, type: 3}}\n");

        Assert.That(Materials(), Is.Empty);
    }

    [TestCase("Tags { \"PreviewType\" = \"Skybox\" }", true)]
    [TestCase("Tags { \"PreviewType\" = \"Plane\" }", false)]
    [TestCase("Tags { \"PreviewType\" = \"Skybox\" \"RenderPipeline\" = \"UniversalPipeline\" }", false)]
    public void ASkyboxNeedsOneSubShaderForAll(string tags, bool passes)
    {
        WriteShader(tags);
        package.Write("Samples~/S/M.mat", $"  m_Shader: {{fileID: 4800000, guid: {ShaderGuid}, type: 3}}\n");

        Assert.That(Materials(), passes ? Is.Empty : Is.Not.Empty);
    }

    [Test]
    public void ARendererWithABuiltInMaterialIsFound()
    {
        package.Write("Samples~/S/S.unity", "  m_Materials:\n  - {fileID: 10303, guid: 0000000000000000f000000000000000, type: 0}\n  m_StaticBatchInfo:\n");

        Assert.That(Materials(), Has.One.Contains("S.unity: a renderer uses a material of the Built-in pipeline"));
    }

    [TestCase(0, "{fileID: 0}", 7, 1, "its ambient light is the sky's")]
    [TestCase(1, "{fileID: 0}", 0, 1, "it has no sun")]
    [TestCase(1, "{fileID: 0}", 8, 1, "it has no sun")]
    [TestCase(1, "{fileID: 0}", 7, 2, "its sun is not a directional light")]
    public void ASceneWithoutLightOfItsOwnIsFound(int ambient, string data, int sun, int lightType, string expected)
    {
        package.Write("Samples~/S/S.unity", SceneText(ambient, data, sun, lightType));

        Assert.That(Lights(), Has.One.Contains(expected));
    }

    [TestCase(1, "{fileID: 0}")]
    [TestCase(0, "{fileID: 20201, guid: 0000000000000000f000000000000000, type: 0}")]
    public void ASceneWithColoursOrLightingDataPasses(int ambient, string data)
    {
        package.Write("Samples~/S/S.unity", SceneText(ambient, data, 7, 1));

        Assert.That(Lights(), Is.Empty);
    }

    [Test]
    public void MissingProjectSettingsAreFound()
    {
        package.Write("../../ProjectSettings/TagManager.asset", "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!5 &1\nTimeManager:\n  m_TimeScale: 1\n")
            .Write("../../ProjectSettings/TimeManager.asset", "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!5 &1\nTimeManager:\n  m_TimeScale: 1\n")
            .Write("../manifest.json", """{ "dependencies": { "com.unity.burst": "1.8.18" } }""")
            .Write("../packages-lock.json", """{ "dependencies": { "com.unity.burst": { "version": "1.8.4" } } }""");

        var findings = new ProjectSettingsCheck(package.Packages).Run().Findings;

        Assert.That(findings, Has.Some.Contains("TagManager.asset does not begin with an object '!u!78'"));
        Assert.That(findings, Has.None.Contains("TimeManager"));
        Assert.That(findings, Has.Some.Contains("QualitySettings.asset is missing"));
        Assert.That(findings, Has.Some.Contains("asks for com.unity.burst 1.8.18, packages-lock.json has 1.8.4"));
    }

    private static string SceneText(int ambient, string data, int sun, int lightType) =>
        $$"""
        --- !u!104 &2
        RenderSettings:
          m_AmbientMode: {{ambient}}
          m_Sun: {fileID: {{sun}}}
        --- !u!157 &3
        LightmapSettings:
          m_LightingDataAsset: {{data}}
        --- !u!108 &7
        Light:
          m_Enabled: 1
          m_Type: {{lightType}}
          m_Shadows:
            m_Type: 2
        --- !u!4 &8
        Transform:

        """.ReplaceLineEndings("\n");

    private void WriteShader(params string[] tags) => package
        .Write("Shaders/S.shader", "Shader \"S\" { " + string.Join(' ', tags.Select(t => $"SubShader {{ {t} Pass {{ HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\nENDHLSL\n}} }}")) + " }")
        .WriteMeta("Shaders/S.shader", ShaderGuid);

    private void WriteMenus() => package.Write("Runtime/A.cs", """
        [AddComponentMenu("SPH Fluid/Fluid Volume")] class V : MonoBehaviour { }
        [CreateAssetMenu(fileName = "P", menuName = "SPH Fluid/Fluid Profile")] class P : ScriptableObject { }
        class M
        {
            const string Root = "GameObject/Fluid/";
            [MenuItem(Root + "Fluid Simulation (Particles)", false, 1)] static void A() { }
            [MenuItem(Root + "Fluid Volume")] static void B() { }
            [MenuItem("Window/SPH Fluid/Benchmark/Thesis Tables")] static void C() { }
        }
        """);

    private List<string> Stripping() => new StrippingCheck(package.Packages).Run().Findings;
    private List<string> Menus() => new MenuPathCheck(package.Packages).Run().Findings;
    private List<string> Materials() => new MaterialCheck(package.Packages).Run().Findings;
    private List<string> Lights() => new SceneLightCheck(package.Packages).Run().Findings;
}
