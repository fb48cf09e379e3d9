using System.Globalization;
using System.Text;
using Headless.Engine;
using Headless.Importers.Assets;
using Headless.Importers.Serialization;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Importers.Scenes;

/// <summary>
/// Writes a scene as a .unity file that the importers, and Unity, read again: game objects, transforms, scripts and the components of
/// <see cref="ComponentWriters"/>. A component of another kind is an error, not left out.
/// </summary>
internal sealed class SceneWriter
{
    private const long FirstId = 100000;

    private readonly ProjectAssets project;
    private readonly Dictionary<Object, long> ids = new(ReferenceEqualityComparer.Instance);
    private readonly StringBuilder text = new();
    private readonly ScriptWriter scripts;

    private SceneWriter(ProjectAssets project)
    {
        this.project = project;
        scripts = new ScriptWriter(text, Reference);
    }

    /// <param name="project">The project that the scene's assets are from.</param>
    /// <param name="scene">The scene.</param>
    /// <param name="path">Its path below the project.</param>
    public static bool Save(ProjectAssets project, SceneData scene, string path)
    {
        var writer = new SceneWriter(project);
        writer.Write(scene.Scene.GetRootGameObjects());
        string file = project.Index.FileOf(path);
        Directory.CreateDirectory(Path.GetDirectoryName(file)!);
        File.WriteAllText(file, writer.text.ToString());
        scene.Path = path;
        scene.Name = Path.GetFileNameWithoutExtension(path);
        return true;
    }

    private void Write(GameObject[] roots)
    {
        List<GameObject> all = [];
        foreach (GameObject root in roots) Collect(root, all);
        text.Append("%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n");
        WriteSettings();
        foreach (GameObject item in all) WriteObject(item);
        text.Append(CultureInfo.InvariantCulture, $"--- !u!{ClassIds.SceneRoots} &9223372036854775807\nSceneRoots:\n  m_ObjectHideFlags: 0\n  m_Roots:\n");
        foreach (GameObject root in roots)
            if (ids.ContainsKey(root)) Line($"  - {Reference(root.transform)}");
    }

    private void Collect(GameObject item, List<GameObject> all)
    {
        if ((item.hideFlags & HideFlags.DontSaveInEditor) != 0) return;
        all.Add(item);
        ids[item] = FirstId + ids.Count;
        foreach (Component component in item.GetComponents<Component>()) ids[component] = FirstId + ids.Count;
        foreach (Transform child in item.transform) Collect(child.gameObject, all);
    }

    private void WriteSettings()
    {
        text.Append("--- !u!104 &2\nRenderSettings:\n  m_ObjectHideFlags: 0\n  serializedVersion: 9\n");
        Line($"  m_Fog: {(RenderSettings.fog ? 1 : 0)}");
        Line($"  m_FogColor: {YamlText.Of(RenderSettings.fogColor)}");
        Line($"  m_FogMode: {(int)RenderSettings.fogMode}");
        Line($"  m_FogDensity: {YamlText.Of(RenderSettings.fogDensity)}");
        Line($"  m_LinearFogStart: {YamlText.Of(RenderSettings.fogStartDistance)}");
        Line($"  m_LinearFogEnd: {YamlText.Of(RenderSettings.fogEndDistance)}");
        Line($"  m_AmbientSkyColor: {YamlText.Of(RenderSettings.ambientSkyColor)}");
        Line($"  m_AmbientEquatorColor: {YamlText.Of(RenderSettings.ambientEquatorColor)}");
        Line($"  m_AmbientGroundColor: {YamlText.Of(RenderSettings.ambientGroundColor)}");
        Line($"  m_AmbientIntensity: {YamlText.Of(RenderSettings.ambientIntensity)}");
        Line($"  m_AmbientMode: {(int)RenderSettings.ambientMode}");
        Line($"  m_SkyboxMaterial: {Reference(RenderSettings.skybox)}");
        Line($"  m_ReflectionIntensity: {YamlText.Of(RenderSettings.reflectionIntensity)}");
        Line($"  m_Sun: {Reference(RenderSettings.sun)}");
    }

    private void WriteObject(GameObject item)
    {
        Header(ClassIds.GameObject, item, "GameObject");
        Line($"  serializedVersion: 6");
        Line($"  m_Component:");
        Component[] components = item.GetComponents<Component>();
        foreach (Component component in components) Line($"  - component: {Reference(component)}");
        Line($"  m_Layer: {item.layer}");
        Line($"  m_Name: {YamlText.Of(item.name)}");
        Line($"  m_TagString: {YamlText.Of(item.tag)}");
        Line($"  m_IsActive: {(item.activeSelf ? 1 : 0)}");
        foreach (Component component in components) WriteComponent(component);
    }

    private void WriteComponent(Component component)
    {
        switch (component)
        {
            case Transform transform:
                WriteTransform(transform);
                break;
            case MonoBehaviour script:
                Header(ClassIds.MonoBehaviour, script, "MonoBehaviour");
                Line($"  m_GameObject: {Reference(script.gameObject)}");
                Line($"  m_Enabled: {(script.enabled ? 1 : 0)}");
                Line($"  m_EditorHideFlags: 0");
                Line($"  m_Script: {{fileID: 11500000, guid: {ScriptOf(script.GetType())}, type: 3}}");
                Line($"  m_Name: ");
                scripts.Write(script, 1);
                break;
            default:
                (int classId, IEnumerable<string> fields) = ComponentWriters.Of(component, Reference);
                Header(classId, component, component.GetType().Name);
                Line($"  m_GameObject: {Reference(component.gameObject)}");
                foreach (string field in fields) Line($"  {field}");
                break;
        }
    }

    private void WriteTransform(Transform transform)
    {
        Header(ClassIds.Transform, transform, "Transform");
        Line($"  m_GameObject: {Reference(transform.gameObject)}");
        Line($"  serializedVersion: 2");
        Line($"  m_LocalRotation: {YamlText.Of(transform.localRotation)}");
        Line($"  m_LocalPosition: {YamlText.Of(transform.localPosition)}");
        Line($"  m_LocalScale: {YamlText.Of(transform.localScale)}");
        Transform[] children = [.. transform.Cast<Transform>().Where(ids.ContainsKey)];
        Line($"  m_Children:{(children.Length == 0 ? " []" : "")}");
        foreach (Transform child in children) Line($"  - {Reference(child)}");
        Line($"  m_Father: {Reference(transform.parent)}");
    }

    private void Header(int classId, Object item, string name) =>
        text.Append(CultureInfo.InvariantCulture, $"--- !u!{classId} &{ids[item]}\n{name}:\n  m_ObjectHideFlags: {(int)item.hideFlags}\n");

    // What is not to be saved, and what is nowhere in the project, is no reference, as in Unity.
    private string Reference(Object? item)
    {
        if (!item || (item!.hideFlags & HideFlags.DontSaveInEditor) != 0) return "{fileID: 0}";
        if (ids.TryGetValue(item, out long id)) return YamlText.Invariant($"{{fileID: {id}}}");
        if (Assets.BuiltinResources.ReferenceTo(item) is { } builtin) return builtin;
        return project.ReferenceTo(item) is var (fileId, guid) ? YamlText.Invariant($"{{fileID: {fileId}, guid: {guid}, type: {(fileId == 2100000 || fileId == 11400000 ? 2 : 3)}}}") : "{fileID: 0}";
    }

    private string ScriptOf(Type type)
    {
        if (Assets.UnityScripts.GuidOf(type) is { } ofUnity) return ofUnity;
        foreach (string path in project.Index.AssetPaths.Where(p => p.EndsWith($"/{type.Name}.cs", StringComparison.Ordinal)))
            if (project.Index.GuidOf(path) is { } guid && project.Scripts.Find(guid, typeof(MonoBehaviour), path) == type) return guid;
        throw new NotSupportedException($"The scene has a component {type.FullName}, and no script asset of the project has this class; it cannot be saved.");
    }

    private void Line(FormattableString line) => text.Append(line.ToString(CultureInfo.InvariantCulture)).Append('\n');
}
