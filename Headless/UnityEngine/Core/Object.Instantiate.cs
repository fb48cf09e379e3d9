using System;
using Headless.Engine;
using UnityEngine.SceneManagement;

namespace UnityEngine;

public partial class Object
{
    public static Object Instantiate(Object original) => Cloner.Clone(original, null, false, null);
    public static Object Instantiate(Object original, Transform parent) => Cloner.Clone(original, parent, false, null);
    public static Object Instantiate(Object original, Transform parent, bool instantiateInWorldSpace) => Cloner.Clone(original, parent, instantiateInWorldSpace, null);
    public static Object Instantiate(Object original, Scene scene) => Cloner.Clone(original, null, false, SceneTable.Require(scene));
    public static Object Instantiate(Object original, Vector3 position, Quaternion rotation) => Cloner.Clone(original, null, position, rotation);
    public static Object Instantiate(Object original, Vector3 position, Quaternion rotation, Transform parent) => Cloner.Clone(original, parent, position, rotation);
    public static T Instantiate<T>(T original) where T : Object => (T)Cloner.Clone(original, null, false, null);
    public static T Instantiate<T>(T original, Transform parent) where T : Object => (T)Cloner.Clone(original, parent, false, null);
    public static T Instantiate<T>(T original, Transform parent, bool worldPositionStays) where T : Object => (T)Cloner.Clone(original, parent, worldPositionStays, null);
    public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation) where T : Object => (T)Cloner.Clone(original, null, position, rotation);
    public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation, Transform parent) where T : Object => (T)Cloner.Clone(original, parent, position, rotation);
}
