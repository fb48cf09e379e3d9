using System;
using UnityEngine.SceneManagement;

namespace UnityEngine;

public static class PhysicsSceneExtensions
{
    /// <summary>All scenes share the default physics scene: local physics modes are not offered.</summary>
    public static PhysicsScene GetPhysicsScene(this Scene scene)
    {
        if (!scene.IsValid()) throw new ArgumentException("Cannot get physics scene; Unity scene is invalid.", nameof(scene));
        return Physics.defaultPhysicsScene;
    }
}
