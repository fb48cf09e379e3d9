using NUnit.Framework;

namespace UnityEngine.TestTools;

[AttributeUsage(AttributeTargets.Method)]
public class UnitySetUpAttribute : NUnitAttribute { }
