using System.Reflection;

namespace Headless.Importers.Assets;

/// <summary>
/// Scripts of Unity's own packages, by the GUIDs that their .meta files give them: a project refers to them without having them. Those
/// whose class has no stand-in are left out.
/// </summary>
internal static class UnityScripts
{
    private const string Universal = "UnityEngine.Rendering.Universal.";
    private const string Core = "UnityEngine.Rendering.";

    private static readonly string[] assemblies = ["Unity.RenderPipelines.Universal.Runtime", "Unity.RenderPipelines.Core.Runtime"];

    private static readonly Dictionary<string, string> drawn = new()
    {
        ["bf2edee5c58d82540a51f03df9d42094"] = Universal + "UniversalRenderPipelineAsset",
        ["de640fe3d0db1804a85f9fc8f5cadab6"] = Universal + "UniversalRendererData",
        ["f971995892640ec4f807ef396269e91e"] = Universal + "ForwardRendererData",
        ["11145981673336645838492a2d98e247"] = Universal + "Renderer2DData",
        ["a79441f348de89743a2939f4d699eac1"] = Universal + "UniversalAdditionalCameraData",
        ["474bcb49853aa07438625e644c072ee6"] = Universal + "UniversalAdditionalLightData",
        ["6b3d386ba5cd94485973aee1479b272e"] = Universal + "RenderObjects",
        ["b00045f12942b46c698459096c89274e"] = Universal + "FullScreenPassRendererFeature",
        ["6d613f08f173d4dd895bb07b3230baa9"] = Universal + "FullScreenPassRendererFeature",
        ["f62c9c65cf3354c93be831c8bc075510"] = Universal + "ScreenSpaceAmbientOcclusion",
        ["e32e72b6a3f58a24c9033e2b9275eea0"] = Universal + "ScreenSpaceShadows",
        ["a1614fc811f8f184697d9bee70ab9fe5"] = Universal + "DecalRendererFeature",
        ["0777d029ed3dffa4692f417d4aba19ca"] = Universal + "DecalProjector",
        ["073797afb82c5a1438f328866b10b3f0"] = Universal + "Light2D",
        ["7db70e0ea77f5ac47a8f4565a9406397"] = Universal + "ShadowCaster2D",
        ["38f48a8d66b2adc46887f23a3a88ac01"] = Universal + "CompositeShadowCaster2D",
        ["c88f5cead0c0b2a4eb05b5900433f8d1"] = Universal + "PixelPerfectCamera",
        ["172515602e62fb746b5d573b38a5fe58"] = Core + "Volume",
        ["cc4d76f733087744991913c9d19d5274"] = Core + "LensFlareComponentSRP",
        ["618b0e3f6c65dd247a4a016150006c57"] = Core + "FreeCamera",
        ["f52d1e5345c395641b482217c8804ff9"] = Core + "CameraSwitcher",
        ["0cf1dab834d4ec34195b920ea7bbf9ec"] = Core + "HighDefinition.HDRenderPipelineAsset",
    };

    /// <summary>Those that change nothing by themselves: tools of the Editor, and what only a class above reads.</summary>
    private static readonly Dictionary<string, string> silent = new()
    {
        ["d0353a89b1f911e48b9e16bdc9f2e058"] = "UnityEditor.Rendering.Universal.AssetVersion",
        ["2ec995e51a6e251468d2a3fd8a686257"] = Universal + "UniversalRenderPipelineGlobalSettings",
        ["572910c10080c0945a0ef731ccedc739"] = Universal + "PostProcessData",
        ["7d07c5b68c1cfe64ca63f5d2bb80d2c5"] = "UnityEngine.LightAnchor",
        ["06c0317e0632e6c47bb855ee99f95544"] = Core + "SceneRenderPipeline",
        ["a55bb9f7efce64f3ab3a138447cb46c0"] = Core + "DisallowSmallMeshCulling",
        ["644debc0b7d33d043af3caab53baa000"] = Core + "DisallowGPUDrivenRendering",
        ["a83d2f7ae04ab6f4f99b0d85377be998"] = Core + "ProbeVolumePerSceneData",
        ["4881f9a2c4d568047b316028d20a8dca"] = Core + "ProbeVolumeBakingSet",
        ["877e1507ae8d81c40bf1b94c1a86036f"] = Core + "LensFlareDataSRP",
        ["d7fd9488000d3734a9e00ee676215985"] = Core + "VolumeProfile",
        ["0b2db86121404754db890f4c8dfe81b2"] = Universal + "Bloom",
        ["cdfbdbb87d3286943a057f7791b43141"] = Universal + "ChannelMixer",
        ["81180773991d8724ab7f2d216912b564"] = Universal + "ChromaticAberration",
        ["66f335fb1ffd8684294ad653bf1c7564"] = Universal + "ColorAdjustments",
        ["3eb4b772797da9440885e8bd939e9560"] = Universal + "ColorCurves",
        ["e021b4c809a781e468c2988c016ebbea"] = Universal + "ColorLookup",
        ["c01700fd266d6914ababb731e09af2eb"] = Universal + "DepthOfField",
        ["29fa0085f50d5e54f8144f766051a691"] = Universal + "FilmGrain",
        ["c5e1dc532bcb41949b58bc4f2abfbb7e"] = Universal + "LensDistortion",
        ["5485954d14dfb9a4c8ead8edb0ded5b1"] = Universal + "LiftGammaGain",
        ["ccf1aba9553839d41ae37dd52e9ebcce"] = Universal + "MotionBlur",
        ["fb60a22f311433c4c962b888d1393f88"] = Universal + "PaniniProjection",
        ["06437c1ff663d574d9447842ba0a72e4"] = Universal + "ScreenSpaceLensFlare",
        ["558a8e2b6826cf840aae193990ba9f2e"] = Universal + "ShadowsMidtonesHighlights",
        ["70afe9e12c7a7ed47911bb608a23a8ff"] = Universal + "SplitToning",
        ["97c23e3b12dc18c42a140437e53d3951"] = Universal + "Tonemapping",
        ["899c54efeace73346a0a16faa3afe726"] = Universal + "Vignette",
        ["221518ef91623a7438a71fef23660601"] = Universal + "WhiteBalance",
    };

    /// <summary>Whether a script is Unity's, and then its class where that has a stand-in; else the class's name, unless nobody needs to know.</summary>
    /// <param name="load">Finds an assembly by its name, without extension.</param>
    public static bool TryFind(string guid, Func<string, Assembly?> load, out Type? type, out string? missing)
    {
        bool isSilent = silent.TryGetValue(guid, out string? name);
        bool isKnown = isSilent || drawn.TryGetValue(guid, out name);
        type = isKnown ? assemblies.Select(a => load(a)?.GetType(name!)).FirstOrDefault(t => t is not null) : null;
        missing = isSilent || type is not null ? null : name;
        return isKnown;
    }

    /// <summary>The GUID of the script of a stand-in's class; null for other classes.</summary>
    public static string? GuidOf(Type type) =>
        assemblies.Contains(type.Assembly.GetName().Name) ? drawn.Concat(silent).FirstOrDefault(s => s.Value == type.FullName).Key : null;
}
