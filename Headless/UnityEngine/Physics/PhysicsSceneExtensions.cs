using System;
using Headless.Engine;
using UnityEngine.SceneManagement;

namespace UnityEngine;

public static class PhysicsSceneExtensions
{
    /// <summary>Loaded scenes share the default physics scene (local physics modes are not offered); a preview scene has its own.</summary>
    public static PhysicsScene GetPhysicsScene(this Scene scene)
    {
        if (!scene.IsValid()) throw new ArgumentException("Cannot get physics scene; Unity scene is invalid.", nameof(scene));
        return SceneTable.Find(scene.handle) is { IsPreview: true } ? new PhysicsScene(scene.handle) : Physics.defaultPhysicsScene;
    }
}
