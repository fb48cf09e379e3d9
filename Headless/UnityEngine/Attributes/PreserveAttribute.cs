using System;

namespace UnityEngine.Scripting;

[AttributeUsage(AttributeTargets.All)]
public class PreserveAttribute : Attribute { }
