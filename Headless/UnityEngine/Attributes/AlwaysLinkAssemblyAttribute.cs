using System;

namespace UnityEngine.Scripting;

[AttributeUsage(AttributeTargets.Assembly)]
public class AlwaysLinkAssemblyAttribute : Attribute { }
