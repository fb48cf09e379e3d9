using UnityEngine;

namespace Headless.Engine;

/// <summary>GameObject.CreatePrimitive: mesh and renderer from the rendering part, and the collider Unity adds.</summary>
static class Primitives
{
    public static GameObject Create(PrimitiveType type)
    {
        var gameObject = new GameObject(type.ToString());
        EngineHooks.FillPrimitive?.Invoke(gameObject, type);
        switch (type)
        {
            case PrimitiveType.Sphere:
                gameObject.AddComponent<SphereCollider>();
                break;
            case PrimitiveType.Capsule:
            case PrimitiveType.Cylinder:
                gameObject.AddComponent<CapsuleCollider>().height = 2f;
                break;
            case PrimitiveType.Cube:
                gameObject.AddComponent<BoxCollider>();
                break;
            default:
                gameObject.AddComponent<MeshCollider>();
                break;
        }
        return gameObject;
    }
}
