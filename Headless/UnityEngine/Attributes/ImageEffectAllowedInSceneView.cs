using System;

namespace UnityEngine;

[AttributeUsage(AttributeTargets.Class | AttributeTargets.Method)]
public sealed class ImageEffectAllowedInSceneView : Attribute { }
