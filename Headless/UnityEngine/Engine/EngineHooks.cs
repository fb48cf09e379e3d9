using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Engine;

/// <summary>Where the other parts of the host plug in. An unset hook means the feature is absent.</summary>
static class EngineHooks
{
    /// <summary>Draws the frame: after LateUpdate, before WaitForEndOfFrame.</summary>
    public static Action? RenderFrame { get; set; }

    /// <summary>Submits and collects device work: last in the frame.</summary>
    public static Action? EndFrame { get; set; }

    /// <summary>Runs first in a frame, before any script.</summary>
    public static Action? BeginFrame { get; set; }

    /// <summary>Runs in edit mode frames: the Editor's update.</summary>
    public static Action? EditorUpdate { get; set; }

    /// <summary>Fills an empty scene from a name or path; false when there is no such scene.</summary>
    public static Func<string, SceneData, bool>? LoadScene { get; set; }

    /// <summary>Writes a scene to a path below the project; false where that is not possible.</summary>
    public static Func<SceneData, string, bool>? SaveScene { get; set; }

    /// <summary>Scene paths by build index.</summary>
    public static Func<IReadOnlyList<string>>? ScenesInBuild { get; set; }

    /// <summary>Adds MeshFilter, MeshRenderer and mesh for a primitive.</summary>
    public static Action<GameObject, PrimitiveType>? FillPrimitive { get; set; }

    public static Func<Type, string, Object?>? BuiltinResource { get; set; }
    public static Func<string, Type, Object?>? LoadResource { get; set; }
    public static Func<string, Type, Object[]>? LoadAllResources { get; set; }

    /// <summary>The AssetDatabase of the project, for the UnityEditor stand-in.</summary>
    public static IAssetDatabase? Assets { get; set; }

    /// <summary>Told that a shader is not there and that nothing can compile it: what follows would come of that alone. Null makes it a line of the console.</summary>
    public static Action<string>? CompilerMissing { get; set; }

    /// <summary>Receives every line the console shows; null writes to standard output and error.</summary>
    public static Action<LogType, string>? Console { get; set; }
}
