using System;
using Headless.Engine;

namespace UnityEngine;

public partial class Object
{
    public static void Destroy(Object obj) => Destroy(obj, 0f);

    public static void Destroy(Object obj, float t)
    {
        if (!obj) return;
        if (!EngineState.IsPlaying)
        {
            Debug.LogError("Destroy may not be called from edit mode! Use DestroyImmediate instead.\n" +
                "Destroying an object in edit mode destroys it permanently.", obj);
            return;
        }
        if (obj.IsPersistent)
        {
            Debug.LogError("Destroying assets is not permitted to avoid data loss.\n" +
                "If you really want to remove an asset use DestroyImmediate (theObject, true);", obj);
            return;
        }
        if (obj is Component component && !Destruction.MayRemove(component)) return;
        Destruction.Schedule(obj, t);
    }

    public static void DestroyImmediate(Object obj) => DestroyImmediate(obj, false);

    public static void DestroyImmediate(Object obj, bool allowDestroyingAssets)
    {
        if (!obj) return;
        if (obj.IsPersistent && !allowDestroyingAssets)
        {
            Debug.LogError("Destroying assets is not permitted to avoid data loss.\n" +
                "If you really want to remove an asset use DestroyImmediate (theObject, true);", obj);
            return;
        }
        if (obj is Component component && !Destruction.MayRemove(component)) return;
        Destruction.Now(obj);
    }

    public static void DontDestroyOnLoad(Object target)
    {
        if (!target) return;
        if (!EngineState.IsPlaying)
            throw new InvalidOperationException($"The following game object is invoking the DontDestroyOnLoad method: {target.name}. Notice that DontDestroyOnLoad can only be used in play mode.");
        GameObject? gameObject = target as GameObject ?? (target as Component)?.gameObject;
        if (gameObject is null) return;
        if (gameObject.transform.parent != null)
        {
            Debug.LogWarning("DontDestroyOnLoad only works for root GameObjects or components on root GameObjects.", gameObject);
            return;
        }
        SceneTable.Move(gameObject, SceneTable.DontDestroyOnLoad);
    }
}
