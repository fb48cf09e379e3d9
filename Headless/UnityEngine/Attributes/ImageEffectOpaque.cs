using System;

namespace UnityEngine;

[AttributeUsage(AttributeTargets.Method)]
public sealed class ImageEffectOpaque : Attribute { }
